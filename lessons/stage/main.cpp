// Runs a scene from a file. Started by `lessons/run scene`.

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "lessons/files/atomic_file.hpp"
#include "lessons/files/options.hpp"
#include "lessons/files/streams.hpp"
#include "lessons/stage/pages.hpp"

namespace {

namespace fs = std::filesystem;
using namespace byhand;
using Arguments = std::vector<std::string>;

constexpr auto help =
    R"(./lessons/run scene FILE [--doctor] [--choose] [--method NAME] [--set NAME=VALUE] [OPTIONS]

Runs a scene that you wrote down, shows it, and says whether it will hold.

A scene is a JSON file, in SI units; y is up, and comments are allowed. This is a whole one:

  {
    "model": "plane",                          // plane, space, plane particles, space particles
    "bodies": [
      {"name": "ground", "fixed": true, "shape": {"half_space": [0, 1]}},
      {"name": "post", "fixed": true, "position": [0, 3]},
      {"name": "arm", "mass": 2, "inertia": [0.7], "position": [1, 3]},
      {"name": "crate", "mass": 5, "shape": {"box": [1, 1]}, "position": [4, 2], "angle": "30°"}
    ],
    "constraints": [
      {"kind": "pin", "bodies": ["post", "arm"], "point": [0, 3]},
      {"kind": "limit", "on": "turn", "bodies": ["post", "arm"], "at_most": "45°"}
    ],
    "method": {"solver": "gauss_seidel", "sweeps": 10, "cure": "baumgarte", "beta": 0.2, "substeps": 1}
  }

Without "method" the rows are solved by graph: directly where they form chains, trees and columns, else by sweeps
until they converge. Begin with a scene of the course and change it:

  ./lessons/run scene --list                         the scenes of the course
  ./lessons/run scene chain                          one of them, by its name
  ./lessons/run scene my.json --set h=1/120          with another step; --list-parameters lists the knobs
  ./lessons/run scene my.json --method gauss_seidel --set sweeps=4
  ./lessons/run scene my.json --doctor               which law breaks it, by how much, and which knob to turn
  ./lessons/run scene my.json --choose               the cheapest method for what its "accuracy" asks, with its code
  ./lessons/run scene my.json --film webm            pictures and film in output/scenes/
  ./lessons/run scene --schema > scene.schema.json   every member, with unit, range and meaning

  FILE            a file, or the name of a scene of the course
  --doctor        only what the laws say of it, before it is run
  --choose        only which method is the cheapest that is accurate enough: "accuracy": {"drift": 0.001} in the file;
                  drift [m], trajectory [m], energy, momentum, reaction, contact [m/s]. It takes about ten
                  seconds, and up to --set patience=40 where it has found nothing by then; with more patience it
                  also looks longer for what is cheaper
  --method NAME   gauss_seidel, jacobi, direct, conjugate_sweeps, newton, by_graph, rattle, midpoint, rk4, xpbd, avbd
  --write NEW     writes the scene with all members as they were understood
  OPTIONS         as of a lesson: --frames none, --quality high, --check, --output DIR, --step N, --plain, --quiet

Exit status: 0 fine, 2 bad usage or a file that is not a scene, 3 the environment (no OpenGL, disk full).
)";

std::string read(const fs::path& path) {
  std::error_code error;
  const fs::file_status status = fs::status(path, error);
  if (fs::is_directory(status)) throw std::invalid_argument(path.string() + " is a folder, not a scene");
  if (!fs::exists(status))
    throw std::invalid_argument("There is no file " + path.string() + "; --list shows the scenes of the course");
  if (!fs::is_regular_file(status)) throw std::invalid_argument(path.string() + " is no regular file");
  std::ifstream stream(path, std::ios::binary);
  std::string text(10'000'002, '\0');
  stream.read(text.data(), static_cast<std::streamsize>(text.size()));
  text.resize(static_cast<std::size_t>(stream.gcount()));
  if (stream.bad() || (stream.fail() && !stream.eof()))
    throw std::invalid_argument(path.string() + " cannot be read");
  return text;
}

