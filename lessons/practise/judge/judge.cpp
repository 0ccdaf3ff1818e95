#include "lessons/practise/judge/judge.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "lessons/practise/judge/process.hpp"

namespace byhand::practise {
namespace {

bool near(double a, double b, double tolerance) {
  if (!std::isfinite(a) || !std::isfinite(b)) return std::isfinite(a) == std::isfinite(b);
  return std::abs(a - b) <= tolerance;
}

double largest(const Sheet& sheet) {
  double most = 0;
  for (const Line& line : sheet)
    for (const double value : line.values)
      if (std::isfinite(value)) most = std::max(most, std::abs(value));
  return most;
}

/// Two sides of a law differ by what rounding leaves of a difference quotient.
bool obeyed(const Line& law, double most) {
  const double left = law.values[0], right = law.values[1];
  return std::abs(left - right) <= 1e-8 * std::max(std::abs(left), std::abs(right)) + 1e-9 * most;
}

std::string words(const Numbers& values) {
  std::string list;
  for (const double value : values) list += fmt::format("{}{:.5g}", list.empty() ? "" : ", ", value);
  return values.size() == 1 ? list : "(" + list + ")";
}

bool right_line(const Line& line, const Line& expected, const Numbers& tolerance, double most) {
  if (line.kind == Line::Kind::law) return obeyed(line, most);
  for (std::size_t i = 0; i < line.values.size(); ++i)
    if (!std::isfinite(line.values[i]) || !near(line.values[i], expected.values[i], tolerance[i])) return false;
  return true;
}

bool right_sheet(const Sheet& sheet, const Sheet& expected, const std::vector<Numbers>& tolerance) {
  const double most = largest(expected);
  for (std::size_t i = 0; i < sheet.size(); ++i)
    if (!right_line(sheet[i], expected[i], tolerance[i], most)) return false;
  return true;
}

/// Widths by characters, not bytes.
std::string column(const std::string& text, std::size_t width) {
  const auto shown =
      static_cast<std::size_t>(std::count_if(text.begin(), text.end(), [](char c) { return (c & 0xC0) != 0x80; }));
  return text + std::string(shown < width ? width - shown : 1, ' ');
}

std::string details(const Sheet& sheet, const Sheet& expected, const std::vector<Numbers>& tolerance) {
  const double most = largest(expected);
  std::string given, answers, laws;
  for (std::size_t i = 0; i < sheet.size(); ++i) {
    const Line& line = sheet[i];
    const bool right = right_line(line, expected[i], tolerance[i], most);
    const std::string values = words(line.values);
    switch (line.kind) {
      case Line::Kind::given: given += fmt::format("  {} = {} {}\n", line.name, values, line.unit); break;
      case Line::Kind::answer:
        answers += fmt::format("  {}{}{}{}{}\n", column(line.name, 16), column(values, 34),
                               column(words(expected[i].values), 34), column(line.unit, 8), right ? "" : "✗");
        break;
      case Line::Kind::law:
        if (!right)
          laws += fmt::format("  {}: {:.5g} against {:.5g} {}\n", line.name, line.values[0], line.values[1],
                              line.unit);
    }
  }
  std::string all = "Given\n" + given;
  if (!answers.empty())
    all += "  " + column("", 16) + column("yours", 34) + column("expected", 34) + "\n" + answers;
  if (!laws.empty()) all += "Laws that your code breaks\n" + laws;
  return all;
}

std::string first_wrong(const Sheet& sheet, const Sheet& expected, const std::vector<Numbers>& tolerance) {
  const double most = largest(expected);
  for (std::size_t i = 0; i < sheet.size(); ++i)
    for (const double value : sheet[i].values)
      if (!std::isfinite(value))
        return fmt::format("{} is not a finite number.",
                           sheet[i].kind == Line::Kind::law ? "A result" : sheet[i].name);
  for (const Line& line : sheet)
    if (line.kind == Line::Kind::law && !obeyed(line, most))
      return fmt::format("Your code breaks a law: {}.", line.name);
  for (std::size_t i = 0; i < sheet.size(); ++i)
    if (!right_line(sheet[i], expected[i], tolerance[i], most)) return fmt::format("{} is wrong.", sheet[i].name);
  return "";
}

}  // namespace

Sheet sheet(const Exercise& exercise, const Code& code, std::uint64_t seed, int index) {
  Probe probe(seed, index);
  exercise.probe(probe, code);
  return probe.sheet();
}

std::vector<Numbers> tolerance(const Exercise& exercise, const Code& solution, std::uint64_t seed, int index) {
  const Sheet exact = sheet(exercise, solution, seed, index);
  const double least = 1e-12 * largest(exact);
  std::vector<Numbers> tolerance;
  for (const Line& line : exact) tolerance.emplace_back(line.values.size(), least);
  for (std::uint64_t shake = 1; shake <= 4; ++shake) {
    Probe probe(seed, index);
    probe.jitter(1e-13, shake);
    exercise.probe(probe, solution);
    for (std::size_t i = 0; i < exact.size(); ++i)
      for (std::size_t k = 0; k < exact[i].values.size(); ++k)
        tolerance[i][k] =
            std::max(tolerance[i][k], least + 10 * std::abs(probe.sheet()[i].values[k] - exact[i].values[k]));
  }
  return tolerance;
}

Key key(const Exercise& exercise, std::uint64_t seed) {
  Key key;
  key.seed = seed;
  const Code& solution = exercise.variants.front().code;
  for (int i = 0; i < probes; ++i) {
    key.right.push_back(sheet(exercise, solution, seed, i));
    key.tolerance.push_back(tolerance(exercise, solution, seed, i));
  }
  exercise.film(key.film, solution);
  for (auto mutant = exercise.variants.begin() + 1; mutant != exercise.variants.end(); ++mutant) {
    Key::Misconception wrong{first_comment(exercise.folder() / mutant->file), {}};
    for (int i = 0; i < probes; ++i) wrong.sheets.push_back(sheet(exercise, mutant->code, seed, i));
    key.misconceptions.push_back(std::move(wrong));
  }
  return key;
}

bool same_sheet(const Sheet& one, const Sheet& other, const std::vector<Numbers>& tolerance) {
  const double least = 1e-9 * std::max(largest(one), largest(other));
  for (std::size_t i = 0; i < one.size(); ++i)
    for (std::size_t k = 0; k < one[i].values.size(); ++k)
      if (!near(one[i].values[k], other[i].values[k], std::max(least, tolerance[i][k]))) return false;
  return true;
}

bool same_answers(const Sheet& one, const Sheet& other) {
  const auto kind = [](Line::Kind wanted) { return [=](const Line& line) { return line.kind == wanted; }; };
  const bool answered = std::any_of(one.begin(), one.end(), kind(Line::Kind::answer));
  const double most = std::max(largest(one), largest(other));
  for (std::size_t i = 0; i < one.size(); ++i)
    if (kind(answered ? Line::Kind::answer : Line::Kind::law)(one[i]))
      for (std::size_t k = 0; k < one[i].values.size(); ++k)
        if (!near(one[i].values[k], other[i].values[k], 1e-9 * most)) return false;
  return true;
}

Verdict judge(const Exercise& exercise, const Key& key, const Code& code) {
  Verdict verdict;
  try {
    std::vector<Sheet> sheets;
    std::size_t failed = probes;
    for (int i = 0; i < probes; ++i) {
      sheets.push_back(sheet(exercise, code, key.seed, i));
      const auto at = static_cast<std::size_t>(i);
      if (failed == probes && !right_sheet(sheets[at], key.right[at], key.tolerance[at])) failed = at;
    }
    if (failed == probes) {
      verdict.kind = Verdict::Kind::right;
      verdict.sentence = fmt::format("Right, on all {} probes (seed {}).", probes, key.seed);
    } else {
      verdict.sentence = first_wrong(sheets[failed], key.right[failed], key.tolerance[failed]);
      for (const Key::Misconception& known : key.misconceptions) {
        bool same = true;
        for (std::size_t i = 0; i < sheets.size() && same; ++i)
          same = same_sheet(sheets[i], known.sheets[i], key.tolerance[i]);
        if (!same) continue;
        verdict.kind = Verdict::Kind::misconception;
        verdict.sentence = known.sentence;
      }
      verdict.details = fmt::format("Probe {} of seed {}\n", failed + 1, key.seed) +
                        details(sheets[failed], key.right[failed], key.tolerance[failed]);
    }
    exercise.film(verdict.film, code);
  } catch (const Stopped& stopped) {
    if (verdict.sentence.empty()) {
      verdict.kind = stopped.not_written ? Verdict::Kind::not_written : Verdict::Kind::stopped;
      verdict.sentence = stopped.sentence;
    } else if (verdict.is_right()) {
      // It passed every probe, but it must also survive the picture's scene.
      verdict.kind = Verdict::Kind::stopped;
      verdict.sentence = stopped.sentence;
    }
  }
  return verdict;
}

}  // namespace byhand::practise
