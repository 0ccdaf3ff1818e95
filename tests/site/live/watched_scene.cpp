// What a scene's file comes to at a terminal: watched_scene FILE STEPS prints x, y, cosine and sine of every body
// after so many steps, as JSON.

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
  for (const byhand::Placement& body : run.instants.back())
    for (const double x : {body.position.x(), body.position.y(), body.rotation(0, 0), body.rotation(1, 0)})
      numbers.push_back(x);
  std::cout << nlohmann::json{{"numbers", numbers}, {"stopped", run.stopped}} << "\n";
}
