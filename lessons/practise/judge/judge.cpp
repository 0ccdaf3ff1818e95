#include "lessons/practise/judge/judge.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "lessons/page/error.hpp"
#include "lessons/practise/judge/stopped.hpp"

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

/// Two sides of a law differ by what rounding leaves of a difference quotient, if the law says no more.
bool obeyed(const Line& law, double most) {
  const double left = law.values[0], right = law.values[1];
  const double rounding = 1e-8 * std::max(std::abs(left), std::abs(right)) + 1e-9 * most;
  return std::abs(left - right) <= (law.within > 0 ? law.within : rounding);
}

std::string words(const Numbers& values, int digits = 5) {
  std::string list;
  for (const double value : values) list += fmt::format("{}{:.{}g}", list.empty() ? "" : ", ", value, digits);
  return values.size() == 1 ? list : "(" + list + ")";
}

/// Both in words, with as many digits as it takes to tell them apart.
std::pair<std::string, std::string> told_apart(const Numbers& one, const Numbers& other) {
  int digits = 5;
  while (digits < 17 && words(one, digits) == words(other, digits)) ++digits;
  return {words(one, digits), words(other, digits)};
}

bool finite(const Line& line) {
  return std::all_of(line.values.begin(), line.values.end(), [](double value) { return std::isfinite(value); });
}

bool right_line(const Line& line, const Line& expected, const Numbers& tolerance, double most) {
  if (!finite(line)) return false;
  if (line.kind == Line::Kind::law) return obeyed(line, most);
  if (line.kind == Line::Kind::sign) return line.values[0] * line.values[1] > 0;
  for (std::size_t i = 0; i < line.values.size(); ++i)
    if (!near(line.values[i], expected.values[i], tolerance[i])) return false;
  return true;
}

/// What code answered on one probe beside what is right. The sheet may be cut short.
struct Compared {
  const Sheet& sheet;
  const Sheet& expected;
  const std::vector<Numbers>& tolerance;
  double most = largest(expected);

  bool right(std::size_t i) const { return right_line(sheet[i], expected[i], tolerance[i], most); }
  bool right() const {
    for (std::size_t i = 0; i < sheet.size(); ++i)
      if (!right(i)) return false;
    return true;
  }
};

/// Widths by characters, not bytes.
std::string column(const std::string& text, std::size_t width) {
  const auto shown =
      static_cast<std::size_t>(std::count_if(text.begin(), text.end(), [](char c) { return (c & 0xC0) != 0x80; }));
  return text + std::string(shown < width ? width - shown : 1, ' ');
}

std::string details(const Compared& probe, bool secret) {
  std::string given, answers, laws;
  for (std::size_t i = 0; i < probe.sheet.size(); ++i) {
    const Line& line = probe.sheet[i];
    const bool right = probe.right(i);
    switch (line.kind) {
      case Line::Kind::given:
        given += fmt::format("  {} = {} {}\n", line.name, words(line.values), line.unit);
        break;
      case Line::Kind::answer: {
        const Numbers& expected = probe.expected[i].values;
        const auto [yours, wanted] =
            right || secret ? std::pair(words(line.values), words(expected)) : told_apart(line.values, expected);
        answers += "  " + column(line.name, 16) + column(yours, 34) + (secret ? "" : column(wanted, 34)) +
                   column(line.unit, 8) + (right ? "" : "✗") + "\n";
        break;
      }
      case Line::Kind::law:
        if (right) break;
        laws += "  " + line.name;
        if (!secret) {
          const auto [left, other] = told_apart({line.values[0]}, {line.values[1]});
          laws += fmt::format(": {} against {} {}", left, other, line.unit);
        }
        laws += "\n";
        break;
      case Line::Kind::sign:
        if (!right) laws += fmt::format("  {}; yours is {:.5g} {}\n", line.name, line.values[0], line.unit);
    }
  }
  std::string all = "Given\n" + given;
  if (!answers.empty())
    all += "  " + column("", 16) + column("yours", 34) + (secret ? "" : column("expected", 34)) + "\n" + answers;
  if (!laws.empty()) all += "Laws that your code breaks\n" + laws;
  return all;
}

std::string first_wrong(const Compared& probe) {
  for (const Line& line : probe.sheet)
    if (!finite(line))
      return fmt::format("{} is not a finite number.", line.kind == Line::Kind::answer ? line.name : "A result");
  for (std::size_t i = 0; i < probe.sheet.size(); ++i)
    if (probe.sheet[i].kind != Line::Kind::answer && !probe.right(i))
      return fmt::format("Your code breaks a law: {}.", probe.sheet[i].name);
  for (std::size_t i = 0; i < probe.sheet.size(); ++i)
    if (!probe.right(i)) return fmt::format("{} is wrong.", probe.sheet[i].name);
  return "";
}

