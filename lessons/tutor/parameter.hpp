#pragma once

#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "lessons/tutor/words.hpp"

namespace byhand::tutor {

/// Both ends belong to it.
struct Range {
  double low = 0, high = 0;
};

/// What a lesson keeps of a parameter, as a reader sees it.
struct ParameterRecord {
  std::string name = {}, unit = {}, meaning = {};
  Range range = {};
  double initial = 0, value = 0;
  bool integer = false;
  std::vector<std::string> choices = {};  // if any, the values are places in this list and are typed by name
  std::string step = {};                  // the only one that looks at it; empty: any may

  /// Reads "0.5", "1/120", "−3", "200us" or the name of a choice; `value` stays as it is unless the text is a
  /// number in range or a choice. Throws std::invalid_argument with one sentence that names the text and what is
  /// allowed.
  void set(std::string_view text);

  /// A value of it as a reader would type it: "1/60", "chain".
  std::string typed(double any) const;
  /// What can be set: "0 … 3", "1 … 20, whole", "chain, stack".
  std::string allowed() const;
  /// "beta = 0.2 [1], from 0 to 3: what it means".
  std::string described(double any) const;
};

/// "0.5", "-2", "1/60", "1e-3", with "−" or "-". Throws std::invalid_argument unless the whole text is one
/// finite number.
double read_number(std::string_view text);

/// The same in `unit`, with or without a unit behind it: that one, or for s, m and kg a smaller one of its family:
/// "200us", "0.5 mm".
double read_quantity(std::string_view text, const std::string& unit);

/// As a reader would type it: 0.2, 1/60, 1e-05.
std::string typed(double value);

/// What the reader may change between two runs of a step: a number, or as Parameter<std::string> a choice.
/// Converts to T wherever one is wanted; `p()` says so where a template would not.
template <class T>
class Parameter {
 public:
  explicit Parameter(const ParameterRecord& record) : record_(&record) {}
  T operator()() const {
    if constexpr (std::is_same_v<T, std::string>)
      return record_->typed(record_->value);
    else
      return static_cast<T>(record_->value);
  }
  operator T() const { return (*this)(); }
  operator Value() const {
    if constexpr (std::is_same_v<T, std::string>)
      return Value((*this)());
    else
      return Value(typed(record_->value), typed(record_->value));
  }

 private:
  const ParameterRecord* record_;
};

}  // namespace byhand::tutor
