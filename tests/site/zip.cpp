#include "lessons/site/course/zip.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/lessons/terminal/process.hpp"

namespace byhand::tests {
namespace {

using site::Zip;

std::string archive(const std::vector<std::pair<std::string, std::string>>& files) {
  Zip zip;
  for (const auto& [name, bytes] : files) zip.add(name, bytes);
  return zip.finish();
}

TEST(Zip, IsReadByOthers) {
  const Folder folder;
  const std::string text(100'000, 'x'), noise = "\x01\xfe\x80z";
  std::ofstream(folder / "a.zip", std::ios::binary)
      << archive({{"text", text}, {"in/noise", noise}, {"empty", ""}});
  const Finished read = run("cd " + folder.path().string() +
                            " && /usr/bin/python3 -c \"import zipfile; z = zipfile.ZipFile('a.zip'); "
                            "print(z.testzip()); z.extractall('out')\"");
  if (read.status == 127) GTEST_SKIP() << "python3 is not installed";
  EXPECT_EQ(read.said, "None\n") << read.complained;
  EXPECT_EQ(contents(folder / "out" / "text"), text);
  EXPECT_EQ(contents(folder / "out" / "in" / "noise"), noise);
  EXPECT_EQ(contents(folder / "out" / "empty"), "");
}

TEST(Zip, PacksWhatRepeats) { EXPECT_LT(archive({{"text", std::string(100'000, 'x')}}).size(), 1000U); }

TEST(Zip, KeepsAFileAsItIsIfAsked) {
  Zip zip;
  zip.add("mimetype", std::string(50, 'x'), Zip::Store::as_it_is);
  EXPECT_THAT(zip.finish(), testing::HasSubstr("mimetype" + std::string(50, 'x')));
}

TEST(Zip, KeepsWhatMayBeExecuted) {
  const Folder folder;
  std::filesystem::create_directory(folder / "in");
  for (const char* name : {"data", "program"}) std::ofstream(folder / "in" / name) << "#!/bin/sh\n";
  std::filesystem::permissions(folder / "in" / "program", std::filesystem::perms::owner_all);
  std::ofstream(folder / "a.zip", std::ios::binary) << site::zip_of(folder / "in");
  const Finished read =
      run("/usr/bin/python3 -c \"import zipfile; print([oct(i.external_attr >> 16) for i in "
          "zipfile.ZipFile('" +
          (folder / "a.zip").string() + "').infolist()])\"");
  if (read.status == 127) GTEST_SKIP() << "python3 is not installed";
  EXPECT_EQ(read.said, "['0o100644', '0o100755']\n") << read.complained;
}

TEST(Zip, IsTheSameEachTime) { EXPECT_EQ(archive({{"a", "b"}}), archive({{"a", "b"}})); }

}  // namespace
}  // namespace byhand::tests
