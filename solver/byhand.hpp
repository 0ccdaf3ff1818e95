#pragma once

// Everything that most users of the library need. Other families of methods are in lessons/methods/method.hpp.

#include "solver/constraints/compiled.hpp"
#include "solver/constraints/contact_manifold.hpp"
#include "solver/constraints/distance.hpp"
#include "solver/constraints/hinge.hpp"
#include "solver/constraints/limit.hpp"
#include "solver/constraints/motor.hpp"
#include "solver/constraints/normalised_distance.hpp"
#include "solver/constraints/pin.hpp"
#include "solver/constraints/rope.hpp"
#include "solver/constraints/slider.hpp"
#include "solver/constraints/spring.hpp"
#include "solver/constraints/weld.hpp"
#include "solver/measure.hpp"
