// Writes every scene as SVG into the given folder. Links the part of the renderer that needs no OpenGL, and
// nothing else of it.

#include <cstdio>
#include <exception>
#include <fstream>

#include "renderer/svg_canvas.hpp"
#include "tests/renderer/scenes.hpp"

int main(int, char** arguments) {
  using namespace byhand::renderer;
  try {
    for (const scenes::Scene& scene : scenes::all) {
      SvgCanvas canvas(1280, scene.name);
      scene.draw(canvas);
      std::ofstream(std::string(arguments[1]) + "/" + scene.name + ".svg")
          << canvas.svg(scene.name, "a scene of the tests");
    }
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 3;
  }
}
