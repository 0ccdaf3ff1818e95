#pragma once

namespace byhand {

/// Pull that keeps `mass` [kg] at `speed` [m/s] on a circle of `radius` [m] without gravity: m·v²/R [N].
/// Throws std::invalid_argument unless mass and radius are positive and speed is finite.
double circle_tension(double mass, double speed, double radius);

}  // namespace byhand
