#pragma once

#include <string>
#include <string_view>

#include "lessons/tutor/words.hpp"

namespace byhand::tutor {

/// Both ends belong to it.
struct Range {
  double low = 0, high = 0;
};

/// What a lesson keeps of a parameter, as a reader sees it.
struct ParameterRecord {
  std::string name, unit, meaning;
  Range range;
  double initial = 0, value = 0;
  bool integer = false;

  /// Reads "0.5", "1/120", "−3"; `value` stays as it is unless the text is a number in range.
  /// Throws std::invalid_argument with one sentence that names the text and what is allowed.
  void set(std::string_view text);
};

/// "0.5", "-2", "1/60", "1e-3", with "−" or "-". Throws std::invalid_argument unless the whole text is one
/// finite number.
double read_number(std::string_view text);

/// As a reader would type it: 0.2, 1/60, 1e-05.
std::string typed(double value);

/// A number that the reader may change between two runs of a step. Converts to T wherever one is wanted;
/// `p()` says so where a template would not.
template <class T>
class Parameter {
 public:
  explicit Parameter(const ParameterRecord& record) : record_(&record) {}
  T operator()() const { return static_cast<T>(record_->value); }
  operator T() const { return (*this)(); }
  operator Value() const { return Value(typed(record_->value), typed(record_->value)); }

 private:
  const ParameterRecord* record_;
};

}  // namespace byhand::tutor
