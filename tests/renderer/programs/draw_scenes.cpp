// Draws every scene into the given folder: run with other backends, threads and vector widths to compare pixels.

#include <cstdio>
#include <exception>
#include <filesystem>

#include "renderer/opengl/pixel_canvas.hpp"
#include "tests/renderer/png_file.hpp"
#include "tests/renderer/scenes.hpp"

int main(int, char** arguments) {
  using namespace byhand::renderer;
  try {
    PixelCanvas canvas(854, 480);
    std::puts(canvas.describe().c_str());
    for (const scenes::Scene& scene : scenes::all) {
      canvas.clear();
      scene.draw(canvas);
      write_png(std::filesystem::path(arguments[1]) / (std::string(scene.name) + ".png"), canvas.image());
    }
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 3;
  }
}
