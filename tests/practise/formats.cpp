// What a course's platforms get.

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <linux/filter.h>
#include <linux/seccomp.h>
#include <sys/prctl.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <bit>
#include <cctype>
#include <nlohmann/json.hpp>
#include <regex>
#include <set>

#include "lessons/page/error.hpp"
#include "lessons/practise/judge/submission.hpp"
#include "tests/practise/learner.hpp"

namespace byhand::tests {
namespace {

using namespace practise;
using Json = nlohmann::json;
using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

void put(const std::filesystem::path& file, const std::string& text) {
  std::filesystem::create_directories(file.parent_path());
  std::ofstream(file) << text;
}

/// Exercise 8 right, 4 a misconception, 3 does not compile, all others missing.
void submit(const Folder& folder) {
  put(folder / "08_bias.cpp", text_of(8, "solution.cpp"));
  put(folder / "04_impulse.cpp", text_of(4, "mutants/no_minus.cpp"));
  put(folder / "03_inverse_effective_mass.cpp", "#include \"practise.hpp\"\n\nint & < broken;\n");
}

struct Graded4 {
  Folder folder;
  int status = -1;
  Json gradescope, classroom50, prairielearn;
  std::string junit, github;

  explicit Graded4(const std::string& program) {
    submit(folder);
    const auto out = [&](const char* name) { return (folder / name).string(); };
    const Finished finished = run(fmt::format(
        "{} --report gradescope={} --report classroom50={} --report prairielearn={} --report junit={} "
        "--report github=-",
        fmt::format(fmt::runtime(program), folder.path().string()), out("g"), out("c"), out("p"), out("j")));
    status = finished.status;
    github = finished.said;
    gradescope = Json::parse(contents(folder / "g"));
    classroom50 = Json::parse(contents(folder / "c"));
    prairielearn = Json::parse(contents(folder / "p"));
    junit = contents(folder / "j");
  }
};

const Graded4& here() {
  static const Graded4 graded(std::string(BYHAND_PRACTISE) + " --grade {} --seed 5");
  return graded;
}

TEST(Formats, OfOneRunAgree) {
  EXPECT_EQ(here().status, 1);
  const std::size_t count = exercises().size();
  ASSERT_EQ(here().gradescope["tests"].size(), count);
  ASSERT_EQ(here().classroom50["tests"].size(), count);
  ASSERT_EQ(here().prairielearn["tests"].size(), count);
  int right = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const Json &g = here().gradescope["tests"][i], &c = here().classroom50["tests"][i],
               &p = here().prairielearn["tests"][i];
    const bool passed = g["status"] == "passed";
    right += passed;
    EXPECT_EQ(passed, i + 1 == 8);
    EXPECT_EQ(g["name"], c["test-name"]);
    EXPECT_EQ(g["name"], p["name"]);
    EXPECT_EQ(g["score"], c["score"]);
    EXPECT_EQ(g["score"], p["points"]);
    EXPECT_EQ(c["passed"], passed);
    EXPECT_EQ(c["message"], p["message"]);
  }
  EXPECT_EQ(here().gradescope["score"], right);
  EXPECT_EQ(here().classroom50["score"], right);
  EXPECT_DOUBLE_EQ(here().prairielearn["score"], double(right) / double(count));
  EXPECT_THAT(here().junit, HasSubstr("tests=\"12\" failures=\"11\" errors=\"0\" skipped=\"0\""));
}

TEST(Formats, Classroom50HasItsKeysAndIntegers) {
  const Json& result = here().classroom50;
  EXPECT_EQ(result["schema"], "classroom50/result/v1");
  for (const char* key : {"classroom", "assignment", "submission", "commit", "release", "review", "datetime"}) {
    ASSERT_TRUE(result[key].is_string()) << key;
    EXPECT_FALSE(result[key].get<std::string>().empty()) << key;
  }
  EXPECT_TRUE(result["score"].is_number_integer());
  EXPECT_TRUE(result["max-score"].is_number_integer());
  for (const Json& test : result["tests"]) EXPECT_TRUE(test["max-score"].is_number_integer());
}

TEST(Formats, PrairieLearnNamesWhatDoesNotCompile) {
  const Json& results = here().prairielearn;
  EXPECT_EQ(results["gradable"], true)
      << "one exercise is right, so the one that does not compile costs only itself";
  EXPECT_EQ(results["format_errors"].size(), 1U);
  EXPECT_THAT(results["format_errors"][0], HasSubstr("03_inverse_effective_mass.cpp:3:"));
  EXPECT_LE(contents(here().folder / "p").size(), 1000000U);
  const Json& image = results["tests"][3]["images"][0];
  EXPECT_THAT(image["url"].get<std::string>(), testing::StartsWith("data:image/png;base64,iVBORw0KGgo"));
}

TEST(Formats, JUnitIsXmlWithTheSentences) {
  EXPECT_THAT(here().junit, HasSubstr("<failure message=\"Without the minus, your impulse doubles"));
  EXPECT_THAT(here().junit, AllOf(HasSubstr("int &amp; &lt; broken"), Not(HasSubstr("int & <"))));
  if (run("xmllint --version").status != 0) GTEST_SKIP() << "xmllint is not installed";
  const Finished checked = run("xmllint --noout " + (here().folder / "j").string());
  EXPECT_EQ(checked.status, 0) << checked.complained;
}

TEST(Formats, GitHubMarksTheLine) {
  EXPECT_THAT(here().github,
              HasSubstr("::error file=03_inverse_effective_mass.cpp,line=3,title=3. Inverse effective "
                        "mass::It does not compile.%0A"));
  EXPECT_THAT(here().github,
              HasSubstr("::error file=04_impulse.cpp,line=1,title=4. The impulse λ::Without the minus"));
  EXPECT_EQ(std::count(here().github.begin(), here().github.end(), '\n'), 11);
}

/// Latin-1, halves of characters, escape codes, U+FFFE, and lines without an end.
TEST(Formats, AreWellFormedForAnyBytes) {
  const Folder folder;
  const std::string code =
      "double bias(double C, double beta, double h) { return beta * C / h }  // gr\xf6\xdf"
      "er \xe2\x82 \x1b[31m \xef\xbf\xbe ";
  put(folder / "08_bias.cpp", code + std::string(60000, 'y') + "\n");
  put(folder / "04_impulse.cpp",
      "#include \"practise.hpp\"\n#include <cstdio>\ndouble lambda(const BodyRow&, const Velocities&, double, "
      "double) "
      "{ std::fputs(\"\\xf6\\x01\\x1b]0;x\\x07&<\\xed\\xa0\\x80\", stdout); return 0; }\n");
  const auto out = [&](const char* name) { return (folder / name).string(); };
  const Finished finished =
      run(fmt::format("{} --grade {} --report gradescope={} --report classroom50={} --report prairielearn={} "
                      "--report junit={} --report github=-",
                      BYHAND_PRACTISE, folder.path().string(), out("g"), out("c"), out("p"), out("j")));
  EXPECT_EQ(finished.status, 1) << finished.complained;
  for (const char* name : {"g", "c", "p"}) EXPECT_FALSE(Json::parse(contents(folder / name)).is_null()) << name;
  EXPECT_LE(contents(folder / "p").size(), 1000000U);
  EXPECT_EQ(Json::parse(contents(folder / "p"))["gradable"], true) << "exercise 4 runs";
  EXPECT_THAT(contents(folder / "j"), AllOf(HasSubstr("gr??er ?"), Not(HasSubstr("\x1b"))));
  EXPECT_THAT(finished.said, Not(HasSubstr("\x1b")));
  if (run("xmllint --version").status != 0) GTEST_SKIP() << "xmllint is not installed";
  const Finished checked = run("xmllint --noout " + out("j"));
  EXPECT_EQ(checked.status, 0) << checked.complained;
}

/// What a learner names and prints is neither markup nor turns a line round.
TEST(Formats, TakeNoMarkupFromALearner) {
  const Folder folder;
  put(folder / "08_bias.cpp",
      "#include <cassert>\n#include <cstdio>\ndouble bias(double, double, double) {\n"
      "  std::puts(\"\\u202eright\\u2066\");\n  bool link = false;\n"
      "  assert((link, \"<img src=x>|[a](http://x)\", false));\n  return 0;\n}\n");
  const auto out = [&](const char* name) { return (folder / name).string(); };
  run(fmt::format("{} 8 --grade {} --report gradescope={} --report summary={}", BYHAND_PRACTISE,
                  folder.path().string(), out("g"), out("s")));
  EXPECT_THAT(contents(folder / "g"), AllOf(HasSubstr("printed:\\nright"), HasSubstr("Your assertion `")));
  EXPECT_THAT(contents(folder / "s"),
              AllOf(HasSubstr("\\<img src=x\\>\\|\\[a\\](http"), Not(HasSubstr("\u202e"))));
}

TEST(Formats, TellNeitherTheSeedNorARightAnswer) {
  const Folder folder;
  put(folder / "08_bias.cpp",
      "double bias(double C, double beta, double h) { return beta * C + 0 * h + 1e-3; }\n");
  const std::string report = (folder / "g").string();
  run(fmt::format("{} 8 --grade {} --seed 424243 --report gradescope={}", BYHAND_PRACTISE, folder.path().string(),
                  report));
  const std::string text = contents(report);
  EXPECT_THAT(text, AllOf(HasSubstr("yours"), HasSubstr("C = "), Not(HasSubstr("expected")),
                          Not(HasSubstr("424243")), Not(HasSubstr("seed")), Not(HasSubstr(" against "))));
  for (const Sheet& sheet : key(exercise(8), 424243).right)
    for (const Line& line : sheet)
      if (line.kind == Line::Kind::answer) {
        EXPECT_THAT(text, Not(HasSubstr(fmt::format("{:.4g}", line.values[0]))));
      }
}

TEST(Formats, WrongFoldersAreErrors) {
  const Folder folder;
  std::filesystem::create_directory(folder / "keys");
  const auto grade = [&](const std::string& keys, const std::string& submission) {
    return run(fmt::format("{} --keys {} --submission {}", BYHAND_GRADE, keys, submission));
  };
  EXPECT_EQ(grade("/nonexistent", folder.path().string()).status, 2);
  EXPECT_THAT(grade((folder / "keys").string(), folder.path().string()).complained, HasSubstr("holds no key"));
  put(folder / "keys" / "08_bias.json", to_json(key_of(8)));
  const Finished none = grade((folder / "keys").string(), "/nonexistent");
  EXPECT_EQ(none.status, 2);
  EXPECT_THAT(none.complained, HasSubstr("/nonexistent is not a folder of submitted files"));
  EXPECT_EQ(run(std::string(BYHAND_GRADE) + " --help").status, 0);
}

/// Answers Landlock's calls as an older kernel does, here and in what is started from here.
void forget_landlock() {
  sock_filter program[] = {BPF_STMT(BPF_LD | BPF_W | BPF_ABS, offsetof(seccomp_data, nr)),
                           BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, SYS_landlock_create_ruleset, 0, 1),
                           BPF_STMT(BPF_RET | BPF_K, SECCOMP_RET_ERRNO | ENOSYS),
                           BPF_STMT(BPF_RET | BPF_K, SECCOMP_RET_ALLOW)};
  const sock_fprog filter{4, program};
  prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0);
  prctl(PR_SET_SECCOMP, SECCOMP_MODE_FILTER, &filter);
}

