#pragma once

#include <concepts>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace byhand::course {

/// A number for readers: `digits` significant digits, "−" for minus, "1.2·10⁻⁵" below 1e-4 and from 1e6 on, no
/// trailing zeros.
std::string number(double value, int digits = 4);

/// The same number for LaTeX: "-1.2\cdot 10^{-5}".
std::string latex_number(double value, int digits = 4);

template <class T>
concept Number = std::integral<T> || std::floating_point<T>;

template <class T>
concept NumberList = requires(const T& list) {
  { list[0] } -> std::convertible_to<double>;
  { list.size() } -> std::convertible_to<long>;
}
&&!std::convertible_to<T, std::string>;

/// A value that replaces an `@` in a text: a number, a list of numbers such as a vector (in brackets), or words.
class Value {
 public:
  template <Number T>
  Value(T value) : Value(static_cast<double>(value), std::integral<T> ? 15 : 4) {}
  template <NumberList T>
  Value(const T& list) : Value(numbers_of(list)) {}
  Value(std::string words) : plain_(words), latex_("\\text{" + std::move(words) + "}") {}
  Value(const char* words) : Value(std::string(words)) {}
  Value(double value, int digits);
  Value(std::string plain, std::string latex) : plain_(std::move(plain)), latex_(std::move(latex)) {}
  Value(const std::vector<double>& list);

  const std::string& plain() const { return plain_; }
  const std::string& latex() const { return latex_; }

 private:
  template <NumberList T>
  static std::vector<double> numbers_of(const T& list) {
    std::vector<double> numbers;
    for (long i = 0; i < static_cast<long>(list.size()); ++i) numbers.push_back(static_cast<double>(list[i]));
    return numbers;
  }

  std::string plain_, latex_;
};

/// A formula in Unicode for the terminal and in LaTeX, without dollar signs, for the page.
struct Formula {
  std::string plain, latex;
};

/// "1 box", "2 boxes"; without `many`, "3 links" from "link".
std::string several(long n, std::string_view one, std::string_view many = {});

/// Replaces each `@` by the next value. Throws LessonError unless there are as many values as marks.
std::string fill(std::string_view words, const std::vector<Value>& values);
Formula fill(std::string_view plain, std::string_view latex, const std::vector<Value>& values);

/// The lines of a text, without their ends. They last as long as it.
std::vector<std::string_view> lines_of(std::string_view text);

/// Prose as a source has it, R"(...)" over several lines, with one line for each paragraph: a line break becomes a
/// blank, and indentation goes. Blank lines part paragraphs; a line that begins with "- " stays a line of its own.
std::string unwrapped(std::string_view source);

/// `say("@ links weigh @ N", n, weight)`
template <class... T>
std::string say(std::string_view words, const T&... values) {
  return fill(words, {Value(values)...});
}

}  // namespace byhand::course
