#pragma once

#include <algorithm>
#include <numbers>
#include <optional>
#include <stdexcept>

#include "lessons/scene_file/members.hpp"
#include "lessons/scene_file/value.hpp"

// The members of one object of a file, each held to what is allowed.
namespace byhand::scene_file {

using json::Value;
using Kind = Value::Kind;

/// An error whose place in the file is told.
struct Located : std::invalid_argument {
  using std::invalid_argument::invalid_argument;
};

/// Reads the members of one object, and refuses those that nothing has asked for.
class Reader {
 public:
  Reader(const Value& object, std::string path) : object_(object), path_(std::move(path)) {
    if (object.kind != Kind::object) refuse(object, path_.empty() ? "the file" : path_, "an object { … }");
  }
  std::string path(const std::string& member) const { return path_.empty() ? member : path_ + "." + member; }

  [[noreturn]] static void refuse(const Value& value, const std::string& path, const std::string& allowed) {
    fail(value.line, path + " is " + value.shown() + ", but it must be " + allowed);
  }
  [[noreturn]] static void fail(int line, const std::string& sentence) {
    throw Located("line " + std::to_string(line) + ": " + sentence);
  }
  [[noreturn]] void lacks(const std::string& name, const std::string& allowed) const {
    fail(object_.line,
         (path_.empty() ? "the file" : path_) + " has no member \"" + name + "\", which must be " + allowed);
  }

  const Value* find(const std::string& name) {
    known_.push_back(name);
    return object_.find(name);
  }
  void done() const {
    for (const auto& [name, value] : object_.members) {
      if (std::find(known_.begin(), known_.end(), name) != known_.end()) continue;
      std::string all;
      for (const std::string& known : known_) all += (all.empty() ? "" : ", ") + known;
      fail(value.line, (path_.empty() ? "the file" : path_) + " has a member \"" + name.substr(0, 40) +
                           "\", but its members are " + all);
    }
  }

  std::string text(const std::string& name) {
    const Value* value = find(name);
    if (!value) return {};
    if (value->kind != Kind::text) refuse(*value, path(name), "a text");
    return value->text;
  }
  void flag(const std::string& name, const char*, bool& flag, bool otherwise) {
    const Value* value = find(name);
    if (value && value->kind != Kind::truth) refuse(*value, path(name), "true or false");
    flag = value ? value->truth : otherwise;
  }
  void number(const Number& member, double& number) {
    const Value* value = find(member.name);
    if (value)
      number = number_in(*value, path(member.name), member);
    else if (member.otherwise)
      number = *member.otherwise;
    else
      lacks(member.name, allowed(member));
  }
  void whole(const Number& member, int& number) {
    double read = 0;
    this->number(member, read);
    if (read != static_cast<int>(read)) refuse(*object_.find(member.name), path(member.name), "a whole number");
    number = static_cast<int>(read);
  }
  /// The index of a name in a list.
  int index(const std::string& name, const std::vector<std::string>& names, int otherwise) {
    const Value* value = find(name);
    if (!value) return otherwise;
    const auto found = std::find(names.begin(), names.end(), value->text);
    if (value->kind != Kind::text || found == names.end()) {
      std::string all;
      for (const std::string& one : names) all += (all.empty() ? "\"" : ", \"") + one + "\"";
      refuse(*value, path(name), "one of " + all);
    }
    return static_cast<int>(found - names.begin());
  }
  template <class Enum>
  void name(const std::string& name, const char*, Enum& value, const std::vector<std::string>& names) {
    value = static_cast<Enum>(index(name, names, 0));
  }
  template <class... Choices>
  void one_of(const std::string& name, const char*, std::variant<Choices...>& choice,
              const std::array<const char*, sizeof...(Choices)>& names, int otherwise) {
    const int chosen = index(name, {names.begin(), names.end()}, otherwise);
    int i = 0;
    ((chosen == i++ ? void(choice.template emplace<Choices>()) : void()), ...);
    std::visit([&](auto& one) { members(*this, one); }, choice);
  }
  /// Fills `numbers` from a list of as many. Returns whether it is there.
  template <class Numbers>
  bool list(const std::string& name, Numbers&& numbers, const Number& each = {"", "", ""}) {
    const Value* value = find(name);
    if (value) fill(*value, path(name), numbers, each);
    return value != nullptr;
  }
  template <class Numbers>
  static void fill(const Value& value, const std::string& path, Numbers&& numbers,
                   const Number& each = {"", "", ""}) {
    const auto count = static_cast<std::size_t>(numbers.size());
    if (value.kind != Kind::list || value.list.size() != count)
      refuse(value, path, "a list of " + std::to_string(count) + " numbers");
    for (std::size_t i = 0; i < count; ++i)
      numbers[static_cast<Eigen::Index>(i)] = number_in(value.list[i], path + "[" + std::to_string(i) + "]", each);
  }

  int line() const { return object_.line; }

 protected:
  static std::string allowed(const Number& member) {
    std::string words = "a finite number";
    if (std::isfinite(member.low))
      words += std::string(member.above_low ? " above " : " of at least ") + text_of(member.low);
    if (member.high < 1e300)
      words += (std::isfinite(member.low) ? " and at most " : " of at most ") + text_of(member.high);
    if (member.may_be_infinite) words += ", or \"infinite\"";
    if (member.angle) words += ", or an angle like \"30°\"";
    if (*member.unit) words += std::string(" [") + member.unit + "]";
    return words;
  }
  /// 30 of "30°"; what stands before the sign is a number as JSON has it.
  static std::optional<double> degrees_in(std::string_view text) {
    constexpr std::string_view sign = "°";
    if (!text.ends_with(sign)) return std::nullopt;
    try {
      const Value number = json::parse(text.substr(0, text.size() - sign.size()));
      return number.kind == Kind::number ? std::optional(number.number) : std::nullopt;
    } catch (const std::invalid_argument&) {
      return std::nullopt;
    }
  }
  static double number_in(const Value& value, const std::string& path, const Number& member) {
    double number = value.number;
    if (value.kind == Kind::text && member.may_be_infinite && value.text == "infinite") return endless;
    if (value.kind == Kind::text && member.angle) {
      const std::optional<double> degrees = degrees_in(value.text);
      if (!degrees) refuse(value, path, allowed(member));
      number = *degrees / 180 * std::numbers::pi;
    } else if (value.kind != Kind::number) {
      refuse(value, path, allowed(member));
    }
    const bool fits = std::isfinite(number) && number <= member.high &&
                      (member.above_low ? number > member.low : number >= member.low);
    if (!fits) refuse(value, path, allowed(member));
    return number;
  }

  const Value& object_;
  std::string path_;
  std::vector<std::string> known_;
};

/// Calls the library, whose refusals get the place in the file.
template <class F>
auto at(int line, const std::string& path, F&& call) {
  try {
    return call();
  } catch (const Located&) {
    throw;
  } catch (const std::invalid_argument& bad) {
    Reader::fail(line, path + ": " + bad.what());
  }
}

}  // namespace byhand::scene_file
