#include "lessons/practise/export_course.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "lessons/files/atomic_file.hpp"
#include "lessons/files/checksum.hpp"
#include "lessons/practise/handout.hpp"
#include "lessons/site/course/zip.hpp"

namespace byhand::practise {
namespace {

namespace fs = std::filesystem;

void copy_into(const fs::path& from, const fs::path& to) {
  fs::create_directories(to.parent_path());
  fs::copy(from, to, fs::copy_options::recursive);
}

void copy_judge(const fs::path& source, const std::vector<const Exercise*>& wanted) {
  const fs::path here = practise_folder(), root = here.parent_path().parent_path();
  copy_into(here / "export" / "CMakeLists.txt", source / "CMakeLists.txt");
  for (const char* part :
       {"renderer", "lessons/files/atomic_file.hpp", "lessons/files/atomic_file.cpp", "lessons/page/error.hpp"})
    copy_into(root / part, source / part);
  for (const char* part :
       {"CMakeLists.txt", "exercises.cmake", "exercise.cpp.in", "grade.cpp", "judge", "learner"})
    copy_into(here / part, source / "lessons" / "practise" / part);
  for (const Exercise* exercise : wanted) {
    const fs::path folder = source / "lessons" / "practise" / exercise->name;
    for (const char* file : {"signature.hpp", "probe.cpp", "stub.cpp"})
      copy_into(exercise->folder() / file, folder / file);
    course::write_whole(folder / "task.md", statement(*exercise));
  }
}

std::string html(const std::string& text) {
  std::string escaped;
  for (const char c : text) escaped += c == '&' ? "&amp;" : c == '<' ? "&lt;" : std::string(1, c);
  return escaped;
}

/// Another for other exercises or another seed: two questions of one course may not share it. Learners may see it,
/// and no seed follows from it but one that is small enough to be guessed.
std::string uuid(const std::vector<const Exercise*>& wanted, std::uint64_t seed) {
  std::string what = std::to_string(seed);
  for (const Exercise* exercise : wanted) what += " " + exercise->name;
  const std::string digest = course::sha256(what);
  const auto digits = [&](std::size_t from, std::size_t count) { return digest.substr(from, count); };
  return fmt::format("{}-{}-4{}-a{}-{}", digits(0, 8), digits(8, 4), digits(12, 3), digits(15, 3), digits(18, 12));
}

/// What PrairieLearn needs to show the question; its image is built from the same folder.
void write_question(const fs::path& folder, const std::vector<const Exercise*>& wanted, std::uint64_t seed) {
  std::string page = fmt::format("<pl-question-panel>\n<pre>{}</pre>\n", html(given_types()));
  for (const Exercise* exercise : wanted) {
    page += fmt::format(
        "<pre>{}\nThe equations it rests on\n{}\n{}</pre>\n<pl-file-editor file-name=\"{}.cpp\" "
        "ace-mode=\"ace/mode/c_cpp\" source-file-name=\"{}.cpp\"></pl-file-editor>\n",
        html(statement(*exercise)), html(equations_of(*exercise)),
        html(contents_of(exercise->folder() / "signature.hpp")), exercise->name, exercise->name);
    course::write_whole(folder / "question" / (exercise->name + ".cpp"),
                        contents_of(exercise->folder() / "stub.cpp"));
  }
  page +=
      "</pl-question-panel>\n<pl-submission-panel>\n<pl-external-grader-results></pl-external-grader-results>\n"
      "<pl-file-preview></pl-file-preview>\n</pl-submission-panel>\n";
  course::write_whole(folder / "question" / "question.html", page);
  constexpr std::size_t longest = 40;  // [s] of an exercise: to compile 10, to link 10, to run 20
  const std::string title = wanted.size() == 1 ? task(*wanted.front()).title : "Constraints by hand";
  course::write_whole(folder / "question" / "info.json",
                      fmt::format(R"({{
  "uuid": "{}",
  "title": "{}",
  "topic": "Constraints",
  "type": "v3",
  "gradingMethod": "External",
  "externalGradingOptions": {{
    "enabled": true,
    "image": "practise",
    "entrypoint": "/judge/grade.sh",
    "timeout": {}
  }}
}}
)",
                                  uuid(wanted, seed), title, 60 + longest * wanted.size()));
}

}  // namespace

void require_empty(const fs::path& folder) {
  std::error_code error;
  const fs::file_status there = fs::status(folder, error);
  if (fs::exists(there) && !fs::is_directory(there))
    throw std::invalid_argument(fmt::format("{} is no folder; --to names a new or empty one", folder.string()));
  if (fs::exists(there) && !fs::is_empty(folder))
    throw std::invalid_argument(
        fmt::format("{} holds something; --to names a new or empty folder", folder.string()));
}

void export_course(const std::string& kind, const fs::path& folder, std::uint64_t seed,
                   const std::vector<const Exercise*>& wanted) {
  const fs::path own = practise_folder() / "export" / kind;
  if (kind.empty() || !fs::is_directory(own))
    throw std::invalid_argument(fmt::format(
        "--export {}: there are gradescope, classroom50, prairielearn, junit, handouts, moodle and qti", kind));
  copy_judge(folder / "source", wanted);
  for (const Exercise* exercise : wanted) write_handout(folder / "handout" / exercise->name, *exercise);
  for (const Exercise* exercise : wanted)
    course::write_whole(folder / "keys" / (exercise->name + ".json"), to_json(key(*exercise, seed)));
  copy_into(practise_folder() / "export" / "build.sh", folder / "build.sh");
  for (const auto& file : fs::directory_iterator(own))
    if (file.path().filename() != "README.md") copy_into(file.path(), folder / file.path().filename());
  course::write_whole(folder / "README.md",
                      contents_of(own / "README.md") + contents_of(practise_folder() / "export" / "README.md"));
  if (kind != "gradescope") copy_into(practise_folder() / "export" / "Dockerfile", folder / "Dockerfile");
  if (kind == "prairielearn") write_question(folder, wanted, seed);
  if (kind == "gradescope") course::write_whole(folder / "autograder.zip", site::zip_of(folder));
}

}  // namespace byhand::practise