bool only_last_digits_differ(const Compared& probe) {
  for (std::size_t i = 0; i < probe.sheet.size(); ++i)
    for (std::size_t k = 0; k < probe.sheet[i].values.size(); ++k) {
      const double expected = probe.expected[i].values[k];
      if (probe.sheet[i].kind == Line::Kind::answer &&
          !near(probe.sheet[i].values[k], expected, 1e-5 * std::max(std::abs(expected), 1e-2 * probe.most)))
        return false;
    }
  return true;
}

/// By what an answer is too large on every probe, or 0.
double common_factor(const std::vector<Sheet>& sheets, const std::vector<Sheet>& right, std::size_t line) {
  double factor = 0;
  for (std::size_t i = 0; i < sheets.size(); ++i) {
    if (line >= sheets[i].size() || sheets[i][line].name != sheets[0][line].name) return 0;
    for (std::size_t k = 0; k < sheets[i][line].values.size(); ++k) {
      const double ratio = sheets[i][line].values[k] / right[i][line].values[k];
      if (factor == 0) factor = ratio;
      if (!(std::abs(ratio - factor) <= 1e-9 * std::abs(factor))) return 0;
    }
  }
  return factor;
}

/// Where the wrong answers are multiples of the right ones, the same on every probe, says so.
std::string multiples(const Compared& probe, const std::vector<Sheet>& sheets, const std::vector<Sheet>& right) {
  std::string all;
  for (std::size_t i = 0; i < probe.sheet.size(); ++i) {
    if (probe.sheet[i].kind != Line::Kind::answer || probe.right(i)) continue;
    const double factor = common_factor(sheets, right, i);
    if (factor == 0) return "";
    all += (all.empty() ? "" : ", and ") +
           (factor == -1 ? probe.sheet[i].name + " has the wrong sign"
                         : fmt::format("{} is {:.6g} times what is right", probe.sheet[i].name, factor));
  }
  return all.empty() ? "" : all + ", on every probe.";
}

/// Of each number of a frame, its largest size in the film.
Numbers sizes(const Film& film) {
  Numbers most;
  for (const Frame& frame : film.frames) {
    const Numbers numbers = numbers_of(frame);
    most.resize(std::max(most.size(), numbers.size()), 1e-3);
    for (std::size_t i = 0; i < numbers.size(); ++i) most[i] = std::max(most[i], std::abs(numbers[i]));
  }
  return most;
}

/// How far two frames differ, as a share of each number's size.
double difference(const Frame& one, const Frame& other, const Numbers& sizes) {
  const Numbers a = numbers_of(one), b = numbers_of(other);
  double most = 0;
  for (std::size_t i = 0; i < b.size(); ++i) {
    const double apart = i < a.size() ? std::abs(a[i] - b[i]) / sizes[i] : 1;
    most = std::isfinite(apart) ? std::max(most, apart) : std::numeric_limits<double>::infinity();
  }
  return most;
}

}  // namespace

std::vector<double> film_tolerance(const Exercise& exercise, const Code& code, const Film& film) {
  const Numbers size = sizes(film);
  std::vector<double> tolerance(film.frames.size(), 1e-6);
  for (std::uint64_t shake = 1; shake <= 4; ++shake) {
    std::mt19937_64 random(shake);
    Film shaken;
    exercise.film(shaken, [&](std::size_t which, const Numbers& arguments) {
      Numbers answered = code(which, arguments);
      for (double& value : answered)
        value *= 1 + 1e-13 * (2 * (static_cast<double>(random() >> 11) * 0x1p-53) - 1);
      return answered;
    });
    for (std::size_t i = 0; i < std::min(film.frames.size(), shaken.frames.size()); ++i)
      tolerance[i] = std::max(tolerance[i], 100 * difference(shaken.frames[i], film.frames[i], size));
  }
  return tolerance;
}

namespace {

/// The laws of an exercise without answers leave several codes right, so that only where the film ends counts:
/// within a hundredth.
bool answers_are_compared(const Key& key) {
  return std::any_of(key.right[0].begin(), key.right[0].end(),
                     [](const Line& line) { return line.kind == Line::Kind::answer; });
}

std::string wrong_film(const Film& film, const Key& key) {
  const auto& right = key.film.frames;
  const Numbers size = sizes(key.film);
  const bool all = answers_are_compared(key);
  for (std::size_t i = all ? 0 : right.size() - 1; i < right.size(); ++i) {
    const double apart = all ? difference(film.frames[i], right[i], size)
                             : std::abs(film.frames[i].reading - right[i].reading) / size[0];
    if (apart <= (all ? key.film_tolerance[i] : 0.01)) continue;
    const auto [yours, wanted] = told_apart({film.frames[i].reading}, {right[i].reading});
    return fmt::format(
        "Right on all {} probes, but the film takes another course: after {:.2f} s the {} is {} {}, and {} {} is "
        "right. "
        "Does an answer depend on more than the arguments?",
        probes, static_cast<double>(i) / frames_per_second, key.film.quantity, yours, key.film.unit, wanted,
        key.film.unit);
  }
  return "";
}

/// What is given on a probe follows from the seed alone, so a key of other probes is no key to these.
void require_same_probe(const Sheet& sheet, const Sheet& right, const std::string& exercise) {
  bool same = sheet.size() <= right.size();
  for (std::size_t i = 0; same && i < sheet.size(); ++i)
    same = sheet[i].name == right[i].name &&
           (sheet[i].kind != Line::Kind::given || sheet[i].values == right[i].values);
  if (!same)
    throw course::EnvironmentError(fmt::format(
        "The key of {} was made by another judge: its probes are not these. Export the course again", exercise));
}

}  // namespace

