#include "lessons/02_single_constraint/steps.hpp"
#include "lessons/02_single_constraint/swing.hpp"
#include "lessons/pictures/held_scene.hpp"

namespace byhand::single_constraint {

course::Hold in_hand(const Setting& setting) {
  return {"bob_in_hand", "The bob on its rod; it begins at the angle at which it is let go.", [setting] {
            const double length = setting.length();
            // Rows are solved in reverse: the hand's, which come last, before the rod's, whose JV is then 0.
            const VelocityStepping method{
                GaussSeidel{.sweeps = 1, .warm_start = false, .order = SweepOrder::reverse}, NoDriftCure{}};
            return pictures::in_hand<PlaneParticle>(
                {.start = {pendulum<PlaneParticle>(radians(setting.angle()), length, setting.mass()), method},
                 .h = setting.h(),
                 .view = {-1.2 * length, -1.2 * length, 2.4 * length, 2.4 * length},
                 .body = "bob",
                 .unit_of_C = "m²",
                 .law = "With b = 0 nothing brings the length back: C grows by ½h²v² in a step."});
          }};
}

}  // namespace byhand::single_constraint
