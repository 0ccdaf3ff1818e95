#pragma once

#include "lessons/07_space/setting.hpp"

namespace byhand::space {

/// Coulomb's disc, or each axis by itself.
enum class Bounds { disc, pyramid };

/// The ways of pucks that are pushed off from the origin on level ground, one for each heading [rad]: where each
/// is after every step until it rests [m], x and z.
using Way = std::vector<Eigen::Vector2d>;
std::vector<Way> slide(const Setting& setting, const std::vector<double>& headings, Bounds bounds,
                       double axes_turned = 0);

/// How far something goes that loses a·h of its speed [m/s] in each step until it rests [m].
double stopping_distance(double speed, double deceleration, double h);

}  // namespace byhand::space
