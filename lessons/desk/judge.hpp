#pragma once

#include <optional>

#include "lessons/desk/state.hpp"

namespace byhand::desk {

/// What an expression is at every state of a judge.
struct Samples {
  std::vector<Value<Tracked>> real;
  std::vector<Value<Modular>> exact;  // empty unless the expression is rational
};

struct Verdict {
  bool equal = false;
  bool exact = false;  // judged modulo a prime
  int states = 0;      // at which both sides are defined
};

/// Holds expressions against each other at random states, never by their form.
class Judge {
 public:
  explicit Judge(const Vocabulary& words);

  Samples samples(const Expression& e) const;
  /// Of dC/dt along the motion of both bodies, by dual numbers.
  Samples rates(const Expression& C) const;
  Verdict compare(const Samples& a, const Samples& b) const;
  Verdict compare(const Expression& a, const Expression& b) const { return compare(samples(a), samples(b)); }
  /// compare(e, wanted).equal, given up at the first state at which they differ.
  bool matches(const Expression& e, const Samples& wanted) const;
  /// factor with a = factor · b, if there is one number for all states.
  std::optional<double> factor(const Samples& a, const Samples& b) const;
  /// Whether a and b differ by whole turns, not always by none.
  bool differ_by_turns(const Samples& a, const Samples& b) const;

  const Vocabulary& words() const { return words_; }
  int count() const { return static_cast<int>(real_.size()); }
  const Environment<Tracked>& at(int state) const { return real_[static_cast<std::size_t>(state)]; }

 private:
  const Vocabulary& words_;
  std::vector<State<double>> states_;
  std::vector<State<Modular>> exact_states_;
  std::vector<Environment<Tracked>> real_;
  std::vector<Environment<Modular>> exact_;
};

/// Whether two values agree within the rounding errors of their making; nothing where one is not a finite number.
std::optional<bool> agree(const Value<Tracked>& a, const Value<Tracked>& b);

/// ∂C/∂(x1, θ1, x2, θ2) at a state, row by row: J by dual numbers.
std::vector<std::vector<double>> jacobian_by_duals(const Vocabulary& words, const State<double>& state,
                                                   const Expression& C);
/// The coefficients of v1, ω1, v2, ω2 in a rate that is linear in them.
std::vector<std::vector<double>> coefficients(const Vocabulary& words, const State<double>& state,
                                              const Expression& rate);
/// Rank by elimination with pivots; relative to the largest entry.
int rank(std::vector<std::vector<double>> rows);

}  // namespace byhand::desk
