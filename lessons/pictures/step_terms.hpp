#pragma once

#include <string>
#include <vector>

#include "renderer/canvas.hpp"
#include "solver/step.hpp"

namespace byhand::pictures {

/// The directions of the world, each of length 1, that lie to the right and up in a picture: in space those of a
/// viewer far away.
template <class M>
using Seen = Eigen::Matrix<double, 2, M::linear>;

/// What the terms of one step do to the velocities of a scene, at the middles of its bodies and as they are seen:
/// what a film within a step shows, of any scene and step.
struct StepTerms {
  struct Arrow {
    renderer::Point from, by;  // [m], [m/s]
    renderer::Colour colour;
  };
  std::vector<Arrow> before = {}, gravity = {};
  std::vector<Arrow> rates = {};    // JV, along J, of the rows with an impulse
  std::vector<Arrow> changes = {};  // M⁻¹Jᵀλ of all rows, and apart the hand's
  std::vector<Arrow> after = {};
  double way = 0;                        // the longest hV [m]
  double gain = 0;                       // gh [m/s]
  double JV = 0, bias = 0, impulse = 0;  // over or times |l₂|, of the row with the largest impulse [m/s, m/s, N s]
  int rows = 0;                          // with an impulse, but for the hand's
};

/// The terms of the step of h [s] that leads from one state to the next.
template <class M>
StepTerms terms_of(const Simulation<M>& now, const Simulation<M>& next, double h, const Seen<M>& seen);

/// A part of the step, 0 to 5: velocities, gravity, JV, λ, velocities, poses.
struct PartInWords {
  std::string formula, words;
  renderer::Colour colour;
};
PartInWords in_words(const StepTerms& terms, int part);

/// How far a part, 2.3 for the third, has come: it moves, then holds.
double share_of(double part);

/// Draws the arrows of a part into the world of the canvas's camera, the longest about `longest` [m], and their
/// keys.
void draw_arrows(renderer::Canvas& canvas, const StepTerms& terms, double part, double longest);
/// The same with its words.
void draw_part(renderer::Canvas& canvas, const StepTerms& terms, double part, double longest);

}  // namespace byhand::pictures
