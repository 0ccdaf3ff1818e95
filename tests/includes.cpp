// Who includes whom: each include goes along the arrows of the picture in .github/CONTRIBUTING.md; no rooms, no
// headers and no folders of the solver include each other in a circle.

#include <gtest/gtest.h>

#include <unistd.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <fstream>
#include <map>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace {

namespace fs = std::filesystem;

/// For each node those that it includes; a node is a file or a folder. Each edge carries the line that makes it.
using Graph = std::map<std::string, std::map<std::string, std::string>>;

/// What `line` includes in quotes, or nothing.
std::string included(const std::string& line) {
  constexpr const char* blanks = " \t";
  std::size_t at = line.find_first_not_of(blanks);
  if (at == std::string::npos || line[at] != '#') return "";
  at = line.find_first_not_of(blanks, at + 1);
  if (at == std::string::npos || line.compare(at, 7, "include") != 0) return "";
  const std::size_t open = line.find('"', at);
  if (open == std::string::npos) return "";
  return line.substr(open + 1, line.find('"', open + 1) - open - 1);
}

/// All headers and sources of the rooms below `root`, by their path from there.
Graph files_below(const fs::path& root) {
  Graph graph;
  for (const char* room : {"solver", "renderer", "lessons"}) {
    if (!fs::exists(root / room)) continue;
    for (const auto& entry : fs::recursive_directory_iterator(root / room)) {
      if (entry.path().extension() != ".hpp" && entry.path().extension() != ".cpp") continue;
      const std::string name = entry.path().lexically_relative(root).generic_string();
      auto& edges = graph[name];
      std::ifstream in(entry.path());
      std::string line;
      for (int number = 1; std::getline(in, line); ++number) {
        const std::string other = included(line);
        if (other.empty()) continue;
        const bool beside = fs::exists(entry.path().parent_path() / other);
        const fs::path path = beside ? (entry.path().parent_path() / other).lexically_normal() : root / other;
        if (fs::exists(path))
          edges[path.lexically_relative(root).generic_string()] = name + ":" + std::to_string(number);
      }
    }
  }
  return graph;
}

/// A circle of edges, one a line, each with the line of source that makes it; empty if there is none.
std::string circle(const Graph& graph) {
  enum class State { unseen, open, done };
  std::map<std::string, State> states;
  std::vector<std::string> path;
  std::string found;
  const auto visit = [&](const auto& self, const std::string& node) -> void {
    states[node] = State::open;
    path.push_back(node);
    if (const auto edges = graph.find(node); edges != graph.end())
      for (const auto& [next, line] : edges->second) {
        if (!found.empty()) return;
        if (states[next] == State::unseen) self(self, next);
        if (states[next] != State::open || !found.empty()) continue;
        path.push_back(next);
        for (auto at = std::find(path.begin(), path.end(), next); at + 1 != path.end(); ++at)
          found += "\n  " + *at + " includes " + *(at + 1) + " (" + graph.at(*at).at(*(at + 1)) + ")";
      }
    path.pop_back();
    states[node] = State::done;
  };
  for (const auto& [node, edges] : graph)
    if (found.empty() && states[node] == State::unseen) visit(visit, node);
  return found;
}

bool is_in(const std::string& file, const std::string& folder) { return file.rfind(folder + "/", 0) == 0; }

/// The room of a file: solver, renderer, a folder of lessons/; "lesson" for those of all lessons, "course" for the
/// files at the root of lessons/, "learner" for what a learner's file includes, which knows nothing of the course.
std::string room(const std::string& file) {
  const std::size_t slash = file.find('/');
  if (!is_in(file, "lessons")) return file.substr(0, slash);
  if (is_in(file, "lessons/practise/learner")) return "learner";
  const std::size_t next = file.find('/', slash + 1);
  if (next == std::string::npos) return "course";
  return std::isdigit(static_cast<unsigned char>(file[slash + 1])) ? "lesson"
                                                                   : file.substr(slash + 1, next - slash - 1);
}

/// The arrows of the Mermaid picture in a text, each with its line: `a --> b & c`, `a --> b --> c`.
Graph picture_in(std::istream& text) {
  Graph arrows;
  bool inside = false;
  std::string line;
  while (std::getline(text, line)) {
    if (line.rfind("```", 0) == 0) inside = line == "```mermaid";
    if (!inside || line.find("-->") == std::string::npos) continue;
    std::vector<std::string> from, to;
    std::istringstream words(std::regex_replace(line, std::regex(R"(\[[^\]]*\])"), ""));
    for (std::string word; words >> word;) {
      if (word == "-->") from = std::exchange(to, {});
      if (word == "-->" || word == "&") continue;
      to.push_back(word);
      for (const std::string& source : from) arrows[source].emplace(to.back(), line);
    }
  }
  return arrows;
}

