#pragma once

#include "lessons/pictures/prelude.hpp"
#include "lessons/scenes/chain.hpp"

namespace byhand::iterations {

using namespace course;
using namespace renderer;
using pictures::at, pictures::curve, pictures::each;

/// What a reader can turn in this lesson.
struct Knobs {
  course::Parameter<int> links;
  course::Parameter<double> h;
  course::Parameter<int> sweeps;
  course::Parameter<double> beta;
  course::Parameter<std::string> start;
  course::Parameter<double> ratio;
  double length = 2, mass = 3;  // of a link [m], of a bob [kg]
  double angle = 20;            // from which the chain of step 7 is released [°]

  /// The lesson's chain, hanging at rest, or as many links as are asked for.
  ChainOptions chain() const { return chain(links()); }
  ChainOptions chain(int count) const {
    return {.links = count, .length = length, .mass = mass, .end_mass = mass};
  }
  /// Whether steps begin with the λ of the last one.
  bool warm() const { return start() == "warm"; }
  /// gh: how fast everything falls once gravity is in V [m/s].
  double fall() const { return gravity * h(); }
  /// Of the whole chain [N].
  double weight() const { return links() * mass * gravity; }

  static constexpr double gravity = 9.81;  // [m/s²], as Scene has it
};

// The steps, each in the file of its name.
void two_links(course::Page& page, const Knobs& knobs);
/// The film of step 1.
void within_a_sweep(course::Page& page, const Knobs& knobs);
void one_sweep(course::Page& page, const Knobs& knobs);
void all_at_once(course::Page& page, const Knobs& knobs);
void many_sweeps(course::Page& page, const Knobs& knobs);
void twice_as_long(course::Page& page, const Knobs& knobs);
void warm_start(course::Page& page, const Knobs& knobs);
void side_by_side(course::Page& page, const Knobs& knobs);
void heavy_end(course::Page& page, const Knobs& knobs);
void price_of_direct(course::Page& page, const Knobs& knobs);
void limit_of_jacobi(course::Page& page, const Knobs& knobs);

/// The chain of step 7.
course::Hold in_hand(const Knobs& knobs);

}  // namespace byhand::iterations
