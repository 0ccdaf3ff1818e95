#include "solver/scenes/boxes.hpp"
#include "solver/catalogue/held.hpp"

namespace byhand {

template AnyScene any_scene(Boxes);

}  // namespace byhand
