#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace byhand::json {

/// A value of a JSON text that knows its line.
struct Value {
  enum class Kind { nothing, truth, number, text, list, object };
  Kind kind = Kind::nothing;
  int line = 0;
  bool truth = false;
  double number = 0;
  std::string text = {};
  std::vector<Value> list = {};
  std::vector<std::pair<std::string, Value>> members = {};  // in the text's order

  const Value* find(std::string_view name) const;
  /// As an error shows it, shortened: "0.5", "\"box\"", "a list of 3".
  std::string shown() const;
};

/// Parses JSON with comments, // and /* */. Throws std::invalid_argument "line 3: …" for text that is not JSON,
/// names a member twice, is nested deeper than 16 or is longer than 10⁷ bytes.
Value parse(std::string_view text);

}  // namespace byhand::json
