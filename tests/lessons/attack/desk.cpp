// The derivation desk as a program: what it is given to read, and how it ends.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/lessons/terminal/process.hpp"

namespace byhand::tests {
namespace {

using testing::HasSubstr;

constexpr int all_right = 0, a_line_is_wrong = 1, unreadable = 2;
const std::string derivation = "C = |p2 - p1|^2/2 - L^2/2\\ndC = (p2 - p1) . ";

Finished desk(const std::string& file) { return run("timeout 20 " BYHAND_DESK " " + file); }

TEST(DeskProgram, EndsByWhatItsLinesAre) {
  const auto read = [](const std::string& lines) {
    return run("printf '" + lines + "' | " BYHAND_DESK " -").status;
  };
  EXPECT_EQ(read(derivation + "(v2 + w2 x r2 - v1 - w1 x r1)\\n"), all_right);
  EXPECT_EQ(read(derivation + "(v2 - v1)\\n"), a_line_is_wrong);
  EXPECT_EQ(read("C = |p2 - \\n"), unreadable);
}

TEST(DeskProgram, RefusesAFileWithoutALine) {
  const Folder folder;
  for (const std::string words : {"", "\\n\\n", "# a remark\\n"}) {
    const Finished finished = run("printf '" + words + "' >" + (folder / "lines").string() + "; " BYHAND_DESK " " +
                                  (folder / "lines").string());
    EXPECT_EQ(finished.status, unreadable) << words;
    EXPECT_THAT(finished.complained, HasSubstr("has no line to judge")) << words;
  }
  EXPECT_EQ(desk("/dev/null").status, unreadable);
}

TEST(DeskProgram, ReadsNoMoreThanALearnerTypes) {
  EXPECT_THAT(desk("/dev/zero").complained, HasSubstr("more than a million characters"));
  EXPECT_THAT(desk("- </dev/zero").complained, HasSubstr("more than a million characters"));
  const Folder folder;
  const std::string file = (folder / "lines").string();
  run("{ printf 'C = '; head -c 100000 /dev/zero | tr '\\0' '('; } >" + file);
  const Finished deep = desk(file);
  EXPECT_EQ(deep.status, unreadable);
  EXPECT_THAT(deep.complained, HasSubstr("line 1 has 100004 characters; a line may have 2000"));
}

TEST(DeskProgram, RefusesWhatCannotBeRead) {
  for (const char* file : {"/proc/self/mem", "/nonexistent", "/"}) {
    const Finished finished = desk(file);
    EXPECT_EQ(finished.status, unreadable) << file;
    EXPECT_THAT(finished.complained, HasSubstr(file));
  }
}

}  // namespace
}  // namespace byhand::tests
