#pragma once

#include "lessons/methods/accelerations.hpp"
#include "lessons/methods/avbd.hpp"
#include "lessons/methods/controlled.hpp"
#include "lessons/methods/generalised.hpp"
#include "lessons/methods/rattle.hpp"
#include "lessons/methods/row_solvers.hpp"
#include "lessons/methods/xpbd.hpp"

namespace byhand {

/// Any method, for programs that choose one at run time. Each is a struct of choices with
///
///   Method::Work<M>                      a StepWork: what it keeps between steps; `row_solves` is its total cost
///   require_valid(method)                throws std::invalid_argument for a choice outside its range
///   refusal(scene, method)               why it cannot run a scene, in one sentence; empty if it can
///   advance(scene, method, step, work)   one time step [s]; throws std::invalid_argument with the refusal
using Method = std::variant<AnyStepping, Accelerations, Rattle, Xpbd, Avbd, Generalised, Controlled<Rattle>,
                            Controlled<Generalised>>;

}  // namespace byhand
