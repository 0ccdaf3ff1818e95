#include "lessons/scenes/boxes.hpp"

namespace byhand {

template Boxes stack(int, double, const Surface&);
template Boxes pyramid(int, const Surface&);

}  // namespace byhand
