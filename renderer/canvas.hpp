#pragma once

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "renderer/camera.hpp"
#include "renderer/palette.hpp"

namespace byhand::renderer {

class DrawingSurface;
struct PageSize;
class Space;

enum class Dash { solid, dashed, dotted };

/// Style of a line; width in points.
struct Stroke {
  Colour colour = palette::ink;
  double width = 1.8;
  Dash dash = Dash::solid;
};

/// Style of an area: its fill and its outline, which is omitted at width zero.
struct Look {
  Colour fill = palette::body;
  Stroke edge{};
};

inline constexpr Look body_look{palette::body, {palette::ink, 1.8}};
inline constexpr Look fixed_look{palette::fixed, {palette::ink, 1.8}};

/// Marker shapes; `series_mark(i)` belongs to the colour `palette::series(i)`.
enum class Mark { disc, square, triangle, diamond, circle, open_square, open_triangle, open_diamond, cross };
Mark series_mark(int i);

/// The point of a text's box that is placed at the given position.
enum class Anchor { centre, left, right, top, bottom, top_left, top_right, bottom_left, bottom_right };

struct TextStyle {
  double size = 18;              ///< points; lines are 1.3 × this apart
  Colour colour = palette::ink;  ///< darkened where its contrast is too low for text
  Anchor anchor = Anchor::centre;
  bool bold = false;
  double halo = 0;      ///< width [points] of a border in the colour of the paper, for text that crosses lines
  bool upright = true;  ///< false: rotated by 90° anticlockwise
  Point offset{0, 0};   ///< points on the page
};

/// Scale of arrows for a vector quantity: one `unit` of it is drawn `scale` world units long.
struct ArrowKind {
  Colour colour = palette::force;
  double scale = 1;
  std::string unit{};
};

/// A text that a canvas lists instead of drawing it.
struct Label {
  std::string text;  // with its markup
  Rectangle box;     // points on the page
  Colour colour;
};

/// A page, drawn on pixels (PixelCanvas) or as SVG (SvgCanvas). Positions and lengths are in world units of the
/// current camera; widths of lines and sizes of text are in points. A page is always 720 points high, so a picture
/// looks the same at any resolution; on one that is higher than wide no text crosses the edge. Later shapes cover
/// earlier ones. Text is UTF-8: `_x`, `^x`, `_{…}`, `^{…}` are subscripts and superscripts (a backslash escapes
/// `_`, `^` and `\`), combining marks (λ̇) are supported, and '\n' begins a new line. Coordinates that are not
/// finite leave a gap.
class Canvas {
 public:
  int width() const;  ///< pixels
  int height() const;
  /// The whole page in points: (0, 0) lower left, 720 high.
  Rectangle page() const;
  /// The same for a picture of one panel: at most `most` times as high as wide, and what is below is cut off.
  Rectangle page(double most);

  /// Empties the page, resets the camera to the page in points and removes the clipping.
  void clear(Colour paper = palette::paper);
  /// Sets the camera of later shapes; `look_at_page` sets the page in points.
  void look(const Camera& camera);
  void look_at_page();
  const Camera& camera() const;
  /// Clips later shapes to the rectangle (points on the page, rounded to pixels), or to the whole page.
  void clip(const std::optional<Rectangle>& rectangle);

  void disc(const Point& centre, double radius, const Look& look = body_look);
  /// A box with full side lengths `size`, rotated by `angle` [rad] anticlockwise.
  void box(const Point& centre, const Point& size, double angle, const Look& look = body_look);
  /// An axis-aligned box, rounded to whole pixels: bars, cells of a heat map.
  void rectangle(const Rectangle& rectangle, const Look& look);
  /// A convex polygon, clockwise or anticlockwise.
  void polygon(std::span<const Point> corners, const Look& look);
  /// A bar with round ends, `thickness` points across.
  void rod(const Point& a, const Point& b, const Look& look = {palette::constraint, {palette::ink, 0}},
           double thickness = 7);
  void line(const Point& a, const Point& b, const Stroke& stroke = {});
  void path(std::span<const Point> points, const Stroke& stroke = {});
  /// A path whose opacity rises from zero at its first point to one at its last.
  void trail(std::span<const Point> points, const Stroke& stroke = {});
  /// A coil from `a` to `b` with `turns` windings, `thickness` points across.
  void spring(const Point& a, const Point& b, int turns = 10, double thickness = 18,
              const Stroke& stroke = {palette::constraint});
  /// A revolute joint between bodies.
  void hinge(const Point& at);
  /// A fixed support; `body_side` is the direction from it to the body.
  void anchor(const Point& at, const Point& body_side = {0, -1});
  /// A fixed surface from `a` to `b`, hatched on its right.
  void ground(const Point& a, const Point& b);
  void mark(const Point& at, Mark mark, Colour colour, double size = 9);
  void arrow(const Point& from, const Point& to, const Stroke& stroke = {palette::force, 3});
  /// An arrow along `kind.scale · quantity`; a dot if it vanishes.
  void vector(const Point& from, const Point& quantity, const ArrowKind& kind);
  /// The key of an arrow scale: an arrow for a round value, about 60 points long, labelled with `name`, value and
  /// unit. `at` (points on the page) is its left end.
  void arrow_key(const Point& at, const ArrowKind& kind, std::string_view name);
  /// A dimension line from a to b with ticks and a text, shifted by `offset` points to its left.
  void dimension(const Point& a, const Point& b, std::string_view text, double offset = 18);
  void text(const Point& at, std::string_view text, const TextStyle& style = {});
  /// Draws no text from now on; `labels` lists it since `clear`, for terminals, which write letters themselves.
  void list_labels();
  const std::vector<Label>& labels() const;
  /// Bounding box of the text, in points on the page.
  Rectangle measure(const Point& at, std::string_view text, const TextStyle& style = {}) const;

  /// Draws a scene in space into its camera's frame. Place labels at `space.project(point)`.
  void draw(const Space& space);

 protected:
  Canvas(Canvas&&) noexcept;
  Canvas& operator=(Canvas&&) noexcept;
  Canvas(const PageSize& size, std::unique_ptr<DrawingSurface> surface);
  ~Canvas();
  DrawingSurface& surface() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace byhand::renderer
