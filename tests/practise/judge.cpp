// What every folder of lessons/practise has to keep.

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>

#include "tests/practise/learner.hpp"

namespace byhand::tests {
namespace {

using namespace practise;
using Kind = Verdict::Kind;

class Exercises : public testing::TestWithParam<int> {
 protected:
  const Exercise& tried = exercise(GetParam());
};

INSTANTIATE_TEST_SUITE_P(All, Exercises, testing::Range(1, static_cast<int>(exercises().size()) + 1),
                         [](const auto& number) { return "E" + exercise(number.param).name; });

TEST_P(Exercises, SolutionPassesWithAnySeed) {
  for (const std::uint64_t seed : {1, 2, 3, 1000003, 77}) {
    const Verdict verdict = judge(tried, key(tried, seed), tried.variants.front().code);
    EXPECT_EQ(verdict.kind, Kind::right) << verdict.sentence << verdict.details;
  }
}

TEST_P(Exercises, SolutionPassesAsALearnersFile) {
  const Verdict verdict = verdict_on(GetParam(), text_of(GetParam(), "solution.cpp"));
  EXPECT_EQ(verdict.kind, Kind::right) << verdict.sentence << verdict.details;
  EXPECT_EQ(verdict.film.frames.size(), key_of(GetParam()).film.frames.size());
}

TEST_P(Exercises, StubCompilesAndSaysThatItIsNotWritten) {
  const Verdict verdict = verdict_on(GetParam(), text_of(GetParam(), "stub.cpp"));
  EXPECT_EQ(verdict.kind, Kind::not_written);
  const bool several = tried.functions.find(',') != std::string::npos;
  EXPECT_EQ(verdict.sentence + verdict.details + verdict.printed,
            several ? tried.function(0) + " is not written yet." : "Not written yet.");
}

TEST_P(Exercises, EachMutantGetsItsSentence) {
  for (const std::uint64_t seed : {1, 2, 3}) {
    const Key answers = key(tried, seed);
    for (auto mutant = tried.variants.begin() + 1; mutant != tried.variants.end(); ++mutant) {
      const Verdict verdict = judge(tried, answers, mutant->code);
      EXPECT_EQ(verdict.kind, Kind::misconception) << mutant->file;
      EXPECT_EQ(verdict.sentence, first_comment(tried.folder() / mutant->file)) << mutant->file;
    }
  }
}

TEST_P(Exercises, AMutantGetsItsSentenceAsALearnersFile) {
  const Variant& mutant = tried.variants.back();
  EXPECT_EQ(verdict_on(GetParam(), text_of(GetParam(), mutant.file)).sentence,
            first_comment(tried.folder() / mutant.file));
}

TEST_P(Exercises, SentencesDifferAndEndAsSentences) {
  std::set<std::string> sentences;
  for (auto mutant = tried.variants.begin() + 1; mutant != tried.variants.end(); ++mutant) {
    const std::string sentence = first_comment(tried.folder() / mutant->file);
    EXPECT_TRUE(sentences.insert(sentence).second) << mutant->file;
    EXPECT_TRUE(sentence.ends_with('.')) << mutant->file;
  }
  EXPECT_GE(sentences.size(), 4U);
}

/// Metres become millimetres and kilograms tonnes: the factor of a unit such as "kg m²".
double factor(std::string unit) {
  double factor = 1;
  if (unit.starts_with("kg")) factor /= 1000, unit.erase(0, 2);
  if (unit.starts_with(" ")) unit.erase(0, 1);
  if (unit.starts_with("m²")) return factor * 1e6;
  return unit.starts_with("m") ? factor * 1e3 : factor;
}

using Given = std::map<std::string, Numbers>;

Given in_other_units(const Sheet& sheet) {
  Given given;
  for (const Line& line : sheet)
    if (line.kind == Line::Kind::given)
      for (const double value : line.values) given[line.name].push_back(value * factor(line.unit));
  return given;
}

Given with_bodies_swapped(const Sheet& sheet) {
  Given given;
  for (const Line& line : sheet) {
    if (line.kind != Line::Kind::given) continue;
    std::string name = line.name;
    for (char& c : name) c = c == '1' ? '2' : c == '2' ? '1' : c;
    const auto other = std::find_if(sheet.begin(), sheet.end(), [&](const Line& l) { return l.name == name; });
    given[line.name] = other == sheet.end() ? line.values : other->values;
  }
  return given;
}

Sheet sheet_on(const Exercise& tried, const Code& code, const Given& given, int index = 0) {
  Probe probe(1, index);
  probe.set(given);
  tried.probe(probe, code);
  return probe.sheet();
}

std::vector<Numbers> rounding(const Sheet& sheet) {
  std::vector<Numbers> tolerance;
  for (const Line& line : sheet) {
    tolerance.emplace_back();
    for (const double value : line.values) tolerance.back().push_back(1e-9 * std::abs(value));
  }
  return tolerance;
}

TEST_P(Exercises, ProbesTellAllPairsApartAlsoInOtherUnitsAndWithBodiesSwapped) {
  const auto& variants = tried.variants;
  for (const auto& change : {+[](const Sheet&) { return Given{}; }, in_other_units, with_bodies_swapped})
    for (std::size_t i = 0; i < variants.size(); ++i)
      for (std::size_t j = 0; j < i; ++j) {
        bool apart = false;
        for (int index = 0; index < probes && !apart; ++index) {
          const Sheet plain = sheet(tried, variants[0].code, 5, index);
          Given given = change(plain);
          if (given.empty())
            for (const Line& line : plain)
              if (line.kind == Line::Kind::given) given[line.name] = line.values;
          const Sheet one = sheet_on(tried, variants[i].code, given, index),
                      two = sheet_on(tried, variants[j].code, given, index);
          apart = !same_sheet(one, two, rounding(sheet_on(tried, variants[0].code, given, index)));
        }
        if (change == in_other_units && variants[i].file == "mutants/slop.cpp")
          continue;  // a threshold has a unit
        EXPECT_TRUE(apart) << variants[i].file << " and " << variants[j].file;
      }
}

TEST_P(Exercises, ProbesAvoidOneAndSymmetry) {
  for (int index = 0; index < probes; ++index) {
    std::set<double> sizes;
    for (const Line& line : sheet(tried, tried.variants.front().code, 9, index))
      if (line.kind == Line::Kind::given)
        for (const double value : line.values) {
          EXPECT_GT(std::abs(value), 0) << line.name;
          EXPECT_GE(std::abs(std::abs(value) - 1), 0.05) << line.name;
          EXPECT_TRUE(sizes.insert(std::abs(value)).second) << line.name;
        }
  }
}

TEST_P(Exercises, TaskFitsOneScreenWithHintsByDegrees) {
  const Task about = task(tried);
  EXPECT_EQ(about.hints.size(), 3U);
  EXPECT_FALSE(about.derivation.empty());
  EXPECT_LE(std::count(about.statement.begin(), about.statement.end(), '\n'), 12);
}

TEST_P(Exercises, MutantToUnmaskPassesItsBlindTestAndFailsOthers) {
  const Task about = task(tried);
  const auto mutant = std::find_if(tried.variants.begin(), tried.variants.end(),
                                   [&](const Variant& v) { return v.file == "mutants/" + about.mutant; });
  ASSERT_NE(mutant, tried.variants.end());
  const Code& solution = tried.variants.front().code;
  const Sheet right = sheet_on(tried, solution, about.blind);
  EXPECT_TRUE(same_answers(sheet_on(tried, mutant->code, about.blind), right));
  EXPECT_FALSE(same_answers(sheet_on(tried, mutant->code, {}), sheet_on(tried, solution, {})));
}

}  // namespace
}  // namespace byhand::tests
