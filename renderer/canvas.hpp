#pragma once

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "renderer/camera.hpp"
#include "renderer/image.hpp"
#include "renderer/palette.hpp"

namespace byhand::renderer {

class Space;

enum class Dash { solid, dashed, dotted };

/// A line: its width in points.
struct Stroke {
  Colour colour = palette::ink;
  double width = 1.8;
  Dash dash = Dash::solid;
};

/// How an area looks: what fills it and, if its width is not zero, the line around it.
struct Look {
  Colour fill = palette::body;
  Stroke edge{};
};

inline constexpr Look body_look{palette::body, {palette::ink, 1.8}};
inline constexpr Look fixed_look{palette::fixed, {palette::ink, 1.8}};

/// Markers that differ in shape as well as in colour; `series_mark(i)` goes with `palette::series(i)`.
enum class Mark { disc, square, triangle, diamond, circle, open_square, open_triangle, open_diamond, cross };
Mark series_mark(int i);

/// Which point of a text's box lies at the given place.
enum class Anchor { centre, left, right, top, bottom, top_left, top_right, bottom_left, bottom_right };

struct TextStyle {
  double size = 18;  ///< points from one line to a comfortable next are 1.3 × this
  Colour colour = palette::ink;
  Anchor anchor = Anchor::centre;
  bool bold = false;
  double halo = 0;      ///< points of paper around the letters, for text that crosses lines
  bool upright = true;  ///< false: turned a quarter to the left
  Point offset{0, 0};   ///< points, added after the camera
};

/// What the length of an arrow means: `scale` world units are drawn for one `unit` of the quantity.
struct ArrowKind {
  Colour colour = palette::force;
  double scale = 1;
  std::string unit{};
};

/// One frame, drawn without a window. Shapes are given in the units of the camera that looks at them; widths
/// of lines and sizes of text in points, of which every page is 720 high whatever its pixels, so that all
/// sizes of picture look alike. Later shapes cover earlier ones. Text is UTF-8; `_x`, `^x`, `_{…}`, `^{…}`
/// lower and raise (a backslash before `_`, `^` or `\` prints the sign itself), combining marks (λ̇) sit on
/// their letter, and '\n' begins a new line. Coordinates that are not finite are drawn as gaps.
class Canvas {
 public:
  /// A page of `width` × `height` pixels (16 … 8192 each, else std::invalid_argument).
  /// Throws EnvironmentError when there is no OpenGL or the font is not installed.
  Canvas(int width, int height);
  Canvas(Canvas&&) noexcept;
  Canvas& operator=(Canvas&&) noexcept;
  ~Canvas();

  int width() const;
  int height() const;
  /// The whole page in points: (0, 0) lower left, 720 high.
  Rectangle page() const;
  /// What draws: OpenGL's renderer and version and how the context was made. For manifest.json.
  const std::string& describe() const;

  /// An empty page: the camera shows the page in points, nothing is clipped.
  void clear(Colour paper = palette::paper);
  /// Later shapes are given in the world of this camera; `look_at_page` returns to points.
  void look(const Camera& camera);
  void look_at_page();
  const Camera& camera() const;
  /// Later shapes are cut off outside the rectangle (points on the page, rounded to pixels); nothing: the
  /// whole page.
  void clip(const std::optional<Rectangle>& rectangle);

  void disc(const Point& centre, double radius, const Look& look = body_look);
  /// A box of the given width and height, turned by `angle` radians anticlockwise.
  void box(const Point& centre, const Point& size, double angle, const Look& look = body_look);
  /// An upright box with its sides on whole pixels: bars, cells of a map.
  void rectangle(const Rectangle& rectangle, const Look& look);
  /// A convex polygon, in either sense of turning.
  void polygon(std::span<const Point> corners, const Look& look);
  /// A bar with round ends, `thickness` points across.
  void rod(const Point& a, const Point& b, const Look& look = {palette::constraint, {palette::ink, 0}},
           double thickness = 7);
  void line(const Point& a, const Point& b, const Stroke& stroke = {});
  void path(std::span<const Point> points, const Stroke& stroke = {});
  /// A path that fades from nothing at its first point to full colour at its last.
  void trail(std::span<const Point> points, const Stroke& stroke = {});
  /// A coil from `a` to `b` with `turns` windings, `thickness` points across.
  void spring(const Point& a, const Point& b, int turns = 10, double thickness = 18,
              const Stroke& stroke = {palette::constraint});
  /// A pin that joins bodies.
  void hinge(const Point& at);
  /// A pin held by the world: a hatched bracket; `body_side` is where the body hangs (below) or stands.
  void anchor(const Point& at, const Point& body_side = {0, -1});
  /// A surface from `a` to `b`, hatched on its right-hand side seen along that way.
  void ground(const Point& a, const Point& b);
  void mark(const Point& at, Mark mark, Colour colour, double size = 9);
  void arrow(const Point& from, const Point& to, const Stroke& stroke = {palette::force, 3});
  /// An arrow of `kind.scale · quantity`; a vanishing quantity draws a dot.
  void vector(const Point& from, const Point& quantity, const ArrowKind& kind);
  /// A sample arrow, drawn in the camera's scale: a round quantity about 60 points long, its value and unit
  /// and `name` beside it. `at` (points on the page) is its left end.
  void arrow_key(const Point& at, const ArrowKind& kind, std::string_view name);
  /// A line with ticks at both ends and a text at its middle, kept `offset` points to the left of the way
  /// from a to b.
  void dimension(const Point& a, const Point& b, std::string_view text, double offset = 18);
  void text(const Point& at, std::string_view text, const TextStyle& style = {});
  /// The box on the page (points) that `text` would fill.
  Rectangle measure(const Point& at, std::string_view text, const TextStyle& style = {}) const;

  /// A scene in space, drawn into its camera's frame; labels go over it at `space.project(point)`.
  void draw(const Space& space);

  /// The page as it stands.
  Image image();

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace byhand::renderer