TEST(Formats, WithoutLandlockNothingIsGradedUnlessAsked) {
  const Folder folder;
  put(folder / "keys" / "08_bias.json", to_json(key_of(8)));
  put(folder / "mine" / "08_bias.cpp", text_of(8, "solution.cpp"));
  const auto grade = [&](const char* option) {
    const pid_t child = fork();
    if (child == 0) {
      forget_landlock();
      const Finished finished = run(fmt::format("{} --keys {} --submission {} --report junit={} {}", BYHAND_GRADE,
                                                (folder / "keys").string(), (folder / "mine").string(),
                                                (folder / "j").string(), option));
      _exit(finished.complained.find("has no Landlock") == std::string::npos ? 100 : finished.status);
    }
    int status = 0;
    waitpid(child, &status, 0);
    return WEXITSTATUS(status);
  };
  EXPECT_EQ(grade(""), 4);
  EXPECT_FALSE(std::filesystem::exists(folder / "j"));
  EXPECT_EQ(grade("--unconfined"), 0);
  EXPECT_THAT(contents(folder / "j"), HasSubstr("failures=\"0\""));
}

TEST(Keys, OfAnotherJudgeAreRefused) {
  Key key = key_of(8);
  key.right[3][0].values[0] += 1e-9;
  EXPECT_THROW((void)judge(exercise(8), key, exercise(8).variants[0].code), course::EnvironmentError);
}

