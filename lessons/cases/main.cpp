// The casebook. Started by `lessons/run case`.

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "lessons/cases/pages.hpp"
#include "lessons/files/options.hpp"
#include "lessons/files/streams.hpp"

namespace {

using namespace byhand;
using Arguments = std::vector<std::string>;

constexpr auto help = R"(./lessons/run case [N] [OPTIONS]

The casebook: reports of engines' users, each with the number that the equations give before the run, the run, the
cure and what it costs. Without N it lists the cases; with N it shows one.

  ./lessons/run case             all cases
  ./lessons/run case 3           one, by its number or a part of its name
  ./lessons/run case 3 --check   only its predictions beside what the run gives
  ./lessons/run case 3 --film webm

OPTIONS are those of a lesson: --frames none, --quality high, --output DIR, --plain, --quiet, --step N.
A folder in lessons/cases/ with scene.json and case.cpp is a case.

Exit status: 0 fine, 1 a prediction is wrong, 2 bad usage, 3 the environment.
)";

const cases::Folder& called(const std::string& name) {
  std::vector<const cases::Folder*> like;
  for (const cases::Folder& folder : cases::all()) {
    if (name == folder.slug || name == folder.slug.substr(0, 2) || name == std::to_string(std::stoi(folder.slug)))
      return folder;
    if (!name.empty() && folder.slug.find(name, 3) != std::string::npos) like.push_back(&folder);
  }
  if (like.size() != 1)
    throw std::invalid_argument(
        fmt::format("There is no case \"{}\"; there are 1 to {}: ./lessons/run case lists them",
                    course::shortened(name), cases::all().size()));
  return *like.front();
}

int run(Arguments arguments) {
  if (std::find(arguments.begin(), arguments.end(), "--help") != arguments.end()) return fmt::print("{}", help), 0;
  if (arguments.empty()) {
    for (const cases::Folder& folder : cases::all()) {
      const cases::Case told = folder.make();
      fmt::print("{:>3}  {}\n     {}\n", std::stoi(folder.slug), told.title, told.link);
    }
    return 0;
  }
  course::Lesson lesson = cases::page_of(called(arguments.front()));
  const bool elsewhere =
      std::any_of(arguments.begin(), arguments.end(), [](const auto& one) { return one.starts_with("--output"); });
  if (!elsewhere) arguments.insert(arguments.end(), {"--output", (course::default_output() / "cases").string()});
  std::vector<const char*> words{"case"};
  for (std::size_t i = 1; i < arguments.size(); ++i) words.push_back(arguments[i].c_str());
  return lesson.run(static_cast<int>(words.size()), words.data());
}

}  // namespace

int main(int argc, char** argv) {
  return byhand::course::exit_status_of([&] { return run({argv + 1, argv + argc}); });
}
