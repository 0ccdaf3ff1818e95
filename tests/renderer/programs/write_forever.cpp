// Writes frame after frame into the given folder until it is killed.

#include "renderer/frames.hpp"

int main(int, char** arguments) {
  using namespace byhand::renderer;
  Image image{640, 360, {}};
  for (int i = 0; i < 3 * 640 * 360; ++i) image.rgb.push_back(std::uint8_t(i * 2654435761u >> 13));
  FrameWriter writer(arguments[1]);
  for (;;) writer.write(image);
}
