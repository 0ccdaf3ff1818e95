#include "lessons/desk/judge.hpp"

#include <algorithm>
#include <cmath>

namespace byhand::desk {
namespace {

constexpr int real_states = 24, exact_states = 2;
constexpr std::uint64_t seed = 20131207;  // of the article

}  // namespace

Judge::Judge(const Vocabulary& words) : words_(words) {
  Random random(seed);
  for (int i = 0; i < real_states; ++i) states_.push_back(random_state(words, random));
  for (int i = 0; i < exact_states; ++i) exact_states_.push_back(random_state_modulo(words, random));
  for (const auto& state : states_) real_.push_back(environment<Tracked>(words, state));
  for (const auto& state : exact_states_) {
    // Names that are not rational have no value modulo a prime; expressions with them are judged by doubles.
    Environment<Modular> values(state.size());
    for (const Symbol& symbol : words.all()) {
      Value<Modular>& value = values[static_cast<std::size_t>(symbol.id)];
      value = state[static_cast<std::size_t>(symbol.id)];
      if (symbol.is == Symbol::Is::turning)
        value =
            product(values[static_cast<std::size_t>(words.at("R" + std::to_string(symbol.body + 1)).id)], value);
      if (symbol.is == Symbol::Is::defined && symbol.definition->rational)
        value = evaluate(*symbol.definition, values);
    }
    exact_.push_back(std::move(values));
  }
}

Samples Judge::samples(const Expression& e) const {
  Samples all;
  for (const auto& values : real_) all.real.push_back(evaluate(*e, values));
  if (e->rational)
    for (const auto& values : exact_) all.exact.push_back(evaluate(*e, values));
  return all;
}

Samples Judge::rates(const Expression& C) const {
  Samples all;
  const auto rate = [](const auto& value, auto result) {
    for (int i = 0; i < value.shape.size(); ++i) result[i] = value[i].rate;
    return result;
  };
  for (const auto& state : states_)
    all.real.push_back(rate(evaluate(*C, moving_environment<Tracked>(words_, state)), Value<Tracked>(C->shape)));
  const bool rational =
      C->rational && std::all_of(words_.all().begin(), words_.all().end(), [](const Symbol& symbol) {
        return symbol.is != Symbol::Is::defined || symbol.definition->rational;
      });
  if (rational)
    for (const auto& state : exact_states_)
      all.exact.push_back(
          rate(evaluate(*C, moving_environment<Modular>(words_, state)), Value<Modular>(C->shape)));
  return all;
}

std::optional<bool> agree(const Value<Tracked>& a, const Value<Tracked>& b) {
  bool all = true;
  for (int i = 0; i < a.shape.size(); ++i) {
    const double bound = 0x1p-49 * (a[i].error + b[i].error);
    if (!std::isfinite(a[i].at) || !std::isfinite(b[i].at) || !std::isfinite(bound)) return std::nullopt;
    all = all && std::fabs(a[i].at - b[i].at) <= bound;
  }
  return all;
}

Verdict Judge::compare(const Samples& a, const Samples& b) const {
  Verdict verdict;
  if (!a.real.empty() && !b.real.empty() && !(a.real[0].shape == b.real[0].shape)) return verdict;
  bool equal = true;
  for (std::size_t i = 0; i < a.real.size(); ++i)
    if (const auto same = agree(a.real[i], b.real[i])) {
      ++verdict.states;
      equal = equal && *same;
    }
  verdict.exact = !a.exact.empty() && !b.exact.empty();
  if (verdict.exact) {
    equal = true;
    for (std::size_t i = 0; i < a.exact.size(); ++i)
      for (int k = 0; k < a.exact[i].shape.size(); ++k) equal = equal && a.exact[i][k] == b.exact[i][k];
    verdict.states = std::max(verdict.states, 1);
  }
  verdict.equal = equal && verdict.states > 0;
  return verdict;
}

bool Judge::matches(const Expression& e, const Samples& wanted) const {
  if (!(e->shape == wanted.real[0].shape)) return false;
  int defined = 0;
  for (std::size_t i = 0; i < real_.size(); ++i) {
    const auto same = agree(evaluate(*e, real_[i]), wanted.real[i]);
    if (same && !*same) return false;
    defined += same.has_value();
  }
  return defined > 0;
}

std::optional<double> Judge::factor(const Samples& a, const Samples& b) const {
  std::optional<double> all;
  for (std::size_t i = 0; i < a.real.size(); ++i) {
    if (!(a.real[i].shape == b.real[i].shape)) return std::nullopt;
    if (!all) {
      int largest = 0;
      for (int k = 1; k < b.real[i].shape.size(); ++k)
        if (std::fabs(b.real[i][k].at) > std::fabs(b.real[i][largest].at)) largest = k;
      const double ratio = a.real[i][largest].at / b.real[i][largest].at;
      if (!std::isfinite(ratio)) continue;
      all = ratio;
    }
    Value<Tracked> scaled = b.real[i];
    for (int k = 0; k < scaled.shape.size(); ++k) scaled[k] = scaled[k] * Tracked(*all, 64 * std::fabs(*all));
    const auto same = agree(a.real[i], scaled);
    if (same && !*same) return std::nullopt;
  }
  return all;
}

bool Judge::differ_by_turns(const Samples& a, const Samples& b) const {
  bool some = false;
  int defined = 0;
  for (std::size_t i = 0; i < a.real.size(); ++i) {
    if (!a.real[i].shape.scalar() || !b.real[i].shape.scalar()) return false;
    const Tracked difference = a.real[i][0] - b.real[i][0];
    if (!std::isfinite(difference.at)) continue;
    ++defined;
    const double turns = std::round(difference.at / (2 * M_PI));
    if (std::fabs(difference.at - turns * 2 * M_PI) > 1e-9) return false;
    some = some || turns != 0;
  }
  return some && defined > 0;
}

std::vector<std::vector<double>> jacobian_by_duals(const Vocabulary& words, const State<double>& state,
                                                   const Expression& C) {
  const int columns = 2 * words.world().dof();
  std::vector<std::vector<double>> J(static_cast<std::size_t>(C->shape.size()),
                                     std::vector<double>(static_cast<std::size_t>(columns)));
  State<double> moving = state;
  for (int j = 0; j < columns; ++j) {
    move_along(words, moving, j);
    const auto value = evaluate(*C, moving_environment<Tracked>(words, moving));
    for (int i = 0; i < C->shape.size(); ++i)
      J[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)] = value[i].rate.at;
  }
  return J;
}