/// What probes give follows from the seed alone, whatever compiler has built this: draws in a stated order.
TEST(Keys, GiveTheSameNumbersWithEveryCompiler) {
  std::uint64_t hash = 14695981039346656037u;
  for (const Exercise& tried : exercises())
    for (int index = 0; index < probes; ++index)
      for (const Line& line : sheet(tried, tried.variants.front().code, 7, index))
        if (line.kind == Line::Kind::given)
          for (const double value : line.values)
            hash = (hash ^ std::bit_cast<std::uint64_t>(value)) * 1099511628211u;
  EXPECT_EQ(hash, 3425755630313647233u);
}

TEST(Formats, AnUnknownReportIsRefused) {
  const Finished finished = run(std::string(BYHAND_PRACTISE) + " --grade . --report csv=x");
  EXPECT_EQ(finished.status, 2);
  EXPECT_THAT(finished.complained,
              HasSubstr("FORMAT of classroom50, github, gradescope, junit, prairielearn, summary"));
}

TEST(Keys, AsJsonJudgeTheSame) {
  for (const Exercise& tried : exercises()) {
    const Key key = key_of(tried.number()), read = key_from_json(to_json(key));
    EXPECT_EQ(to_json(read), to_json(key));
    for (const Variant& variant : tried.variants)
      EXPECT_EQ(judge(tried, read, variant.code).sentence, judge(tried, key, variant.code).sentence)
          << variant.file;
  }
}

