// What a scene's file comes to at a terminal: watched_scene FILE STEPS prints x, y, cosine and sine of every body
// after so many steps, as JSON; in space x, y, z and the rows of its rotation.

#include <fstream>
#include <iostream>
#include <iterator>
#include <nlohmann/json.hpp>

#include "lessons/stage/watched.hpp"

int main(int, char** argv) {
  std::ifstream stream(argv[1]);
  byhand::SceneFile file = byhand::read_scene(std::string(std::istreambuf_iterator<char>(stream), {}));
  file.duration = std::stod(argv[2]) * file.step;
  const byhand::stage::Watched run = byhand::stage::watch(file);
  nlohmann::json numbers = nlohmann::json::array();
  for (const auto& [position, rotation, moves] : run.instants.back())
    if (file.scene.index() < 2) {
      for (const double x : {position.x(), position.y(), rotation(0, 0), rotation(1, 0)}) numbers.push_back(x);
    } else {
      for (const double x : position) numbers.push_back(x);
      for (const auto& row : rotation.rowwise())
        for (const double x : row) numbers.push_back(x);
    }
  std::cout << nlohmann::json{{"numbers", numbers}, {"stopped", run.stopped}} << "\n";
}
