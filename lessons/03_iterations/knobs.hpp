#pragma once

#include "lessons/scenes/chain.hpp"
#include "lessons/tutor/lesson.hpp"

namespace byhand::iterations {

/// What a reader can turn in this lesson.
struct Knobs {
  tutor::Parameter<int> links;
  tutor::Parameter<double> length, mass, h;
  tutor::Parameter<int> sweeps;
  tutor::Parameter<double> beta, angle;
  tutor::Parameter<std::string> start;
  tutor::Parameter<double> ratio;

  /// The lesson's chain, hanging at rest, or as many links as are asked for.
  ChainOptions chain() const { return chain(links()); }
  ChainOptions chain(int count) const {
    return {.links = count, .length = length(), .mass = mass(), .end_mass = mass()};
  }
  /// Whether steps begin with the λ of the last one.
  bool warm() const { return start() == "warm"; }
  /// gh: how fast everything falls once gravity is in V [m/s].
  double fall() const { return gravity * h(); }
  /// Of the whole chain [N].
  double weight() const { return links() * mass() * gravity; }

  static constexpr double gravity = 9.81;  // [m/s²], as Scene has it
};

// The steps, each in the file of its name.
void two_links(tutor::Page& page, const Knobs& knobs);
/// The film of step 1.
void within_a_sweep(tutor::Page& page, const Knobs& knobs);
void one_sweep(tutor::Page& page, const Knobs& knobs);
void all_at_once(tutor::Page& page, const Knobs& knobs);
void many_sweeps(tutor::Page& page, const Knobs& knobs);
void twice_as_long(tutor::Page& page, const Knobs& knobs);
void warm_start(tutor::Page& page, const Knobs& knobs);
void side_by_side(tutor::Page& page, const Knobs& knobs);
void heavy_end(tutor::Page& page, const Knobs& knobs);
void price_of_direct(tutor::Page& page, const Knobs& knobs);
void limit_of_jacobi(tutor::Page& page, const Knobs& knobs);

/// The chain of step 7.
tutor::Hold in_hand(const Knobs& knobs);

}  // namespace byhand::iterations
