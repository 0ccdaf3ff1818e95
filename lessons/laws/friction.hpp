#pragma once

#include "lessons/laws/law.hpp"

namespace byhand::laws {

/// What bounds friction in space: the disc of radius μλ, or each of its two axes by itself.
enum class FrictionBound { disc, square };

struct Slide {
  double distance = 0, heading = 0;  // [m], [rad] from the first axis
};
/// A particle that slides on level ground with μ = 0.5, until it stops.
Slide slide(FrictionBound bound, double heading, double speed);

/// Law 10: what bounds friction.
Law friction();

}  // namespace byhand::laws
