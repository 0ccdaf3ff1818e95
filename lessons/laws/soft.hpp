#pragma once

#include "lessons/laws/law.hpp"

namespace byhand::laws {

/// A mass on a spring and damper whose force is applied as gravity is: settles (also where it swings on undamped)
/// or explodes.
Outcome explicit_spring(double omega_h, double damping_ratio);

/// A straight weightless chain of unit links that are soft constraints, swept once a step from a warm start, each
/// bob off by about a ten-millionth of a link.
struct SoftChain {
  int links = 30;
  double frequency = 0.2;  // times the step: f h
  double damping_ratio = 1;
  bool relax = false;
  int sweeps = 1;
};
Outcome run(const SoftChain& chain);

/// The share of its speed [m/s] that a particle on a soft rod of 1 m keeps for a second, the rows being relaxed
/// with a stale or a fresh Jacobian.
double speed_left(double speed, double step, bool refresh);

/// Law 11: springs and soft constraints.
Law springs();

/// Law 12: substeps or sweeps.
Law substeps();

/// Law 14: a stale Jacobian in the relax pass.
Law stale_rows();

}  // namespace byhand::laws