/// The rooms that arrows lead to from `room`, over others too.
std::set<std::string> reached(const Graph& picture, const std::string& room) {
  std::set<std::string> all;
  const auto visit = [&](const auto& self, const std::string& from) -> void {
    if (const auto arrows = picture.find(from); arrows != picture.end())
      for (const auto& [to, line] : arrows->second)
        if (all.insert(to).second) self(self, to);
  };
  visit(visit, room);
  return all;
}

/// Includes from one room into another that no arrows lead to, one a line.
std::string against(const Graph& picture, const Graph& files) {
  std::string found;
  for (const auto& [file, edges] : files) {
    const std::set<std::string> allowed = reached(picture, room(file));
    for (const auto& [other, line] : edges)
      if (room(other) != room(file) && allowed.count(room(other)) == 0)
        found += "\n  " + line + " includes " + other + ", but no arrows lead from " + room(file) + " to " +
                 room(other);
  }
  return found;
}

/// Arrows that no include goes along, one a line.
std::string unused(const Graph& picture, const Graph& files) {
  std::set<std::pair<std::string, std::string>> used;
  for (const auto& [file, edges] : files)
    for (const auto& [other, line] : edges) used.emplace(room(file), room(other));
  std::string found;
  for (const auto& [from, arrows] : picture)
    for (const auto& [to, line] : arrows)
      if (used.count({from, to}) == 0) found += "\n  nothing in " + from + " includes " + to;
  return found;
}

/// The folders of the solver, without the files at its root, which all of them may include and which may include
/// them.
Graph solver_folders(const Graph& files) {
  const auto folder = [](const std::string& file) -> std::string {
    if (!is_in(file, "solver")) return "";
    const std::size_t slash = file.rfind('/');
    return slash == 6 ? "" : file.substr(0, slash);
  };
  Graph folders;
  for (const auto& [file, edges] : files)
    for (const auto& [other, line] : edges)
      if (const std::string from = folder(file), to = folder(other); !from.empty() && !to.empty() && from != to)
        folders[from].emplace(to, line);
  return folders;
}

const Graph& course() {
  static const Graph graph = files_below(BYHAND_SOURCE_DIR);
  return graph;
}

/// The picture of the house.
const Graph& picture() {
  static const Graph arrows = [] {
    std::ifstream guide(fs::path(BYHAND_SOURCE_DIR) / ".github" / "CONTRIBUTING.md");
    return picture_in(guide);
  }();
  return arrows;
}

TEST(Includes, GoAlongTheArrowsOfThePicture) { EXPECT_EQ(against(picture(), course()), ""); }
TEST(Includes, GoAlongEveryArrowOfThePicture) { EXPECT_EQ(unused(picture(), course()), ""); }
TEST(Includes, FormNoCircleOfRooms) { EXPECT_EQ(circle(picture()), ""); }

// The picture may change; these do not.
TEST(Includes, OfSolverAndRendererStayInTheirRooms) {
  EXPECT_EQ(reached(picture(), "solver"), std::set<std::string>{});
  EXPECT_EQ(reached(picture(), "renderer"), std::set<std::string>{});
}
TEST(Includes, OfALessonReachNothingThatABrowserLacks) {
  const std::set<std::string> rooms = reached(picture(), "lesson");
  EXPECT_EQ(rooms.count("page"), 1U);
  for (const char* native : {"files", "terminal", "site", "practise", "course"})
    EXPECT_EQ(rooms.count(native), 0U) << native;
}
TEST(Includes, OfComputationsReachNoPicture) {
  for (const char* room : {"methods", "exact", "scenes", "laws", "catalogue", "engines"})
    for (const char* drawn : {"renderer", "page", "pictures"})
      EXPECT_EQ(reached(picture(), room).count(drawn), 0U) << room;
}

TEST(Includes, FormNoCircleOfFiles) { EXPECT_EQ(circle(course()), ""); }
TEST(Includes, FormNoCircleOfTheSolversFolders) { EXPECT_EQ(circle(solver_folders(course())), ""); }

