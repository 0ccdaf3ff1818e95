#pragma once

#include "solver/methods/accelerations.hpp"
#include "solver/methods/avbd.hpp"
#include "solver/methods/rattle.hpp"
#include "solver/methods/xpbd.hpp"
#include "solver/step.hpp"

namespace byhand {

/// Any method, for programs that choose one at run time. Each family is a struct of choices with
///
///   Family::Work<M>                          a StepWork: what it keeps between steps; `row_solves` counts its
///   cost so far require_valid(family)                    throws std::invalid_argument for a choice outside its
///   range refusal(scene, family)                   why it cannot run a scene, in one sentence; empty where it can
///   advance(scene, family, step, work)       one time step [s]; throws std::invalid_argument with the refusal
using Method = std::variant<VelocityStepping, Accelerations, Rattle, Xpbd, Avbd>;

}  // namespace byhand