Numbers numbers_of(const Frame& frame) {
  Numbers all{frame.reading};
  for (const Shape& shape : frame.shapes)
    all.insert(all.end(), {shape.at.x, shape.at.y, shape.to.x, shape.to.y, shape.angle});
  return all;
}

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
  key.film_tolerance = film_tolerance(exercise, solution, key.film);
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

namespace {

/// The verdict of code that ended in its first probe, or in the film after all probes.
Verdict stopped_by(const Stopped& stopped, const Exercise& exercise, const Key& key, std::size_t which,
                   const std::vector<Sheet>& sheets) {
  Verdict verdict;
  verdict.kind = stopped.not_written ? Verdict::Kind::not_written : Verdict::Kind::stopped;
  verdict.sentence = stopped.sentence;
  if (!stopped.not_written) return verdict;
  if (exercise.functions.find(',') != std::string::npos)
    verdict.sentence = exercise.function(which) + " is not written yet.";
  if (which == 0 || sheets.size() != 1) return verdict;
  const std::string wrong = first_wrong({sheets[0], key.right[0], key.tolerance[0]});
  const bool answered = std::any_of(sheets[0].begin(), sheets[0].end(),
                                    [](const Line& line) { return line.kind != Line::Kind::given; });
  if (!wrong.empty())
    verdict.sentence += " " + wrong;
  else if (answered)
    verdict.sentence += " " + exercise.function(0) + " is right on the first probe.";
  return verdict;
}

}  // namespace

Verdict judge(const Exercise& exercise, const Key& key, const Code& code) {
  Verdict verdict;
  std::vector<Sheet> sheets;
  std::size_t called = 0;
  const Code watched = [&](std::size_t which, const Numbers& arguments) {
    called = which;
    return code(which, arguments);
  };
  try {
    std::size_t failed = probes;
    for (std::size_t i = 0; i < probes; ++i) {
      Probe probe(key.seed, static_cast<int>(i));
      const auto keep = [&] {
        sheets.push_back(probe.sheet());
        require_same_probe(sheets[i], key.right[i], exercise.name);
      };
      try {
        exercise.probe(probe, watched);
      } catch (const Stopped&) {
        keep();
        throw;
      }
      keep();
      if (failed == probes && !Compared{sheets[i], key.right[i], key.tolerance[i]}.right()) failed = i;
    }
    if (failed == probes) {
      verdict.kind = Verdict::Kind::right;
      verdict.sentence = fmt::format("Right, on all {} probes.", probes);
    } else {
      const Compared probe{sheets[failed], key.right[failed], key.tolerance[failed]};
      verdict.sentence = first_wrong(probe);
      const std::string factors = key.secret ? "" : multiples(probe, sheets, key.right);
      if (!factors.empty()) verdict.sentence = factors;
      if (answers_are_compared(key) && only_last_digits_differ(probe))
        verdict.sentence = "Only the last digits differ: is there a float where a double belongs?";
      for (const Key::Misconception& known : key.misconceptions) {
        bool same = true;
        for (std::size_t i = 0; i < sheets.size() && same; ++i)
          same = same_sheet(sheets[i], known.sheets[i], key.tolerance[i]);
        if (!same) continue;
        verdict.kind = Verdict::Kind::misconception;
        verdict.sentence = known.sentence;
      }
      verdict.details = fmt::format("Probe {} of {}\n", failed + 1, probes) + details(probe, key.secret);
    }
    exercise.film(verdict.film, watched);
    if (const std::string wrong = verdict.is_right() ? wrong_film(verdict.film, key) : ""; !wrong.empty()) {
      verdict.kind = Verdict::Kind::wrong;
      verdict.sentence = wrong;
    }
  } catch (const Stopped& stopped) {
    // It may have passed every probe, but it must also survive the film.
    if (verdict.sentence.empty() || verdict.is_right()) {
      Film film = std::move(verdict.film);
      verdict = stopped_by(stopped, exercise, key, called, sheets);
      verdict.film = std::move(film);
    }
  }
  return verdict;
}

}  // namespace byhand::practise