TEST(Includes, AreFound) {
  EXPECT_EQ(included("#include \"solver/row.hpp\"  // why"), "solver/row.hpp");
  EXPECT_EQ(included("  #  include \"a.hpp\""), "a.hpp");
  EXPECT_EQ(included("#include <vector>"), "");
  EXPECT_EQ(included("// #include \"a.hpp\""), "");
  EXPECT_GT(course().size(), 200U) << "files of the course";
  EXPECT_EQ(course().at("solver/row.hpp").count("solver/jacobian.hpp"), 1U);
}

/// A small tree of sources that is gone with its test.
class Tree {
 public:
  Tree() : root_(testing::TempDir() + "byhand_includes_" + std::to_string(getpid())) {}
  ~Tree() { fs::remove_all(root_); }
  Tree(const Tree&) = delete;
  Tree& operator=(const Tree&) = delete;

  Tree& file(const std::string& name, const std::vector<std::string>& includes) {
    fs::create_directories((root_ / name).parent_path());
    std::ofstream out(root_ / name);
    for (const std::string& other : includes) out << "#include \"" << other << "\"\n";
    return *this;
  }
  Graph graph() const { return files_below(root_); }

 private:
  fs::path root_;
};

TEST(Includes, AgainstThePictureAreReported) {
  std::istringstream guide(
      "a --> b\n```mermaid\nlesson[\"01 …\"] --> exact & page\npage --> renderer\n"
      "exact --> solver\n```\nrenderer --> lesson");
  const Graph arrows = picture_in(guide);
  Tree tree;
  tree.file("renderer/canvas.hpp", {}).file("lessons/page/page.hpp", {"renderer/canvas.hpp"});
  tree.file("solver/row.hpp", {}).file("lessons/exact/top.hpp", {"solver/row.hpp"});
  tree.file("lessons/01_jacobian/main.cpp", {"lessons/page/page.hpp", "lessons/exact/top.hpp", "solver/row.hpp"});
  EXPECT_EQ(against(arrows, tree.graph()), "");
  EXPECT_EQ(unused(arrows, tree.graph()), "");
  tree.file("solver/body.hpp", {"solver/row.hpp", "renderer/canvas.hpp"});
  tree.file("lessons/exact/circle.cpp", {"lessons/page/page.hpp"});
  tree.file("lessons/course.cpp", {"lessons/page/page.hpp"});
  EXPECT_EQ(against(arrows, tree.graph()),
            "\n  lessons/course.cpp:1 includes lessons/page/page.hpp, but no arrows lead from course to page"
            "\n  lessons/exact/circle.cpp:1 includes lessons/page/page.hpp, but no arrows lead from exact to page"
            "\n  solver/body.hpp:2 includes renderer/canvas.hpp, but no arrows lead from solver to renderer");
  tree.file("lessons/page/page.hpp", {});
  EXPECT_EQ(unused(arrows, tree.graph()), "\n  nothing in page includes renderer");
}

TEST(Includes, ThatFormACircleAreReportedAsAChain) {
  Tree tree;
  tree.file("solver/a.hpp", {"solver/b.hpp"}).file("solver/b.hpp", {"solver/x/c.hpp"}).file("solver/x/c.hpp", {});
  EXPECT_EQ(circle(tree.graph()), "");
  tree.file("solver/x/c.hpp", {"d.hpp"}).file("solver/x/d.hpp", {"solver/b.hpp"});
  EXPECT_EQ(circle(tree.graph()),
            "\n  solver/b.hpp includes solver/x/c.hpp (solver/b.hpp:1)"
            "\n  solver/x/c.hpp includes solver/x/d.hpp (solver/x/c.hpp:1)"
            "\n  solver/x/d.hpp includes solver/b.hpp (solver/x/d.hpp:1)");
}

TEST(Includes, ThatFormACircleOfFoldersAreReportedAndThoseOfTheRootAreNot) {
  Tree tree;
  tree.file("solver/root.hpp", {"solver/x/c.hpp"})
      .file("solver/x/c.hpp", {})
      .file("solver/x/d.hpp", {"solver/root.hpp"});
  tree.file("solver/y/e.hpp", {"solver/x/c.hpp"});
  EXPECT_EQ(circle(solver_folders(tree.graph())), "");
  tree.file("solver/y/f.hpp", {}).file("solver/x/g.cpp", {"solver/root.hpp", "solver/y/f.hpp"});
  EXPECT_EQ(circle(tree.graph()), "");
  EXPECT_EQ(circle(solver_folders(tree.graph())),
            "\n  solver/x includes solver/y (solver/x/g.cpp:2)"
            "\n  solver/y includes solver/x (solver/y/e.hpp:1)");
}

}  // namespace
