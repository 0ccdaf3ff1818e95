#include "lessons/02_single_constraint/bob_picture.hpp"

#include <array>

#include "renderer/labels.hpp"

namespace byhand::single_constraint {

using namespace renderer;

BobPicture::BobPicture(const Pendulum& scene)
    : linkage(pictures::rods_and_bobs(scene)),
      first(scene.bodies().pose[0].position),
      second(scene.bodies().pose[1].position) {}

void draw(Canvas& canvas, const BobPicture& picture, const Rectangle& frame) {
  const auto [top, rest] = frame.split_rows(0.08, 0);
  const double length = (picture.second - picture.first).norm(), reach = 0.62 * length;
  const Vector round = Vector::Constant(reach);
  std::vector<Point> corners{picture.first, picture.second - round, picture.second + round};
  for (const BobPicture::Arrow& arrow : picture.arrows) corners.push_back(arrow.from + arrow.by);
  canvas.look(fit(bounds(corners), rest, 30));

  const Vector along = (picture.second - picture.first) / length, across(-along.y(), along.x());
  const Stroke guide{palette::muted, 1.5, Dash::dashed};
  if (picture.guides) {
    canvas.line(picture.second, picture.second + reach * along, guide);
    canvas.line(picture.second - reach * across, picture.second + reach * across, guide);
  }
  pictures::draw(canvas, picture.linkage);

  Labels labels(canvas, rest);
  labels.avoid_path(std::array<Point, 2>{picture.first, picture.second});
  labels.avoid_disc(picture.second, 18 / canvas.camera().scale);
  for (const BobPicture::Arrow& arrow : picture.arrows) {
    canvas.arrow(arrow.from, arrow.from + arrow.by, {arrow.colour, arrow.width});
    labels.avoid_path(std::array<Point, 2>{arrow.from, arrow.from + arrow.by});
  }
  for (const BobPicture::Arrow& arrow : picture.arrows)
    labels.place(arrow.from + 0.8 * arrow.by, arrow.label, {.size = 22, .colour = arrow.colour, .halo = 4}, 18);
  canvas.look_at_page();
  canvas.text(top.centre(), picture.title, {.size = 22, .bold = true});
}

void draw(Canvas& canvas, const std::vector<BobPicture>& pictures) {
  const auto frames = canvas.page().inset(20).cells(1, static_cast<int>(pictures.size()));
  for (std::size_t i = 0; i < pictures.size(); ++i) draw(canvas, pictures[i], frames[i]);
}

}  // namespace byhand::single_constraint
