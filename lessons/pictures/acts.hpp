#pragma once

#include <string>
#include <vector>

#include "renderer/canvas.hpp"

namespace byhand::pictures {

/// The text with breaks where it would be wider than so many points.
std::string wrapped(const renderer::Canvas& canvas, const std::string& text, double width,
                    const renderer::TextStyle& style);

/// 0 … 1 with no speed at both ends: 3s² − 2s³, clamped.
double eased(double share);

/// A film of what happens within one step, act by act. Each act brings in one term of a formula: it moves, eased,
/// and then holds, so that it can be seen.
class Acts {
 public:
  struct Act {
    std::string formula, words;                        // "JV = 0.28 m²/s", one sentence
    renderer::Colour colour = renderer::palette::ink;  // of the term, here and on the bodies
  };
  static constexpr double moving = 1.4, holding = 1.0;  // [s] of each act

  explicit Acts(std::vector<Act> acts) : acts_(std::move(acts)) {}

  double seconds() const { return static_cast<double>(acts_.size()) * (moving + holding); }
  /// How far act `i` has come at `time` [s]: 0 before it begins, 1 once it holds.
  double share(std::size_t i, double time) const;
  /// The act at `time` [s].
  std::size_t now(double time) const;

  /// Lists all acts: those to come are pale, the present one is bold. The places do not depend on the time. A low
  /// frame gets the present one alone.
  void draw(renderer::Canvas& canvas, const renderer::Rectangle& frame, double time) const;

 private:
  std::vector<Act> acts_;
};

/// The arrow of a term that grows to `share` of its length; none at 0.
void draw_growing(renderer::Canvas& canvas, const renderer::Point& from, const renderer::Point& by, double share,
                  const renderer::Stroke& stroke);

/// The mark of a right angle at `corner` between two directions.
void draw_right_angle(renderer::Canvas& canvas, const renderer::Point& corner, const renderer::Point& one,
                      const renderer::Point& other, double side = 26);

}  // namespace byhand::pictures
