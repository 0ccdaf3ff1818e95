#include "lessons/practise/judge/check.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <sstream>

#include "lessons/files/atomic_file.hpp"
#include "lessons/page/error.hpp"
#include "lessons/practise/judge/compiled.hpp"
#include "lessons/practise/judge/process.hpp"

namespace byhand::practise {
namespace {

namespace fs = std::filesystem;

/// Where the build leaves child.cpp for each exercise: beside this program.
fs::path child(const Exercise& exercise) {
  return fs::read_symlink("/proc/self/exe").parent_path() / "practise_children" /
         fmt::format("lib{}.a", exercise.name);
}

/// The text of a file of at most 64 KB, into `text`; or why there is none, as a sentence. A link is not followed:
/// it could lead to a file that only the judge may read.
std::string read_learners(const fs::path& path, std::string& text) {
  const std::string name = path.filename().string();
  const int file = open(path.c_str(), O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC);
  struct stat status {};
  const bool regular = file >= 0 && fstat(file, &status) == 0 && S_ISREG(status.st_mode);
  text.assign(most_text + 1, '\0');
  const ssize_t got = regular ? read(file, text.data(), text.size()) : -1;
  if (file >= 0) close(file);
  if (got < 0) return name + " is not a file that can be read: links, folders and devices are not judged.";
  if (static_cast<std::size_t>(got) > most_text) return too_long(name);
  text.resize(static_cast<std::size_t>(got));
  return "";
}

Verdict checked(const Exercise& exercise, const Key& key, const fs::path& path, std::string& warnings) {
  const fs::path signature = exercise.folder() / "signature.hpp", header = practise_folder() / "learner",
                 library = child(exercise);
  if (!fs::exists(library)) throw course::EnvironmentError(library.string() + " is missing");
  std::string text;
  if (const std::string refused = read_learners(path, text); !refused.empty()) return not_compiled(refused);

  const Scratch scratch;
  const std::string file = (scratch.path() / path.filename()).string(),
                    object = (scratch.path() / "object.o").string(),
                    program = (scratch.path() / "program").string();
  course::write_whole(file, text);
  const Limits limits{.seconds = 10, .bytes = 1u << 30};
  const Finished compiled = run_confined(
      {BYHAND_COMPILER,
       "-std=c++20",
       "-O1",
       "-ffp-contract=off",
       "-Wall",
       "-Wno-unknown-pragmas",
       "-Werror=return-type",
       "-fmax-errors=3",
       "-fsanitize=integer-divide-by-zero,signed-integer-overflow,bounds,null,unreachable,float-cast-overflow",
       "-fno-sanitize-recover=all",
       "-ffile-prefix-map=" + scratch.path().string() + "/=",
       "-I" + header.string(),
       "-include",
       signature.string(),
       "-x",
       "c++",
       "-c",
       file,
       "-o",
       object},
      {signature, header}, scratch.path(), limits);
  const Messages messages(compiled.said, file);
  if (compiled.status != 0) {
    const bool out_of_memory = compiled.said.find("memory") != std::string::npos && messages.errors.empty();
    return not_compiled(compiled.status < 0 ? "It does not compile within ten seconds."
                        : out_of_memory     ? "It does not compile within a gigabyte of memory."
                                            : "It does not compile.",
                        messages);
  }
  const Finished linked = run_confined(
      {BYHAND_COMPILER, "-static", "-Wl,--undefined=byhand_child", object, library.string(), "-o", program},
      {library}, scratch.path(), limits);
  if (linked.status != 0) return not_compiled(about_linking(linked.said, text));

  Process process(program);
  Verdict verdict = judge(
      exercise, key, [&](std::size_t which, const Numbers& arguments) { return process.call(which, arguments); });
  verdict.printed = process.printed();
  warnings = messages.warnings;
  return verdict;
}

}  // namespace

Verdict check(const Exercise& exercise, const Key& key, const fs::path& path) {
  std::string warnings;
  Verdict verdict = checked(exercise, key, path, warnings);
  finish(verdict, warnings);
  return verdict;
}

}  // namespace byhand::practise