/// A course's judge, exported with seed 5: it grades as this program does with that seed.
class Course : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    folder_ = new Folder;
    exported_ = run(fmt::format("{} --export gradescope --to {} --seed 5", BYHAND_PRACTISE, course().string()));
  }
  static void TearDownTestSuite() { delete folder_; }
  static std::filesystem::path course() { return *folder_ / "course"; }

  static inline Folder* folder_ = nullptr;
  static inline Finished exported_{};
};

TEST_F(Course, HoldsNoSolution) {
  EXPECT_EQ(exported_.status, 0) << exported_.complained;
  std::string all;
  for (const auto& file : std::filesystem::recursive_directory_iterator(course())) {
    const std::string name = file.path().string();
    EXPECT_THAT(name, AllOf(Not(HasSubstr("solution")), Not(HasSubstr("mutants")), Not(HasSubstr(".git"))));
    if (file.is_regular_file() && file.path().filename() == "task.md") all += contents(file.path());
  }
  EXPECT_THAT(all, AllOf(HasSubstr("# The impulse λ"), Not(HasSubstr("## "))));
  EXPECT_TRUE(std::filesystem::exists(course() / "autograder.zip"));
  EXPECT_EQ(
      std::filesystem::status(course() / "run_autograder").permissions() & std::filesystem::perms::owner_exec,
      std::filesystem::perms::owner_exec);
}

/// A text's tokens, a blank after each: numbers, signs and names of functions as they are, any other name, with
/// its members, as x. Without comments, types and std::.
std::string tokens_of(const std::string& code) {
  const auto in_name = [](char c) { return std::isalnum(static_cast<unsigned char>(c)) || c == '_' || c == '.'; };
  std::string all;
  for (std::size_t i = 0; i < code.size();) {
    std::size_t end = i + 1;
    if (code[i] == '#' || code.compare(i, 2, "//") == 0) {
      i = std::min(code.find('\n', i), code.size());
    } else if (in_name(code[i])) {
      while (end < code.size() && in_name(code[end])) ++end;
      const std::string name = code.substr(i, end - i);
      const bool number = std::isdigit(static_cast<unsigned char>(name[0]));
      const bool called = end < code.size() && code[end] == '(';
      if (name == "std")
        end += 2;
      else if (name != "const" && name != "double")
        all += number || called || name == "return" ? name + " " : "x ";
      i = end;
    } else {
      if (!std::isspace(static_cast<unsigned char>(code[i]))) all += std::string{code[i], ' '};
      i = end;
    }
  }
  return all;
}