fs::path file_called(const std::string& name) {
  const fs::path own = fs::path(BYHAND_SCENES) / (name + ".json");
  const bool plain = name.find('/') == std::string::npos;
  return plain && !fs::exists(name) && fs::exists(own) ? own : fs::path(name);
}

/// The name of a folder for a file's output: [a-z0-9_].
std::string folder_of(const fs::path& file) {
  std::string stem = file.stem().string();
  for (char& c : stem) {
    c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    if (!std::isalnum(static_cast<unsigned char>(c)) || static_cast<unsigned char>(c) > 127) c = '_';
  }
  return stem.substr(0, 60);
}

int list() {
  std::vector<fs::path> files;
  for (const auto& entry : fs::directory_iterator(BYHAND_SCENES))
    if (entry.path().extension() == ".json") files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  for (const fs::path& file : files) fmt::print("{:22} {}\n", file.stem().string(), read_scene(read(file)).title);
  return 0;
}

/// Takes an option with its value out of the arguments; empty if it is not there.
std::string take(Arguments& arguments, const std::string& option) {
  for (std::size_t i = 0; i < arguments.size(); ++i) {
    if (arguments[i] == option) {
      if (i + 1 == arguments.size()) throw std::invalid_argument(option + " needs a value");
      const std::string value = arguments[i + 1];
      arguments.erase(arguments.begin() + static_cast<long>(i), arguments.begin() + static_cast<long>(i) + 2);
      return value;
    }
    if (arguments[i].starts_with(option + "=")) {
      const std::string value = arguments[i].substr(option.size() + 1);
      arguments.erase(arguments.begin() + static_cast<long>(i));
      return value;
    }
  }
  return {};
}
bool has(const Arguments& arguments, const std::string& option) {
  return std::any_of(arguments.begin(), arguments.end(),
                     [&](const auto& one) { return one == option || one.starts_with(option + "="); });
}

int run(Arguments arguments) {
  if (has(arguments, "--help")) return fmt::print("{}", help), 0;
  if (has(arguments, "--schema")) return fmt::print("{}", scene_schema()), 0;
  if (has(arguments, "--list")) return list();
  if (arguments.empty() || arguments.front().starts_with("--"))
    throw std::invalid_argument(
        "Which scene? ./lessons/run scene FILE; --help explains, --list shows the scenes of the course");
  const fs::path path = file_called(arguments.front());
  arguments.erase(arguments.begin());
  SceneFile file;
  try {
    file = read_scene(read(path));
  } catch (const std::invalid_argument& bad) {
    const std::string sentence = bad.what();
    throw std::invalid_argument(sentence.starts_with("line ") ? path.string() + ", " + sentence : sentence);
  }
  if (const std::string target = take(arguments, "--write"); !target.empty()) {
    course::write_whole(target, write_scene(file));
    return 0;
  }
  if (const std::string method = take(arguments, "--method"); !method.empty()) {
    arguments.push_back("--set");
    arguments.push_back("solver=" + method);
  }
  const bool examine = std::erase(arguments, "--doctor") > 0, choose = std::erase(arguments, "--choose") > 0;
  if (examine && choose)
    throw std::invalid_argument("--doctor and --choose are two steps of a scene's page: one at a time");
  if (examine || choose)
    arguments.insert(arguments.end(), {"--step", choose ? stage::choosers_step : stage::doctors_step,
                                       "--no-interactive", "--frames", "none"});
  if (!has(arguments, "--output"))
    arguments.insert(arguments.end(), {"--output", (course::default_output() / "scenes").string()});
  std::vector<const char*> words{"scene"};
  for (const std::string& argument : arguments) words.push_back(argument.c_str());
  course::Lesson lesson = stage::page_of(file, folder_of(path), choose);
  return lesson.run(static_cast<int>(words.size()), words.data());
}

}  // namespace

int main(int argc, char** argv) {
  return course::exit_status_of([&] { return run({argv + 1, argv + argc}); });
}
