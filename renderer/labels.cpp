#include "renderer/labels.hpp"

#include <array>
#include <limits>

namespace byhand::renderer {

Labels::Labels(Canvas& canvas, const Rectangle& frame) : canvas_(canvas), frame_(frame) {}

void Labels::avoid(const Rectangle& on_page) { taken_.push_back(on_page); }

void Labels::avoid_disc(const Point& centre, double radius) {
  const Point at = canvas_.camera().to_page(centre);
  const double r = radius * canvas_.camera().scale;
  avoid({at.x() - r, at.y() - r, 2 * r, 2 * r});
}

void Labels::avoid_path(std::span<const Point> points) {
  constexpr double bead = 8;  // points: a path counts as a row of small squares
  for (std::size_t i = 0; i + 1 < points.size(); ++i) {
    const Point a = canvas_.camera().to_page(points[i]), b = canvas_.camera().to_page(points[i + 1]);
    const double length = std::min((b - a).norm(), 1e4);
    for (double s = 0; s <= length; s += bead) {
      const Point p = length > 0 ? Point(a + s / length * (b - a)) : a;
      if (frame_.contains(p)) avoid({p.x() - bead / 2, p.y() - bead / 2, bead, bead});
    }
  }
}

double Labels::covered(const Rectangle& box) const {
  constexpr double air = 2;  // points between a text and what it stands beside
  double area = 0;
  for (const Rectangle& other : taken_) area += box.inset(-air).overlap(other);
  return area;
}

Rectangle Labels::place(const Point& at, std::string_view text, TextStyle style, double gap) {
  struct Candidate {
    Point direction;
    Anchor anchor;
  };
  static const std::array<Candidate, 8> candidates{{{{1, 0}, Anchor::left},
                                                    {{-1, 0}, Anchor::right},
                                                    {{0, 1}, Anchor::bottom},
                                                    {{0, -1}, Anchor::top},
                                                    {{0.7, 0.7}, Anchor::bottom_left},
                                                    {{0.7, -0.7}, Anchor::top_left},
                                                    {{-0.7, 0.7}, Anchor::bottom_right},
                                                    {{-0.7, -0.7}, Anchor::top_right}}};
  const Point offset = style.offset;
  TextStyle best = style;
  double least = std::numeric_limits<double>::infinity();
  for (const double distance : {1.0, 1.7, 2.5, 3.5, 5.0, 7.0, 10.0}) {
    for (const Candidate& candidate : candidates) {
      style.anchor = candidate.anchor;
      style.offset = offset + distance * gap * candidate.direction;
      const Rectangle box = canvas_.measure(at, text, style);
      // Area outside the frame costs more than overlap.
      const double under = covered(box) + 4 * (box.width * box.height - box.overlap(frame_));
      if (under < least) least = under, best = style;
      if (least < 1e-6) break;
    }
    if (least < 1e-6) break;
  }
  canvas_.text(at, text, best);
  const Rectangle box = canvas_.measure(at, text, best);
  avoid(box);
  return box;
}

}  // namespace byhand::renderer
