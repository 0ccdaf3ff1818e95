// Code that does anything but answer earns nothing, and one sentence.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

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
  expect_stopped(bias("for (volatile int i = 0;; i = i + 1) {}"), "did not return within 2 s of computing");
}

TEST(Hostile, ACrashIsNamed) {
  expect_stopped(bias("return *(volatile double*)nullptr;"), "crashed");
  expect_stopped(bias("std::abort();", "#include <cstdlib>"), "crashed");
  expect_stopped(bias("throw 1;"), "crashed");
}

TEST(Hostile, EndingTheProgramEarnsNothing) {
  expect_stopped(bias("std::exit(0);", "#include <cstdlib>"), "ended the program with status 0");
  expect_stopped(bias("return 0;", "#include <cstdlib>\nstruct A { A() { std::_Exit(0); } } before_main;"),
                 "ended the program with status 0");
}

TEST(Hostile, MemoryIsLimited) {
  expect_stopped(bias("double sum = 0; for (int i = 0; i < 400; ++i) { char* p = new char[1 << 20]; "
                      "for (int k = 0; k < 1 << 20; k += 4096) p[k] = 1; sum += p[4096]; } return sum;"),
                 "crashed");
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
  EXPECT_EQ(verdict_on(8, "double bias(double C, double beta) { return C * beta; }\n").sentence, sentence);
  EXPECT_EQ(verdict_on(8, "").sentence, sentence);
  EXPECT_EQ(verdict_on(8, "float bias(double, double, double) { return 0; }\n").line, 1);
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
