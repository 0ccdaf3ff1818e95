#include "lessons/04_baumgarte/rod_end.hpp"

namespace byhand::baumgarte {

void draw_rod_end(Canvas& canvas, const Rectangle& frame, double error, double reach, const std::string& words) {
  constexpr double radius = 11, line = 26;  // [points]
  const Rectangle scene{frame.x, frame.y + line, frame.width, frame.height - line};
  const Camera camera{scene, {0, 0}, (scene.height / 2 - radius - 2) / reach};
  const double half = 0.5 * scene.width / camera.scale, top = scene.height / camera.scale;
  canvas.clip(scene);
  canvas.look(camera);
  canvas.line({-0.9 * half, 0}, {0.9 * half, 0}, {palette::theory, 2, Dash::dashed});
  canvas.rod({0, top}, {0, -error}, {palette::constraint, {palette::ink, 0}}, 5);
  canvas.disc({0, -error}, radius / camera.scale);
  canvas.look_at_page();
  canvas.clip({});
  canvas.text({frame.centre().x(), frame.y + line / 2}, words, {.size = 18, .colour = palette::error});
}

}  // namespace byhand::baumgarte
