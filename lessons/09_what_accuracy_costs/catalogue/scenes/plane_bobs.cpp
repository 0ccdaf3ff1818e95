#include "lessons/09_what_accuracy_costs/catalogue/held.hpp"
#include "solver/constraints/normalised_distance.hpp"

namespace byhand {

template AnyScene any_scene(Scene<PlaneParticle>);

}  // namespace byhand