/// The right sides and returned values of a solution that are more than a few tokens long. Not C of a rod, which
/// the tasks print.
std::vector<std::string> expressions_of(const std::string& solution) {
  const std::string tokens = tokens_of(solution);
  std::vector<std::string> all;
  for (const std::string begin : {"= ", "return "})
    for (std::size_t at = tokens.find(begin); at != std::string::npos; at = tokens.find(begin, at + 1)) {
      const std::size_t from = at + begin.size();
      const std::string one = tokens.substr(from, tokens.find_first_of(";=", from) - from);
      if (std::count(one.begin(), one.end(), ' ') >= 8 && one != "( dot ( x , x ) - x * x ) / 2 ")
        all.push_back(one);
    }
  return all;
}

TEST_F(Course, HoldsNoFormulaOfASolution) {
  std::map<std::string, std::string> exported;
  for (const auto& file : std::filesystem::recursive_directory_iterator(course() / "source" / "lessons"))
    if (file.is_regular_file()) exported[file.path().string()] = tokens_of(contents(file.path()));
  std::size_t searched = 0;
  for (const Exercise& each : exercises()) {
    const std::vector<std::string> formulas = expressions_of(text_of(each.number(), "solution.cpp"));
    for (const std::string& formula : formulas)
      for (const auto& [file, tokens] : exported)
        EXPECT_EQ(tokens.find(formula), std::string::npos) << file << " has " << formula << " of " << each.name;
    searched += formulas.size();
  }
  EXPECT_GE(searched, 10U);
  // What is looked for is found in the solutions themselves.
  EXPECT_NE(tokens_of("double f() { return -(dot(row.J, V) + row.b) / row.K; }")
                .find(expressions_of(text_of(4, "solution.cpp")).at(0)),
            std::string::npos);
}

TEST_F(Course, OfTheSameSeedIsTheSameBytes) {
  const Folder folder;
  const auto again = folder / "it's another folder";
  EXPECT_EQ(
      run(fmt::format("{} --export gradescope --to \"{}\" --seed 5", BYHAND_PRACTISE, again.string())).status, 0);
  std::size_t files = 0;
  for (const auto& file : std::filesystem::recursive_directory_iterator(course()))
    if (file.is_regular_file()) {
      ++files;
      EXPECT_EQ(contents(again / file.path().lexically_relative(course())), contents(file.path())) << file.path();
    }
  EXPECT_GT(files, 50U);
}

/// As in the image that a platform builds from the folder, but that the packages are there.
TEST_F(Course, BuildsItsJudgeFromTheExportedFolderAlone) {
  const std::string build = (*folder_ / "built").string(), source = (course() / "source").string();
  const Finished configured =
      run(fmt::format("cmake -G Ninja -S {} -B {} -DCMAKE_BUILD_TYPE=None", source, build));
  ASSERT_EQ(configured.status, 0) << configured.complained;
  const Finished built = run(fmt::format("cmake --build {} --target grade", build));
  ASSERT_EQ(built.status, 0) << built.said << built.complained;
  const Graded4 there(
      fmt::format("{}/lessons/grade --keys {} --submission {{}}", build, (course() / "keys").string()));
  EXPECT_EQ(there.status, 0) << "grading ran";
  EXPECT_EQ(there.gradescope, here().gradescope);
}

