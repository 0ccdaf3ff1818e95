#include "lessons/scene_file/value.hpp"

#include <iterator>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "solver/support/require.hpp"

namespace byhand::json {
namespace {

constexpr std::size_t deepest = 16, longest = 10'000'000, most_shown = 40;

[[noreturn]] void refuse_at(int line, const std::string& sentence) {
  throw std::invalid_argument("line " + std::to_string(line) + ": " + sentence);
}

/// A text's bytes, counting the lines of what was read. The lexer reads one byte beyond a number, which may be the
/// end of the line: only bytes that are not blank set the line of a value.
class Counted {
 public:
  using iterator_category = std::input_iterator_tag;
  using value_type = char;
  using difference_type = std::ptrdiff_t;
  using pointer = const char*;
  using reference = const char&;

  Counted(const char* at, int* line) : at_(at), line_(line) {}
  const char& operator*() const { return *at_; }
  Counted& operator++() {
    if (*at_ == '\n') ++here_;
    if (static_cast<unsigned char>(*at_) > ' ') *line_ = here_;
    ++at_;
    return *this;
  }
  Counted operator++(int) {
    Counted before = *this;
    ++*this;
    return before;
  }
  bool operator==(const Counted& other) const { return at_ == other.at_; }
  bool operator!=(const Counted& other) const { return at_ != other.at_; }

 private:
  const char* at_;
  int* line_;
  int here_ = 1;
};

/// Builds the values as the parser comes to them.
struct Builder : nlohmann::json_sax<nlohmann::json> {
  const int* line;
  Value root;
  std::vector<Value*> open;  // objects and lists around the next value
  std::string name;          // of the next member

  explicit Builder(const int* line_) : line(line_) {}

  Value& add(Value::Kind kind) {
    Value* value = &root;
    if (!open.empty() && open.back()->kind == Value::Kind::object)
      value = &open.back()->members.emplace_back(name, Value{}).second;
    else if (!open.empty())
      value = &open.back()->list.emplace_back();
    value->kind = kind;
    value->line = *line;
    return *value;
  }
  bool begin(Value::Kind kind) {
    if (open.size() == deepest) refuse_at(*line, "lists and objects are nested more than 16 deep");
    open.push_back(&add(kind));
    return true;
  }
  bool end() {
    open.pop_back();
    return true;
  }

  bool null() override { return add(Value::Kind::nothing), true; }
  bool boolean(bool truth) override { return add(Value::Kind::truth).truth = truth, true; }
  bool number_integer(number_integer_t number) override { return number_float(static_cast<double>(number), ""); }
  bool number_unsigned(number_unsigned_t number) override { return number_float(static_cast<double>(number), ""); }
  bool number_float(number_float_t number, const string_t&) override {
    return add(Value::Kind::number).number = number, true;
  }
  bool string(string_t& text) override { return add(Value::Kind::text).text = text, true; }
  bool binary(binary_t&) override { return false; }
  bool start_object(std::size_t) override { return begin(Value::Kind::object); }
  bool key(string_t& key) override {
    if (open.back()->find(key)) refuse_at(*line, "\"" + key.substr(0, most_shown) + "\" is there twice");
    name = key;
    return true;
  }
  bool end_object() override { return end(); }
  bool start_array(std::size_t) override { return begin(Value::Kind::list); }
  bool end_array() override { return end(); }
  bool parse_error(std::size_t, const std::string& token, const nlohmann::json::exception& error) override {
    // Of "[json.exception.parse_error.101] parse error at line 1, column 2: syntax error while …" the end.
    const std::string words = error.what();
    const std::size_t colon = words.find(": ");
    (void)token;
    refuse_at(*line, "this is not JSON: " + (colon == std::string::npos ? words : words.substr(colon + 2)));
  }
};

}  // namespace

const Value* Value::find(std::string_view name) const {
  for (const auto& [known, value] : members)
    if (known == name) return &value;
  return nullptr;
}

std::string Value::shown() const {
  switch (kind) {
    case Kind::nothing: return "null";
    case Kind::truth: return truth ? "true" : "false";
    case Kind::number: return text_of(number);
    case Kind::text: return "\"" + (text.size() > most_shown ? text.substr(0, most_shown) + "…" : text) + "\"";
    case Kind::list: return "a list of " + std::to_string(list.size());
    case Kind::object: return "an object";
  }
  return "";
}

Value parse(std::string_view text) {
  if (text.size() > longest) refuse_at(1, "the file is longer than 10 million bytes");
  int line = 1;
  Builder builder(&line);
  nlohmann::json::sax_parse(Counted(text.data(), &line), Counted(text.data() + text.size(), &line), &builder,
                            nlohmann::json::input_format_t::json, true, true);
  return std::move(builder.root);
}

}  // namespace byhand::json
