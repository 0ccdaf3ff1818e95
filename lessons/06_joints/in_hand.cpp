#include "lessons/06_joints/linkage.hpp"
#include "lessons/06_joints/steps.hpp"
#include "lessons/pictures/held_scene.hpp"

namespace byhand::joints {

course::Hold in_hand(const Setting& setting) {
  return {
      "linkage_in_hand", "The four-bar linkage; it begins where it is let go.", [setting] {
        const FourBarOptions bars = bars_of(setting, radians(setting.angle()));
        const double arm = bars.arm, across = bars.coupler + 2.4 * arm;
        return pictures::in_hand<PlaneBody>(
            {.start = {four_bar(bars), exactly()},
             .h = setting.h(),
             .view = {-1.2 * arm, -1.2 * arm, across, 2.4 * arm},
             .body = "bar",
             .law = "Where the bars lie on one line, one row repeats the others, and λ is not unique (step 4)."});
      }};
}

}  // namespace byhand::joints
