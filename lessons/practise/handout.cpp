#include "lessons/practise/handout.hpp"

#include <fmt/format.h>

#include <regex>

#include "lessons/files/atomic_file.hpp"
#include "lessons/page/equation_places.hpp"

namespace byhand::practise {

std::string statement(const Exercise& exercise) {
  const std::string text = contents_of(exercise.folder() / "task.md");
  return text.substr(0, text.find("## Hint"));
}

std::string equations_of(const Exercise& exercise) {
  const std::string named = task(exercise).equations;
  static const std::regex range(R"(\(([0-9]+)\)(–\(([0-9]+)\))?)");
  std::string all;
  for (std::sregex_iterator at(named.begin(), named.end(), range), end; at != end; ++at) {
    const std::size_t first = std::stoul((*at)[1]), last = (*at)[3].matched ? std::stoul((*at)[3]) : first;
    for (std::size_t number = first; number <= last; ++number) {
      const course::EquationPlace& place = course::equation_places.at(number - 1);
      all += fmt::format("  ({}) {}: lesson {}, step {}\n", number, place.says, place.lesson, place.step);
    }
  }
  return all;
}

std::string given_types() { return contents_of(practise_folder() / "learner" / "given.md"); }

void write_handout(const std::filesystem::path& folder, const Exercise& exercise) {
  const auto copy = [&](const std::filesystem::path& from, const std::string& to) {
    course::write_whole(folder / to, contents_of(from));
  };
  course::write_whole(folder / "task.md", fmt::format("{}\nThe equations it rests on\n{}\n{}", statement(exercise),
                                                      equations_of(exercise), given_types()));
  copy(exercise.folder() / "stub.cpp", exercise.name + ".cpp");
  copy(exercise.folder() / "signature.hpp", "signature.hpp");
  copy(practise_folder() / "learner" / "practise.hpp", "practise.hpp");
}

}  // namespace byhand::practise
