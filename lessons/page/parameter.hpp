#pragma once

#include <atomic>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "lessons/page/words.hpp"

namespace byhand::course {

/// A closed interval.
struct Range {
  double low = 0, high = 0;
};

/// A parameter of a lesson: its description and its present value.
struct ParameterRecord {
  std::string name = {}, unit = {}, meaning = {};
  Range range = {};
  double initial = 0, value = 0;
  bool integer = false;
  std::vector<std::string> choices = {};  // if any, the value is an index into this list; a reader types the name
  std::string step = {};                  // label of the only step that depends on it; empty: any may
  mutable bool was_read = false;          // whether a step has read the value since this was set to false

  /// The value for a step, which may ask from several threads.
  double read_value() const {
    std::atomic_ref(was_read).store(true, std::memory_order_relaxed);
    return value;
  }

  /// Sets the value from "0.5", "1/120", "−3", "200us" or the name of a choice. Otherwise throws
  /// std::invalid_argument with one sentence that names the text and the allowed values, and leaves the value
  /// unchanged.
  void set(std::string_view text);

  /// The value `any` as a reader would type it: "1/60", "chain".
  std::string typed(double any) const;
  /// The allowed values: "0 … 3", "1 … 20, whole", "chain, stack".
  std::string allowed() const;
  /// "beta = 0.2 [1], from 0 to 3: what it means".
  std::string described(double any) const;
};

/// The number as a reader would type it: 0.2, 1/60, 1e-05.
std::string typed(double value);

/// A handle for the present value of a parameter: a number, or the name of a choice as Parameter<std::string>.
/// Converts to T; write `p()` where a template needs the value.
template <class T>
class Parameter {
 public:
  explicit Parameter(const ParameterRecord& record) : record_(&record) {}
  T operator()() const {
    if constexpr (std::is_same_v<T, std::string>)
      return record_->typed(record_->read_value());
    else
      return static_cast<T>(record_->read_value());
  }
  operator T() const { return (*this)(); }
  operator Value() const {
    if constexpr (std::is_same_v<T, std::string>)
      return Value((*this)());
    else
      return Value(typed(record_->read_value()), typed(record_->value));
  }

 private:
  const ParameterRecord* record_;
};

}  // namespace byhand::course