std::vector<std::vector<double>> coefficients(const Vocabulary& words, const State<double>& state,
                                              const Expression& rate) {
  const int columns = 2 * words.world().dof();
  std::vector<std::vector<double>> J(static_cast<std::size_t>(rate->shape.size()),
                                     std::vector<double>(static_cast<std::size_t>(columns)));
  State<double> moving = state;
  for (int j = 0; j < columns; ++j) {
    move_along(words, moving, j);
    const auto value = evaluate(*rate, environment<Tracked>(words, moving));
    for (int i = 0; i < rate->shape.size(); ++i)
      J[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)] = value[i].at;
  }
  return J;
}

int rank(std::vector<std::vector<double>> rows) {
  double largest = 0;
  for (const auto& row : rows)
    for (const double x : row) largest = std::max(largest, std::fabs(x));
  int found = 0;
  const std::size_t columns = rows.empty() ? 0 : rows[0].size();
  for (std::size_t column = 0; column < columns && static_cast<std::size_t>(found) < rows.size(); ++column) {
    const auto first = rows.begin() + found;
    const auto pivot = std::max_element(first, rows.end(), [&](const auto& a, const auto& b) {
      return std::fabs(a[column]) < std::fabs(b[column]);
    });
    if (!(std::fabs((*pivot)[column]) > 1e-9 * largest)) continue;
    std::swap(*first, *pivot);
    for (auto row = first + 1; row != rows.end(); ++row) {
      const double share = (*row)[column] / (*first)[column];
      for (std::size_t k = column; k < columns; ++k) (*row)[k] -= share * (*first)[k];
    }
    ++found;
  }
  return found;
}

}  // namespace byhand::desk
