#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "lessons/practise/judge/wire.hpp"
#include "lessons/practise/learner/practise.hpp"

namespace byhand::practise {

/// One line of a probe's sheet: what was given, what the code answered, the two sides of a law, or
/// a number that must have a sign.
struct Line {
  enum class Kind { given, answer, law, sign } kind;
  std::string name, unit;
  Numbers values;     // of a law: left, right; of a sign: the number, 1 or -1
  double within = 0;  // how far the sides of a law may be apart; 0: by rounding alone
};

using Sheet = std::vector<Line>;

/// One experiment on an exercise's functions. Draws what it gives them at random, away from 1, 0 and symmetry,
/// unless values are set; writes down what they answer, and which laws their answers must obey.
class Probe {
 public:
  Probe(std::uint64_t seed, int index)
      : index_(index), random_(seed * 1000003 + static_cast<std::uint64_t>(index)) {}

  /// Which of `count` cases this probe is: each occurs among the probes of every seed.
  int one_of(int count) const { return index_ % count; }
  /// This size, but a hundredth on each fourth probe and 1e-5 on each eighth: a threshold in the code shows there.
  double sized(double usual) const {
    return index_ % 8 == 7 ? 1e-5 * usual : index_ % 4 == 3 ? 0.01 * usual : usual;
  }

  /// From [least, most].
  double number(const std::string& name, const std::string& unit, double least, double most);
  /// Components of either sign, up to `size`.
  Vec2 vector(const std::string& name, const std::string& unit, double size);
  BodyRow row(const std::string& name, double size = 2);
  Velocities velocities(const std::string& name, double size = 4);
  InverseMasses inverse_masses();

  /// Compared with the reference.
  template <class T>
  void answer(const std::string& name, const std::string& unit, const T& value) {
    Numbers values;
    put(values, value);
    sheet_.push_back({Line::Kind::answer, name, unit, values});
  }
  /// left = right, whatever the reference says. They may be `within` of each other where the law is not exact.
  void law(const std::string& name, const std::string& unit, double left, double right, double within = 0) {
    sheet_.push_back({Line::Kind::law, name, unit, {left, right}, within});
  }

  /// value > 0 for a side of 1, value < 0 for -1, however small it is.
  void sign(const std::string& name, const std::string& unit, double value, int side) {
    sheet_.push_back({Line::Kind::sign, name, unit, {value, static_cast<double>(side)}});
  }

  /// Values of what is given, by name, instead of random ones.
  void set(std::map<std::string, Numbers> given) { set_ = std::move(given); }
  /// Changes each given number by this share at most: how much an answer changes with its last digits.
  void jitter(double share, std::uint64_t seed) {
    share_ = share;
    shaking_.seed(seed);
  }

  const Sheet& sheet() const { return sheet_; }

 private:
  double drawn(double least, double most);
  Numbers given(const std::string& name, const std::string& unit, Numbers values);

  int index_;
  std::mt19937_64 random_, shaking_;
  double share_ = 0;
  std::map<std::string, Numbers> set_;
  Sheet sheet_;
};

}  // namespace byhand::practise