TEST_F(Course, GradesByKeysAsThisProgramDoes) {
  const Graded4 there(fmt::format("{} --keys {} --submission {{}}", BYHAND_GRADE, (course() / "keys").string()));
  EXPECT_EQ(there.status, 0) << "grading ran";
  EXPECT_EQ(there.gradescope, here().gradescope);
  EXPECT_EQ(there.prairielearn, here().prairielearn);
  const auto without_times = [](const std::string& report) {
    return std::regex_replace(report, std::regex(" time=\"[0-9.]*\""), "");
  };
  EXPECT_EQ(without_times(there.junit), without_times(here().junit));
}

TEST_F(Course, ResultsExistEvenIfTheJudgeIsKilled) {
  const Folder submission;
  put(submission / "01_rod_between_particles.cpp",
      "#include \"practise.hpp\"\ndouble value(Vec2, Vec2, double) { for (volatile unsigned i = 0;; i = i + 1) {} "
      "}\n"
      "ParticleRow jacobian(Vec2, Vec2, double) { return {}; }\n");
  const std::string results = (submission / "results.json").string();
  run(fmt::format("timeout -s KILL 1.5 {} --keys {} --submission {} --report gradescope={}", BYHAND_GRADE,
                  (course() / "keys").string(), submission.path().string(), results));
  EXPECT_THAT(Json::parse(contents(results))["tests"][0]["output"], HasSubstr("The judge did not finish."));
}

TEST_F(Course, IsExportedOnlyIntoAnEmptyFolder) {
  EXPECT_EQ(run(fmt::format("{} --export junit --to {}", BYHAND_PRACTISE, course().string())).status, 2);
  EXPECT_EQ(
      run(fmt::format("{} --export blackboard --to {}/new", BYHAND_PRACTISE, folder_->path().string())).status, 2);
  EXPECT_EQ(run(std::string(BYHAND_PRACTISE) + " --export junit").status, 2);
}

TEST(Courses, OthersGetTheirStarters) {
  const Folder folder;
  for (const auto& [kind, file] : {std::pair{"junit", "grade.sh"},
                                   {"classroom50", "autograder.py"},
                                   {"prairielearn", "question/info.json"}}) {
    const auto to = folder / kind;
    EXPECT_EQ(run(fmt::format("{} 8 --export {} --to {}", BYHAND_PRACTISE, kind, to.string())).status, 0);
    EXPECT_TRUE(std::filesystem::exists(to / file)) << kind;
    EXPECT_TRUE(std::filesystem::exists(to / "Dockerfile")) << kind;
    EXPECT_THAT(contents(to / "README.md"), AllOf(HasSubstr("# Exercises in "), HasSubstr("## Its limits")));
    EXPECT_EQ(contents(to / "handout/08_bias/08_bias.cpp"), text_of(8, "stub.cpp"));
    EXPECT_THAT(contents(to / "handout/08_bias/task.md"),
                AllOf(HasSubstr("(21) the rate with a bias: lesson 4, step 2"), HasSubstr("Vec2 {x, y}"),
                      Not(HasSubstr("Hint"))));
    EXPECT_EQ(std::distance(std::filesystem::directory_iterator(to / "keys"), {}), 1) << "exercise 8 alone";
  }
}

/// Two questions of one PrairieLearn course may not share it; one that is exported again keeps its own.
TEST(Courses, HaveAUuidOfTheirExercisesAndSeed) {
  const Folder folder;
  int exported = 0;
  const auto uuid = [&](const std::string& what) {
    const auto to = folder / std::to_string(++exported);
    EXPECT_EQ(run(fmt::format("{} {} --export prairielearn --to {}", BYHAND_PRACTISE, what, to.string())).status,
              0);
    return Json::parse(contents(to / "question/info.json"))["uuid"].get<std::string>();
  };
  const std::string one = uuid("8 --seed 5");
  EXPECT_THAT(one, testing::MatchesRegex("[0-9a-f]{8}-[0-9a-f]{4}-4[0-9a-f]{3}-[89ab][0-9a-f]{3}-[0-9a-f]{12}"));
  EXPECT_EQ(uuid("8 --seed 5"), one);
  const std::set<std::string> all{one, uuid("8 --seed 77"), uuid("9 --seed 5"), uuid("8"), uuid("8")};
  EXPECT_EQ(all.size(), 5U) << "without --seed one is drawn";
}

}  // namespace
}  // namespace byhand::tests
