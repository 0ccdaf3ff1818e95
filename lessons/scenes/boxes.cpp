#include "lessons/scenes/boxes.hpp"

namespace byhand {

template Scene<PlaneBody> stack(int, double, const Surface&);
template Scene<PlaneBody> pyramid(int, const Surface&);

}  // namespace byhand
