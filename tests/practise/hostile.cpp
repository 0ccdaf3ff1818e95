// Code that does anything but answer earns nothing, and one sentence.

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <chrono>
#include <cstdlib>

#include "lessons/practise/judge/process.hpp"
#include "tests/practise/learner.hpp"

namespace byhand::tests {
namespace {

using namespace practise;
using Kind = Verdict::Kind;
using testing::AllOf;
using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

/// Exercise 8's function with this body.
Verdict bias(const std::string& body, const std::string& before = "") {
  return verdict_on(8, "#include \"practise.hpp\"\n" + before +
                           "\ndouble bias(double C, double beta, double h) {\n" + body + "\n}\n");
}

void expect_stopped(const Verdict& verdict, const std::string& why) {
  EXPECT_EQ(verdict.kind, Kind::stopped) << verdict.sentence << verdict.details;
  EXPECT_THAT(verdict.sentence, HasSubstr(why));
  EXPECT_TRUE(verdict.sentence.ends_with('.'));
}

TEST(Hostile, AnEndlessLoopIsStopped) {
  expect_stopped(bias("for (volatile unsigned i = 0;; i = i + 1) {}"), "did not return within 2 s of computing");
}

TEST(Hostile, EachEndHasItsOwnSentence) {
  const std::string all = "#include <cassert>\n#include <cstdlib>\n#include <stdexcept>\n#include <vector>";
  expect_stopped(bias("return *(volatile double*)(std::size_t)(h * 1e9);", all),
                 "used memory that is not its own");
  expect_stopped(bias("std::abort();", all), "called abort()");
  expect_stopped(bias("assert(h > 1);\nreturn 0;", all), "Your assertion `h > 1' failed.");
  expect_stopped(bias("throw std::out_of_range(\"C\");", all), "threw an exception, 'std::out_of_range'");
  expect_stopped(bias("throw 1;", all), "threw an exception, 'int'");
  expect_stopped(bias("std::vector<double> v(1u << 28);\nreturn v[3];", all), "asked for more than 256 MB");
  expect_stopped(bias("volatile double b = 1;\nreturn bias(C + b, beta, h) + b;", all),
                 "calls itself without an end");
  expect_stopped(bias("const int none = static_cast<int>(h);\nreturn 7 / none;", all),
                 "divides a whole number by zero in line 8");
  expect_stopped(bias("const double a[3] = {};\nreturn a[static_cast<int>(h) + 5];", all),
                 "uses an index beyond the end of an array in line 8");
  expect_stopped(bias("return huge[static_cast<int>(h)];", "volatile double huge[100000000];"),
                 "global variables");
}

TEST(Hostile, WaitingEndsByTheClock) {
  const auto begun = std::chrono::steady_clock::now();
  expect_stopped(bias("int word = 0; syscall(SYS_futex, &word, FUTEX_WAIT, 0, 0, 0, 0); return 0;",
                      "#include <linux/futex.h>\n#include <sys/syscall.h>\n#include <unistd.h>"),
                 "waits for something that never comes");
  expect_stopped(bias("const timespec pause{0, 300000000};\nint word = 0; syscall(SYS_futex, &word, FUTEX_WAIT, "
                      "0, &pause, 0, 0); "
                      "return beta / h * C;",
                      "#include <linux/futex.h>\n#include <sys/syscall.h>\n#include <ctime>\n#include <unistd.h>"),
                 "waits for something that never comes");
  EXPECT_LT(std::chrono::duration<double>(std::chrono::steady_clock::now() - begun).count(), 40);
  // Nothing to read is no wait.
  EXPECT_EQ(bias("double x = 5; return std::cin >> x ? 0 : beta / h * C;", "#include <iostream>").kind,
            Kind::right);
}

/// Each nap is short, all together are not.
TEST(Hostile, NapsAddUp) {
  expect_stopped(bias("const timespec pause{0, 90000000};\nint word = 0; syscall(SYS_futex, &word, FUTEX_WAIT, 0, "
                      "&pause, 0, 0); return beta / h * C;",
                      "#include <linux/futex.h>\n#include <sys/syscall.h>\n#include <ctime>\n#include <unistd.h>"),
                 "waits for something that never comes");
}

TEST(Hostile, TheEnvironmentIsEmpty) {
  setenv("SECRET_TOKEN", "ghs_abc123", 1);
  const Verdict verdict = bias("for (char** e = environ; *e; ++e) std::puts(*e);\nreturn 0;",
                               "#include <cstdio>\n#include <unistd.h>");
  EXPECT_EQ(verdict.kind, Kind::wrong);
  EXPECT_EQ(verdict.printed, "");
  unsetenv("SECRET_TOKEN");
}

TEST(Hostile, LinksDevicesFoldersPipesAndLargeFilesAreRefusedBeforeACompilerSeesThem) {
  const Folder folder;
  const auto refused = [&](const std::filesystem::path& path) {
    const Verdict verdict = check(exercise(8), key_of(8), path);
    EXPECT_EQ(verdict.kind, Kind::does_not_compile) << path;
    EXPECT_EQ(verdict.details, "") << path;
    return verdict.sentence;
  };
  const std::string sentence = " is not a file that can be read: links, folders and devices are not judged.";
  std::filesystem::create_symlink(exercise(8).folder() / "solution.cpp", folder / "link.cpp");
  std::filesystem::create_symlink("nowhere", folder / "dangling.cpp");
  std::filesystem::create_directory(folder / "folder.cpp");
  ASSERT_EQ(mkfifo((folder / "pipe.cpp").c_str(), 0600), 0);
  for (const char* name : {"link.cpp", "dangling.cpp", "folder.cpp", "pipe.cpp", "missing.cpp"})
    EXPECT_EQ(refused(folder / name), name + sentence);
  EXPECT_EQ(refused("/dev/zero"), "zero" + sentence);
  std::ofstream(folder / "long.cpp") << std::string((64 << 10) + 1, ' ');
  EXPECT_EQ(refused(folder / "long.cpp"), "long.cpp has more than 64 KB; a solution has less than one.");
  const std::string solution = text_of(8, "solution.cpp");
  std::ofstream(folder / "full.cpp") << solution << std::string((64 << 10) - solution.size(), ' ');
  EXPECT_TRUE(check(exercise(8), key_of(8), folder / "full.cpp").is_right());
}

TEST(Hostile, EndingTheProgramEarnsNothing) {
  expect_stopped(bias("std::exit(0);", "#include <cstdlib>"), "ended the program with status 0");
  expect_stopped(bias("return 0;", "#include <cstdlib>\nstruct A { A() { std::_Exit(0); } } before_main;"),
                 "ended the program with status 0");
}

TEST(Hostile, NaNIsWrongAndSaidSo) {
  const Verdict verdict = bias("return beta / h * C * std::nan(\"\");");
  EXPECT_EQ(verdict.kind, Kind::wrong);
  EXPECT_EQ(verdict.sentence, "b is not a finite number.");
}

TEST(Hostile, PrintingIsShownAndEarnsNothing) {
  const Verdict verdict = bias("std::puts(\"score: 100\"); return 0;", "#include <cstdio>");
  EXPECT_EQ(verdict.kind, Kind::wrong);
  EXPECT_THAT(verdict.printed, StartsWith("score: 100\n"));
  expect_stopped(bias("for (int i = 0; i < 100000; ++i) std::puts(\"much\"); return 0;", "#include <cstdio>"),
                 "printed more than 64 KB");
}

TEST(Hostile, WritingOnTheJudgesChannelEarnsNothing) {
  for (const char* reply : {"1e300", "1", "-7", "0.5"})
    EXPECT_FALSE(bias(std::string("double reply[] = {") + reply +
                          ", 0}; if (write(3, reply, sizeof reply) < 0) return "
                          "1; return 0;",
                      "#include <unistd.h>")
                     .is_right())
        << reply;
}

TEST(Hostile, ForksFilesSignalsAndTheNetworkAreRefused) {
  const std::string include =
      "#include <fcntl.h>\n#include <signal.h>\n#include <sys/ptrace.h>\n#include "
      "<sys/socket.h>\n#include <sys/uio.h>\n#include <unistd.h>";
  for (const char* body : {"return fork();", "return open(\"/etc/passwd\", O_RDONLY);",
                           "return open(\"/tmp/practise_was_here\", O_CREAT | O_WRONLY, 0600);",
                           "return socket(AF_INET, SOCK_STREAM, 0);", "return kill(getppid(), SIGKILL);",
                           "return ptrace(PTRACE_ATTACH, getppid(), 0, 0);",
                           "iovec a{}; return process_vm_readv(getppid(), &a, 1, &a, 1, 0);"})
    expect_stopped(bias(body, include), "asked the system");
  EXPECT_FALSE(std::filesystem::exists("/tmp/practise_was_here"));
  // A program that it becomes keeps the limits.
  EXPECT_FALSE(
      bias("char name[] = \"/bin/sh\"; char* argv[] = {name, nullptr}; execv(name, argv); return 0;", include)
          .is_right());
}

TEST(Hostile, TheCompilerReadsNoFileOfTheJudge) {
  const std::string solution = (exercise(8).folder() / "solution.cpp").string();
  EXPECT_EQ(verdict_on(8, "#include \"" + solution + "\"\n").kind, Kind::does_not_compile);
  EXPECT_EQ(bias("return 0;", "asm(\".incbin \\\"" + solution + "\\\"\");").kind, Kind::does_not_compile);
}

TEST(Compiling, ShowsTheLearnersFirstMistakeFirst) {
  const Verdict verdict = bias("  return betta / h * C;\n  return alfa;");
  EXPECT_EQ(verdict.kind, Kind::does_not_compile);
  EXPECT_EQ(verdict.line, 4);
  EXPECT_THAT(verdict.details,
              AllOf(StartsWith("mine.cpp:4:"), HasSubstr("betta"), Not(HasSubstr("practise.hpp"))));
  EXPECT_LT(verdict.details.find("betta"), verdict.details.find("alfa"));
}

TEST(Compiling, AMistakeThatShowsInAHeaderIsShownAtTheLearnersLine) {
  const Verdict verdict = bias("return std::max(C, \"no\");", "#include <algorithm>");
  EXPECT_EQ(verdict.line, 4);
  EXPECT_THAT(verdict.details, StartsWith("mine.cpp:4:"));
  const Verdict deep = bias("std::vector<int*> v; std::sort(v.begin(), v.end(), 3); return 0;",
                            "#include <algorithm>\n#include <vector>");
  EXPECT_EQ(deep.line, 5);
  EXPECT_THAT(deep.details, StartsWith("mine.cpp:5: error"));
}

TEST(Compiling, AForgottenReturnIsAMistake) {
  const Verdict verdict = bias("double b = beta / h * C;");
  EXPECT_EQ(verdict.kind, Kind::does_not_compile);
  EXPECT_THAT(verdict.details, HasSubstr("return"));
}

TEST(Compiling, AnotherSignatureIsNamed) {
  const std::string sentence = "bias(double, double, double) is missing; keep the signature of the task.";
  EXPECT_EQ(
      verdict_on(8, "double bias(double C, double beta) { return C * beta; }\n").sentence,
      "bias(double, double, double) is missing; keep the signature of the task: your bias takes other types.");
  EXPECT_EQ(verdict_on(8, "").sentence, sentence);
  EXPECT_EQ(verdict_on(8, "float bias(double, double, double) { return 0; }\n").line, 1);
}

/// Names of any letters and any length, which a regular expression would not survive.
TEST(Compiling, AnyNameMayBeMissing) {
  const std::string missing = " is used, and nothing here defines it.";
  EXPECT_EQ(bias("return g();", "double g() asm(\"\\\"a[*\\\"\");").sentence, "a[*" + missing);
  EXPECT_EQ(bias("return g();", "double g() asm(\"" + std::string(50000, 'a') + "\");").sentence,
            std::string(200, 'a') + missing);
  EXPECT_THAT(
      bias("return 0;",
           "asm(\".macro d n, k\\n.if \\\\k\\nd \\\\n\\\\n, \\\\k-1\\n.else\\n.quad \\\\n\\n.endif\\n.endm\\n"
           ".data\\nd aaaaaaaa, 18\\n.text\");")
          .sentence,
      HasSubstr("aaaaaaaa" + missing));
}

/// What C, a variable or an assembler leaves out is no function of the task.
TEST(Compiling, OnlyAFunctionOfTheTaskIsToldToKeepItsSignature) {
  EXPECT_EQ(bias("return tick(0);", "extern \"C\" double tick(double);").sentence,
            "tick is used, and nothing here defines it.");
  EXPECT_EQ(bias("return rate * C;", "extern double rate;").sentence,
            "rate is used, and nothing here defines it.");
}

TEST(Compiling, WarningsAreReadToTheFirstMegabyte) {
  std::string warnings = "#define W0 _Pragma(\"GCC warning \\\"w\\\"\")\n";
  for (int i = 1; i <= 5; ++i) {
    warnings += fmt::format("#define W{}", i);
    for (int k = 0; k < 10; ++k) warnings += fmt::format(" W{}", i - 1);
    warnings += "\n";
  }
  const Folder folder;
  std::ofstream(folder / "w.cpp") << warnings << "W5\n";
  const practise::Finished compiled =
      run_confined({BYHAND_TEST_COMPILER, "-c", (folder / "w.cpp").string(), "-o", "/dev/null"}, {folder.path()},
                   folder.path(), {.seconds = 20, .bytes = 1u << 30});
  EXPECT_EQ(compiled.status, 0);
  EXPECT_EQ(compiled.said.size(), 1u << 20);
}

TEST(Compiling, AnOwnMainIsNotTakenForTheJudges) {
  EXPECT_EQ(bias("return 0;", "int main() {}").sentence,
            "Remove your main: the judge calls your functions from its own.");
}

TEST(Compiling, WarningsAreShownWithAWrongAnswer) {
  EXPECT_THAT(bias("double b;\nreturn b * C;").details, HasSubstr("The compiler warns\nmine.cpp:"));
  EXPECT_EQ(bias("int unused = 0;\nreturn beta / h * C;").details, "");
}

TEST(Compiling, LongLinesAreCut) {
  const Verdict verdict = bias("double x = \"a\"; // " + std::string(60000, 'y'));
  EXPECT_EQ(verdict.kind, Kind::does_not_compile);
  EXPECT_LT(verdict.details.size(), 8192U);
}

TEST(Compiling, ItsTimeIsByTheClockAndItsOutputLimited) {
  const auto begun = std::chrono::steady_clock::now();
  EXPECT_EQ(bias("return 0;", "asm(\".data\\n.fill 900000000,1,65\\n.text\");").kind, Kind::does_not_compile);
  EXPECT_LT(std::chrono::duration<double>(std::chrono::steady_clock::now() - begun).count(), 15);
}

TEST(Compiling, OneThatTakesTheMemorySaysSo) {
  std::string bomb = "#define A0 1,1,1,1,1,1,1,1\n";
  for (int i = 1; i <= 12; ++i) {
    const std::string b = "A" + std::to_string(i - 1);
    bomb += "#define A" + std::to_string(i) + " " + b;
    for (int k = 1; k < 8; ++k) bomb += "," + b;
    bomb += "\n";
  }
  const Verdict verdict = verdict_on(8, bomb + "int x[] = {A12};\n");
  EXPECT_EQ(verdict.kind, Kind::does_not_compile);
  EXPECT_THAT(verdict.sentence, HasSubstr("memory"));
}

TEST(Compiling, OneThatNeverEndsIsStopped) {
  const Verdict verdict =
      bias("return loop<1>();",
           "template <int N> constexpr double loop() { double s = 0; for (long "
           "i = 0; i < 30000000000; ++i) s += i; return s; }\nconstexpr double x = loop<2>();");
  EXPECT_EQ(verdict.kind, Kind::does_not_compile);
}

}  // namespace
}  // namespace byhand::tests
