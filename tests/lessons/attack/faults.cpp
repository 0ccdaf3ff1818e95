// Whatever happens to a run, status 0 means that every file is there, nothing half-made stays, and the next run
// gives the bytes of a run that nothing happened to.

#include <fcntl.h>
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/file.h>

#include <chrono>
#include <random>
#include <thread>

#include "tests/lessons/files/written.hpp"
#include "tests/lessons/terminal/process.hpp"
#include "tests/lessons/terminal/terminal.hpp"

namespace byhand::tests {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;
using testing::IsEmpty;
using namespace std::chrono_literals;

class Faults : public testing::Test {
 protected:
  std::vector<std::string> command(const std::string& output = "output") const {
    return {BYHAND_FIXTURE, "--quality", "low", "--output", (folder_ / output).string()};
  }
  fs::path lesson() const { return folder_ / "output/99_fixture"; }

  const std::map<std::string, std::string>& undisturbed() {
    if (undisturbed_.empty()) {
      EXPECT_EQ(Started(command("reference")).finish().status, 0);
      undisturbed_ = lasting_files(folder_ / "reference/99_fixture");
    }
    return undisturbed_;
  }

  std::vector<std::string> temporary_files() const {
    std::vector<std::string> found;
    for (const auto& [name, bytes] : all_files(folder_ / "output"))
      if (name.find(".part") != std::string::npos) found.push_back(name);
    return found;
  }

  /// What holds at any moment: whole files only, and no manifest but a true one.
  void expect_no_lie() {
    for (const auto& [name, bytes] : lasting_files(lesson()))
      if (name.find(".part") == std::string::npos) {
        EXPECT_TRUE(undisturbed().at(name) == bytes) << name;
      }
    if (fs::exists(lesson() / "manifest.json")) {
      EXPECT_TRUE(manifest_holds(lesson()));
    }
  }

  void expect_the_next_run_to_be_whole() {
    const Finished next = Started(command()).finish();
    EXPECT_EQ(next.status, 0) << next.complained;
    EXPECT_TRUE(lasting_files(lesson()) == undisturbed());
    EXPECT_TRUE(manifest_holds(lesson()));
  }

  const Folder folder_;

