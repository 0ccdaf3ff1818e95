// Writes what the desk prints as code for every task, so that the build compiles it: see code.cpp.
#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <regex>
#include <sstream>

#include "lessons/desk/print.hpp"
#include "lessons/desk/report.hpp"
#include "lessons/desk/task.hpp"

int main(int, char** argv) {
  using namespace byhand::desk;
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(argv[1])) files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  std::ofstream out(argv[2]);
  std::string all;
  for (const auto& file : files) {
    std::ostringstream text;
    text << std::ifstream(file).rdbuf();
    const Task task = read_task(text.str());
    Sheet sheet;
    for (const auto* lines : {&task.before, &task.start, &task.goal})
      for (const std::string& line : *lines) sheet.add(line);
    const std::string code = cpp_struct(sheet);
    if (code.empty()) continue;
    const std::string name = "task_" + file.stem().string();
    out << "namespace " << name << " {\n"
        << code
        << "\ntemplate <class Fill>\nvoid fill([[maybe_unused]] Derived& derived, [[maybe_unused]] const Fill& "
           "of) {\n";
    std::smatch member;
    const std::regex members("(double|Linear<M>) (\\w+)_ = ");
    for (std::string rest = code; std::regex_search(rest, member, members); rest = member.suffix())
      for (const Symbol& symbol_of : sheet.words().all())
        if (cpp(symbol(symbol_of)) == member[2]) {
          out << "  of(\"" << symbol_of.name << "\", derived." << member[2] << "_);\n";
          break;
        }
    out << "}\n}  // namespace " << name << "\n";
    all += "  test(\"" + file.filename().string() + "\", " + name +
           "::Derived{}, [](auto& derived, const auto& of) { " + name + "::fill(derived, of); });\n";
  }
  out << "\ntemplate <class Test>\nvoid for_each_task(const Test& test) {\n" << all << "}\n";
  return 0;
}
