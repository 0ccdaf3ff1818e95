// No grade depends on the seed: what is right is right with any, and every change of a solution is found with any
// (a quarter of the changes, but in the long run).

#include <dlfcn.h>
#include <fcntl.h>
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <regex>

#include "tests/long_run.hpp"
#include "tests/practise/learner.hpp"
#include "tests/practise/mutants.hpp"

namespace byhand::tests {
namespace {

using namespace practise;

class Seeds : public testing::TestWithParam<int> {
 protected:
  const Exercise& tried = exercise(GetParam());
};

INSTANTIATE_TEST_SUITE_P(All, Seeds, testing::Range(1, static_cast<int>(exercises().size()) + 1),
                         [](const auto& number) { return "E" + exercise(number.param).name; });

/// Far from each other, and beginning with what a course might choose.
std::vector<std::uint64_t> seeds(int count) {
  std::vector<std::uint64_t> all;
  for (int i = 0; i < count; ++i)
    all.push_back(i < 10 ? static_cast<std::uint64_t>(i) : 7919u * static_cast<unsigned>(i * i));
  return all;
}

TEST_P(Seeds, GradeNoVariantDifferently) {
  for (const std::uint64_t seed : seeds(attempts(20))) {
    const Key answers = key(tried, seed);
    for (const Variant& variant : tried.variants) {
      const Verdict verdict = judge(tried, answers, variant.code);
      const bool solution = &variant == &tried.variants.front();
      EXPECT_EQ(verdict.is_right(), solution) << variant.file << " with seed " << seed << ": " << verdict.sentence;
      if (solution) continue;
      EXPECT_EQ(verdict.sentence, first_comment(tried.folder() / variant.file)) << "with seed " << seed;
    }
  }
}

/// Mutants as one library, each in a namespace of its own.
std::string library_of(const Exercise& tried, const std::vector<Mutant>& mutants, const std::set<int>& left_out) {
  std::string text = fmt::format(
      "#include <algorithm>\n#include <cmath>\n#include \"{}/signature.hpp\"\n"
      "#include \"lessons/practise/judge/wire.hpp\"\nusing byhand::practise::Numbers, byhand::practise::answer;\n",
      tried.folder().string());
  std::string table;
  for (int i = 0; i < static_cast<int>(mutants.size()); ++i) {
    if (left_out.contains(i)) {
      table += "nullptr, ";
      continue;
    }
    text += fmt::format(
        "namespace m{0} {{\n#line 1 \"mutant{0}\"\n{1}\nNumbers run(std::size_t which, const Numbers& in) {{ "
        "return "
        "answer(which, in, FUNCTIONS); }}\n}}\n",
        i, mutants[static_cast<std::size_t>(i)].text);
    table += fmt::format("m{}::run, ", i);
  }
  return text + "extern \"C\" Numbers (*const mutants[])(std::size_t, const Numbers&) = {" + table + "};\n";
}

/// Those that the compiler names in an error.
std::set<int> named_in(const std::string& errors) {
  std::set<int> named;
  static const std::regex mutant("mutant([0-9]+):[0-9]+(:[0-9]+: error|:[0-9]+:   required from)");
  for (std::sregex_iterator at(errors.begin(), errors.end(), mutant), end; at != end; ++at)
    named.insert(std::stoi((*at)[1]));
  return named;
}

/// Whether each of `count` seeds grades code right, asked in a process of its own, which may crash or hang: that
/// is not. What such a process says is no word of this test, nor does an exception carry on with it elsewhere.
std::vector<char> in_a_process(std::size_t count, const std::function<bool(std::size_t)>& right) {
  int ends[2];
  if (pipe(ends) != 0) std::abort();
  std::fflush(nullptr);
  const pid_t child = fork();
  if (child == 0) {
    const int nothing = open("/dev/null", O_WRONLY);
    dup2(nothing, STDOUT_FILENO);
    dup2(nothing, STDERR_FILENO);
    // What never ends is ended by the processor's time, of which a seed takes less than a tenth of a second.
    const auto seconds = std::max<rlim_t>(2, count / 5);
    const rlimit limit{seconds, seconds};
    setrlimit(RLIMIT_CPU, &limit);
    try {
      for (std::size_t i = 0; i < count; ++i) {
        const char grade = right(i) ? 1 : 0;
        if (write(ends[1], &grade, 1) != 1) break;
      }
    } catch (...) {
    }
    _exit(0);
  }
  close(ends[1]);
  std::vector<char> grades;
  for (char grade = 0; read(ends[0], &grade, 1) == 1;) grades.push_back(grade);
  close(ends[0]);
  waitpid(child, nullptr, 0);
  grades.resize(count, 0);
  return grades;
}

/// Lines of tests/practise/equivalent: "exercise | before | after | why".
std::set<std::string> equivalents(const Exercise& tried) {
  std::ifstream file(BYHAND_EQUIVALENT);
  std::set<std::string> all;
  for (std::string line; std::getline(file, line);)
    if (line.starts_with(tried.name + " | ")) all.insert(line.substr(0, line.rfind(" | ")));
  return all;
}

TEST(Processes, ThatCrashOrThrowSayNothingHere) {
  testing::internal::CaptureStdout();
  testing::internal::CaptureStderr();
  const auto grades = in_a_process(4, [](std::size_t i) {
    fmt::print("Right\n");
    std::fflush(stdout);
    if (i == 2) throw std::runtime_error("thrown");
    return true;
  });
  const auto crashed = in_a_process(2, [](std::size_t i) { return i == 0 ? true : (std::abort(), true); });
  EXPECT_EQ(testing::internal::GetCapturedStdout() + testing::internal::GetCapturedStderr(), "");
  EXPECT_EQ(grades, (std::vector<char>{1, 1, 0, 0}));
  EXPECT_EQ(crashed, (std::vector<char>{1, 0}));
}

TEST_P(Seeds, FindEveryChangeOfASolution) {
  const auto mutants = mutants_of(text_of(GetParam(), "solution.cpp"));
  const Folder folder;
  std::set<int> left_out;
  for (std::size_t i = 0; i < mutants.size(); ++i)
    if (!is_drawn(i, 4)) left_out.insert(static_cast<int>(i));
  const std::string compile = fmt::format(
      "{} -std=c++20 -O1 -ffp-contract=off -fPIC -Werror=return-type -Werror=uninitialized -I{} -I{}/learner {}",
      BYHAND_TEST_COMPILER, practise_folder().parent_path().parent_path().string(), practise_folder().string(),
      (folder / "m.cpp").string());
  const std::string library = (folder / "m.so").string();
  for (bool clean = false; !clean;) {
    std::ofstream(folder / "m.cpp") << library_of(tried, mutants, left_out);
    const Finished built = run(compile + " -shared -o " + library);
    const std::set<int> named = named_in(built.complained);
    clean = built.status == 0;
    ASSERT_TRUE(clean || !named.empty()) << built.complained;
    left_out.insert(named.begin(), named.end());
  }
  void* const loaded = dlopen(library.c_str(), RTLD_NOW | RTLD_LOCAL);
  ASSERT_NE(loaded, nullptr) << dlerror();
  const auto* const codes = static_cast<Numbers (*const*)(std::size_t, const Numbers&)>(dlsym(loaded, "mutants"));

  std::vector<Key> keys;
  for (const std::uint64_t seed : seeds(attempts(5))) keys.push_back(key(tried, seed));
  const std::set<std::string> listed = equivalents(tried);
  std::set<std::string> unmade = listed;
  int made = 0, equivalent = 0;
  for (std::size_t i = 0; i < mutants.size(); ++i) {
    const std::string line = fmt::format("{} | {} | {}", tried.name, mutants[i].before, mutants[i].after);
    const bool is_listed = listed.contains(line);
    unmade.erase(line);
    if (!codes[i]) continue;
    ++made;
    const auto right =
        in_a_process(keys.size(), [&](std::size_t k) { return judge(tried, keys[k], codes[i]).is_right(); });
    const auto times = static_cast<std::size_t>(std::count(right.begin(), right.end(), 1));
    if (is_listed) {
      ++equivalent;
      EXPECT_EQ(times, keys.size()) << line << " is listed as equivalent";
    } else {
      EXPECT_EQ(times, 0U) << line << " is right with " << times << " of " << keys.size() << " seeds";
    }
  }
  for (const std::string& line : unmade) ADD_FAILURE() << line << " is listed and no mutant any more";
  fmt::print("{}: {} changes compile, {} of them equivalent, {} seeds\n", tried.name, made, equivalent,
             keys.size());
  dlclose(loaded);
}

}  // namespace
}  // namespace byhand::tests