 private:
  std::map<std::string, std::string> undisturbed_;
};

TEST_F(Faults, AKilledRunLeavesWholeFilesAndTheNextOneMendsIt) {
  undisturbed();
  std::mt19937 random(seeded(20131207));
  using Clock = std::chrono::steady_clock;
  Clock::time_point begin = Clock::now();
  Started(command()).finish();
  auto took = Clock::now() - begin;
  int killed = 0;
  for (int i = 0; i < attempts(100); ++i) {
    const int signal = std::array{SIGKILL, SIGTERM, SIGINT, SIGHUP}[static_cast<size_t>(i % 4)];
    SCOPED_TRACE(testing::Message() << "attempt " << i << ", signal " << signal);
    if (random() % 2) fs::remove_all(folder_ / "output");
    begin = Clock::now();
    Started run(command());
    std::this_thread::sleep_for(took * (random() % 1000) / 1000);
    run.send(signal);
    const std::string its_own = fmt::format(".byhand-{}-", run.process());
    const Finished finished = run.finish();
    EXPECT_THAT(finished.status, testing::AnyOf(0, -signal));
    killed += finished.status != 0;
    if (finished.status == 0) took = std::min(took, Clock::now() - begin);  // the first was slower than the others
    // Those of a run that was killed before stay until the next one has begun to write.
    if (signal != SIGKILL) {
      EXPECT_THAT(temporary_files(), testing::Not(testing::Contains(HasSubstr(its_own))));
    }
    expect_no_lie();
    if (i % 5 == 0) expect_the_next_run_to_be_whole();
    if (HasFailure()) return;
  }
  EXPECT_GT(killed, attempts(50));
}

TEST_F(Faults, AnySystemCallThatFailsIsReportedAndTheNextRunMendsIt) {
  for (const std::string call : {"open", "write", "fsync", "close", "rename", "mkdir", "remove"}) {
    int failed = 0;
    for (int at = 1;; ++at) {
      SCOPED_TRACE(testing::Message() << call << " " << at);
      fs::remove(folder_ / "failed");
      // "remove" meets the files of an earlier run.
      if (call == "remove")
        Started(command()).finish();
      else
        fs::remove_all(folder_ / "output");
      const Finished finished =
          Started(command(),
                  {"LD_PRELOAD=" BYHAND_FAIL_CALL, "FAIL_CALL=" + call, "FAIL_AT=" + std::to_string(at),
                   "FAIL_BELOW=" + (folder_ / "output").string(), "FAILED=" + (folder_ / "failed").string()})
              .finish();
      expect_no_lie();
      EXPECT_THAT(temporary_files(), IsEmpty());
      if (!fs::exists(folder_ / "failed")) {
        EXPECT_EQ(finished.status, 0) << finished.complained;
        break;
      }
      ++failed;
      // Closing a folder that was synced decides nothing.
      if (finished.status == 0 && call == "close") {
        EXPECT_TRUE(manifest_holds(lesson()));
        continue;
      }
      EXPECT_EQ(finished.status, 3);
      EXPECT_THAT(finished.complained, HasSubstr((folder_ / "output").string()));
      EXPECT_EQ(std::count(finished.complained.begin(), finished.complained.end(), '\n'), 1)
          << finished.complained;
      if (at % 7 == 1) expect_the_next_run_to_be_whole();
      if (HasFailure()) return;
    }
    EXPECT_GE(failed, call == "remove" ? 1 : 4) << call;
  }
}

TEST_F(Faults, AFullDiskIsReportedAndLeavesNothingHalfMade) {
  const std::string disk = (folder_ / "disk").string();
  fs::create_directory(disk);
  const std::string in_a_namespace = "unshare --user --map-root-user --mount sh -c ";
  if (run(in_a_namespace + "'mount -t tmpfs none " + disk + "'").status != 0)
    GTEST_SKIP() << "this machine mounts nothing for users";
  bool enough = false;
  for (const std::string limit : {"size", "nr_inodes"}) {
    for (int size = limit == "size" ? 4 : 3; size < 2000; size = size * 5 / 4 + 1) {
      const std::string unit = limit == "size" ? "k" : "";
      const Finished finished =
          run(in_a_namespace + "'mount -t tmpfs -o " + limit + "=" + std::to_string(size) + unit + " none " +
              disk + " && { " + BYHAND_FIXTURE + " --quiet --quality low --output " + disk +
              "/output; status=$?; } ; find " + disk + " -name \"*.part\"; test $status = 0 -o ! -e " + disk +
              "/output/99_fixture/manifest.json || echo a manifest; exit $status'");
      EXPECT_THAT(finished.said, IsEmpty()) << limit << size;
      EXPECT_THAT(finished.status, testing::AnyOf(0, 3)) << limit << size << finished.complained;
      if (finished.status == 3) {
        EXPECT_THAT(finished.complained, HasSubstr("No space left on device"));
      }
      enough = finished.status == 0;
      if (enough) break;
    }
    EXPECT_TRUE(enough) << limit;
  }
}

TEST_F(Faults, AFontThatIsCutShortIsReported) {
  const std::string font = BYHAND_FONT, cut = (folder_ / "cut").string();
  const auto with_bytes = [&](std::uintmax_t bytes, const std::string& command) {
    return run("head -c " + std::to_string(bytes) + " " + font + " >" + cut +
               " && unshare --user --map-root-user --mount sh -c 'mount --bind " + cut + " " + font + " && " +
               command + "'");
  };
  const std::uintmax_t whole = fs::file_size(font);
  if (with_bytes(whole, "true").status != 0) GTEST_SKIP() << "this machine mounts nothing for users";
  const std::string draw =
      std::string(BYHAND_FIXTURE) + " --quiet --quality low --output " + (folder_ / "output").string();
  for (const std::uintmax_t bytes :
       {std::uintmax_t{0}, std::uintmax_t{5}, std::uintmax_t{100}, whole / 3, whole / 2, whole - 1}) {
    const Finished finished = with_bytes(bytes, draw);
    EXPECT_EQ(finished.status, 3) << bytes;
    EXPECT_THAT(finished.complained, HasSubstr("There is no whole font at " + font)) << bytes;
  }
  EXPECT_EQ(with_bytes(whole, draw).status, 0);
}

TEST_F(Faults, AFileThatIsTooLargeIsReportedInsteadOfASignal) {
  const Finished finished = run("ulimit -f 8; exec " + std::string(BYHAND_FIXTURE) + " --quiet --output " +
                                (folder_ / "output").string());
  EXPECT_EQ(finished.status, 3);
  EXPECT_THAT(finished.complained, HasSubstr("File too large"));
  EXPECT_THAT(temporary_files(), IsEmpty());
}

TEST_F(Faults, WhateverTheLimitOnMemoryARunEndsWellOrSaysSo) {
  for (int mebibytes = 300; mebibytes <= 900; mebibytes += attempts(1) > 1 ? 6 : 60) {
    const Finished finished =
        run("ulimit -v " + std::to_string(mebibytes << 10) + "; exec " + BYHAND_FIXTURE +
            " --quality low --quiet --output " + (folder_ / std::to_string(mebibytes)).string());
    EXPECT_THAT(finished.status, testing::AnyOf(0, 3)) << mebibytes << finished.complained;
    if (finished.status == 3) {
      EXPECT_THAT(finished.complained, HasSubstr("memory")) << mebibytes;
    }
  }
}

TEST_F(Faults, OfTwoRunsInOneFolderOneIsRefused) {
  for (int i = 0; i < attempts(5); ++i) {
    Started one(command()), other(command());
    const Finished first = one.finish(), second = other.finish();
    EXPECT_EQ(std::min(first.status, second.status), 0);
    for (const Finished& run : {first, second})
      if (run.status != 0) {
        EXPECT_EQ(run.status, 3);
        EXPECT_THAT(run.complained, HasSubstr("Another run writes into " + lesson().string()));
      }
    EXPECT_TRUE(manifest_holds(lesson()));
    EXPECT_TRUE(lasting_files(lesson()) == undisturbed());
  }
}

TEST_F(Faults, TheClaimOfAFolderEndsWithItsProcess) {
  fs::create_directories(lesson());
  const int held = open(lesson().c_str(), O_RDONLY);
  ASSERT_EQ(flock(held, LOCK_EX), 0);
  const Finished refused = Started(command()).finish();
  EXPECT_EQ(refused.status, 3);
  EXPECT_THAT(all_files(lesson()), IsEmpty());
  close(held);
  expect_the_next_run_to_be_whole();
}

/// Does `harm` to a run in its middle.
Finished harmed(Started& run, const fs::path& lesson, const std::function<void()>& harm) {
  while (!fs::exists(lesson / "figures/errors.png") && run.runs()) std::this_thread::sleep_for(1ms);
  run.send(SIGSTOP);
  EXPECT_FALSE(fs::exists(lesson / "manifest.json"));
  harm();
  run.send(SIGCONT);
  return run.finish();
}

TEST_F(Faults, AFileThatVanishesOrChangesMeanwhileIsReported) {
  const fs::path figure = lesson() / "figures/errors.png";
  for (const bool removed : {true, false}) {
    fs::remove_all(lesson());
    Started run(command());
    const Finished finished = harmed(run, lesson(), [&] {
      if (removed)
        fs::remove(figure);
      else
        std::ofstream(figure) << "another run's";
    });
    EXPECT_EQ(finished.status, 3);
    EXPECT_THAT(finished.complained, HasSubstr(figure.string() + " was changed or removed"));
    EXPECT_FALSE(fs::exists(lesson() / "manifest.json"));
  }
}

TEST_F(Faults, AFolderThatIsMovedMeanwhileIsReported) {
  Started run(command());
  const Finished finished = harmed(run, lesson(), [&] { fs::rename(folder_ / "output", folder_ / "elsewhere"); });
  EXPECT_EQ(finished.status, 3);
  EXPECT_THAT(finished.complained, HasSubstr("was moved or removed"));
}

TEST_F(Faults, ALinkIsReplacedAndNotTheFileThatItNames) {
  std::ofstream(folder_ / "victim") << "precious";
  fs::create_directories(lesson() / "figures");
  fs::create_symlink(folder_ / "victim", lesson() / "figures/errors.png");
  fs::create_symlink(folder_ / "victim", lesson() / "lesson.md");
  const fs::path state = folder_ / "state";
  fs::create_directories(state / "constraints-by-hand");
  fs::create_symlink(folder_ / "victim", state / "constraints-by-hand/99_fixture.json");
  expect_the_next_run_to_be_whole();
  auto reader = command();
  reader.push_back("--interactive");
  EXPECT_EQ(Started(reader, {"XDG_STATE_HOME=" + state.string()}).finish().status, 0);
  EXPECT_THAT(contents(state / "constraints-by-hand/99_fixture.json"), HasSubstr("\"step\":\"1\""));
  EXPECT_EQ(contents(folder_ / "victim"), "precious");
}

TEST_F(Faults, ClosedAndFullStreamsNeverReachAFileNorEndARun) {
  for (const std::string closed : {"0<&-", "1>&-", "2>&-", "0<&- 1>&-", "0<&- 2>&-", "1>&- 2>&-", "0<&- 1>&- 2>&-",
                                   "1>/dev/full", "2>/dev/full", "1>/dev/full 2>/dev/full"}) {
    for (const bool quiet : {true, false}) {
      SCOPED_TRACE(closed);
      fs::remove_all(folder_ / "output");
      const Finished finished = run(std::string(BYHAND_FIXTURE) + (quiet ? " --quiet" : "") +
                                    " --quality low --output " + (folder_ / "output").string() + " " + closed);
      const bool said_in_vain = !quiet && closed.find("1>") != std::string::npos;
      EXPECT_EQ(finished.status, said_in_vain ? 3 : 0) << finished.complained;
      expect_no_lie();
      if (finished.status == 0) {
        EXPECT_TRUE(manifest_holds(lesson()));
      }
    }
    EXPECT_EQ(run(std::string(BYHAND_FIXTURE) + " --bogus " + closed).status, 2);
  }
}

TEST_F(Faults, ProgressOfASlowRunReachesNoFile) {
  for (const std::string closed : {"2>&-", "2>/dev/full", "1>&- 2>&-"}) {
    fs::remove_all(folder_ / "output");
    run("LD_PRELOAD=" BYHAND_FAIL_CALL " SLOW_FSYNC=1 " + std::string(BYHAND_FIXTURE) +
        " --quality low --output " + (folder_ / "output").string() + " " + closed);
    expect_no_lie();
    if (closed.find("1>") == std::string::npos) {
      EXPECT_TRUE(manifest_holds(lesson())) << closed;
    }
  }
}

TEST_F(Faults, ProgressTellsTheTimeLeft) {
  std::vector<std::string> slow = command();
  slow.insert(slow.end(), {"--no-interactive", "--set", "steps=20"});
  Terminal reader(slow, {{"LD_PRELOAD", BYHAND_FAIL_CALL}, {"SLOW_FSYNC", "1"}});
  reader.expect(" s left drawing settling");
  EXPECT_EQ(reader.leave(), 0);
}

TEST_F(Faults, FilesThatAPersonPutBesideOursAreKept) {
  Started(command()).finish();
  std::ofstream(lesson() / "frames/settling/notes.txt") << "mine";
  std::ofstream(lesson() / "frames/settling/0007b.png") << "mine too";
  std::ofstream(folder_ / "elsewhere.png") << "elsewhere";
  fs::create_directory(lesson() / "frames/settling/0123.png");
  fs::create_directory(folder_ / "others");
  std::ofstream(folder_ / "others/0000.png") << "others'";
  fs::create_symlink(folder_ / "others", lesson() / "frames/settling/9998.png");
  for (const char* frames : {"all", "last", "none"}) {
    auto again = command();
    again.insert(again.end(), {"--frames", frames});
    EXPECT_EQ(Started(again).finish().status, 0);
    EXPECT_EQ(contents(lesson() / "frames/settling/notes.txt"), "mine") << frames;
    EXPECT_EQ(contents(lesson() / "frames/settling/0007b.png"), "mine too") << frames;
    EXPECT_EQ(contents(folder_ / "others/0000.png"), "others'") << frames;
    EXPECT_EQ(fs::exists(lesson() / "frames/settling/0000.png"), std::string(frames) == "all");
  }
}

TEST_F(Faults, FramesOfALongerRunThatWasKilledGo) {
  fs::create_directories(lesson() / "frames/settling");
  std::ofstream(lesson() / "frames/settling/0999.png") << "of a killed run, which left no manifest";
  expect_the_next_run_to_be_whole();
}

TEST_F(Faults, NothingButARegularFileIsReplaced) {
  fs::create_directories(lesson() / "figures");
  ASSERT_EQ(run("mkfifo '" + (lesson() / "figures/errors.png").string() + "'").status, 0);
  const Finished finished = Started(command()).finish();
  EXPECT_EQ(finished.status, 3);
  EXPECT_THAT(finished.complained, HasSubstr("figures/errors.png"));
  EXPECT_TRUE(fs::is_fifo(lesson() / "figures/errors.png"));
}

TEST_F(Faults, ALinkThatLeadsNowhereIsNamed) {
  fs::create_symlink(folder_ / "nowhere", folder_ / "dangling");
  fs::create_symlink("circle", folder_ / "circle");
  for (const std::string output : {"dangling", "dangling/below", "circle"}) {
    const Finished finished = Started(command(output)).finish();
    EXPECT_EQ(finished.status, 3);
    EXPECT_THAT(finished.complained,
                testing::AllOf(HasSubstr("is a link to"), testing::Not(HasSubstr("File exists"))));
    EXPECT_EQ(std::count(finished.complained.begin(), finished.complained.end(), '\n'), 1);
  }
  EXPECT_FALSE(fs::exists(folder_ / "nowhere"));
}

TEST_F(Faults, WithoutThreadsTheSamePicturesAreDrawn) {
  undisturbed();
  for (const char* threads : {"0", "1", "2"}) {
    SCOPED_TRACE(threads);
    fs::remove_all(folder_ / "output");
    const Finished finished =
        run(std::string("LD_PRELOAD=") + BYHAND_FAIL_CALL + " THREADS=" + threads + " timeout 60 " +
            BYHAND_FIXTURE + " --quality low --output " + (folder_ / "output").string());
    EXPECT_EQ(finished.status, 0) << finished.complained;
    EXPECT_TRUE(lasting_files(lesson()) == undisturbed());
  }
}

TEST_F(Faults, ADriverThatMesaDoesNotHaveIsNamed) {
  const Finished finished = run(std::string("GALLIUM_DRIVER=nonsense ") + BYHAND_FIXTURE +
                                " --quality low --output " + (folder_ / "output").string());
  EXPECT_EQ(finished.status, 3) << finished.complained;
  EXPECT_THAT(finished.complained, HasSubstr("unset GALLIUM_DRIVER"));
}

TEST_F(Faults, AClosedOutputIsNamed) {
  for (const char* closed : {" >&-", " >/dev/full"}) {
    for (const char* words : {" --check", " --list-parameters", " --help", " --questions"}) {
      const Finished finished = run(std::string(BYHAND_FIXTURE) + words + closed);
      EXPECT_EQ(finished.status, 3) << words << closed;
      EXPECT_THAT(finished.complained, HasSubstr("standard output")) << words << closed;
      EXPECT_EQ(std::count(finished.complained.begin(), finished.complained.end(), '\n'), 1)
          << finished.complained;
    }
  }
}

}  // namespace
}  // namespace byhand::tests
