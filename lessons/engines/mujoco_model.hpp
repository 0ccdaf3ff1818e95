#pragma once

#include <string>

#include "lessons/engines/engine.hpp"

// A scene in MuJoCo's XML, for its library and for its WebAssembly. A pin is a joint of its tree of bodies:
// coordinates that cannot part in place of rows. A body without a pin is free. Of two bodies that touch it takes
// the greater friction, so both have the same here.
namespace byhand::engines {

/// Throws std::invalid_argument for rods and for loops.
template <class M>
std::string mujoco_model(const Scene<M>& scene, const Knobs& knobs);

inline constexpr const char* mujoco_method = "one coordinate a hinge; contacts as soft rows, by Newton's method";

/// Why it is not written; empty if it is.
std::string mujoco_refusal(const Asked& asked);

}  // namespace byhand::engines
