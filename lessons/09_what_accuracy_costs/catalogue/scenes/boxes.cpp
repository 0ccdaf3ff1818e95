#include "lessons/scenes/boxes.hpp"
#include "lessons/09_what_accuracy_costs/catalogue/held.hpp"

namespace byhand {

template AnyScene any_scene(Scene<PlaneBody>);

}  // namespace byhand
