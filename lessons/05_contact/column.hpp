#pragma once

#include "lessons/05_contact/setting.hpp"

#include "lessons/scenes/boxes.hpp"

namespace byhand::contact {

using Pile = Simulation<PlaneBody>;

/// One of the piles that a picture compares.
struct NamedPile {
  std::string name;
  Pile pile;
  int place;  // of its method among the colours
};

/// What a contact of a pile presses with [N], the contact's lower body and its upper one, as the last step left
/// it.
struct Pressed {
  int body1, body2;
  double force;
};
std::vector<Pressed> pressed(const Pile& pile, double h);

/// What each layer of a stack presses on the one below with [N], the lowest first.
std::vector<double> layer_forces(const Pile& stack, double h);

/// How a stack is corrected here: not at all while it overlaps by less than a tenth of a box, which is more than
/// it sinks, or a face tilts, while it stands; else a warm start would remember the corrections too (lesson 4).
inline constexpr Baumgarte left_alone{.slop = 0.1};

/// A stack of unit boxes of 1 kg, the topmost of `top_mass` [kg], kicked to 0.02 m/s at its top, or left alone.
Pile column(int boxes, const RowSolver& solver, double kick_speed = 0.02, double top_mass = 1);

/// Whether its topmost box has come down by half a box.
bool has_fallen(const Pile& stack);
/// Steps until `time` [s] or until it has fallen; returns when it fell, infinity if it stands.
double falls_at(Pile stack, double time, double h);

/// How long a kicked stack must stand [s].
inline constexpr double patience = 20;
/// "is down after 9.3 s", of a stack that was watched for so long; infinity if it stands.
std::string fate(double fell);
/// The same as a condition, for a verdict that says it.
Condition has_fate(const std::string& solved, double fell);

/// How far the topmost box is to the side of where it began [m].
double shift(const Pile& stack);

}  // namespace byhand::contact
