// Writes lessons/scenes/*.json and the schema from the scenes' code: write_scenes ROOT.

#include <fstream>

#include "tests/lessons/scene_file/course_scenes.hpp"

int main(int, char** argv) {
  const std::string lessons = std::string(argv[1]) + "/lessons/";
  std::ofstream(lessons + "scene_file/scene.schema.json") << byhand::scene_schema();
  for (const auto& scene : byhand::test::course_scenes())
    std::ofstream(lessons + "scenes/" + scene.name + ".json") << byhand::write_scene(scene.file());
}
