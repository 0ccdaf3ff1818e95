#include "solver/catalogue/held.hpp"
#include "solver/constraints/pin.hpp"

namespace byhand {

template AnyScene any_scene(Scene<SpaceBody, Pin>);

}  // namespace byhand
