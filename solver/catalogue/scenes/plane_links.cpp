#include "solver/catalogue/held.hpp"
#include "solver/constraints/pin.hpp"

namespace byhand {

template AnyScene any_scene(Scene<PlaneBody, Pin>);

}  // namespace byhand
