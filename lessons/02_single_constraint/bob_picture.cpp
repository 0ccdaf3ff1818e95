#include "lessons/02_single_constraint/bob_picture.hpp"

#include "renderer/labels.hpp"

namespace byhand::single_constraint {

namespace {

/// The box around the rod and its arrows [m].
Rectangle extent(const BobPicture& picture) {
  const Vector round = Vector::Constant(0.62 * (picture.second - picture.first).norm());
  std::vector<Point> corners{picture.first, picture.second - round, picture.second + round};
  for (const BobPicture::Arrow& arrow : picture.arrows) corners.push_back(arrow.from + arrow.by);
  return bounds(corners);
}

Rectangle below_title(const Rectangle& frame) { return frame.split_rows(0.08, 0).second; }

void draw(Canvas& canvas, const BobPicture& picture, const Rectangle& frame, double scale) {
  const Rectangle rest = below_title(frame);
  const double length = (picture.second - picture.first).norm(), reach = 0.62 * length;
  canvas.look({rest, extent(picture).centre(), scale});

  const Vector along = (picture.second - picture.first) / length, across(-along.y(), along.x());
  const Stroke guide{palette::muted, 1.5, Dash::dashed};
  Labels labels(canvas, rest);
  if (picture.guides) {
    const std::array<Point, 2> beyond{picture.second, picture.second + reach * along},
        tangent{picture.second - reach * across, picture.second + reach * across};
    for (const auto& line : {beyond, tangent}) {
      canvas.path(line, guide);
      labels.avoid_path(line);
    }
  }
  pictures::draw(canvas, picture.linkage);

  labels.avoid_path(std::array<Point, 2>{picture.first, picture.second});
  labels.avoid_disc(picture.second, 18 / canvas.camera().scale);
  for (BobPicture::Arrow arrow : picture.arrows) {
    arrow.from += arrow.aside / scale * Vector(-arrow.by.y(), arrow.by.x()).normalized();
    canvas.arrow(arrow.from, arrow.from + arrow.by, {arrow.colour, arrow.width, arrow.dash});
    labels.avoid_path(std::array<Point, 2>{arrow.from, arrow.from + arrow.by});
  }
  for (const BobPicture::Arrow& arrow : picture.arrows)
    labels.place(arrow.from + 0.8 * arrow.by, arrow.label, {.size = 22, .colour = arrow.colour, .halo = 4}, 18);
  canvas.look_at_page();
  canvas.text({frame.centre().x(), (frame.top() + rest.top()) / 2}, picture.title, {.size = 22, .bold = true});
}

}  // namespace

BobPicture::BobPicture(const Pendulum& scene)
    : linkage(pictures::rods_and_bobs(scene)),
      first(scene.bodies().pose[0].position),
      second(scene.bodies().pose[1].position) {}

void draw(Canvas& canvas, const std::vector<BobPicture>& pictures) {
  const int count = static_cast<int>(pictures.size());
  const auto frames = (count == 1 ? canvas.page(1.2) : canvas.page()).inset(20).grid(1, count);
  double scale = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < pictures.size(); ++i)
    scale = std::min(scale, fit(extent(pictures[i]), below_title(frames[i]), 30).scale);
  for (std::size_t i = 0; i < pictures.size(); ++i) draw(canvas, pictures[i], frames[i], scale);
}

}  // namespace byhand::single_constraint
