#pragma once

#include "practise.hpp"

namespace plain {
/// A row between the two bodies.
struct Row {
  BodyRow J, W;       // W = M⁻¹Jᵀ
  double K = 0;       // J M⁻¹ Jᵀ
  double b = 0;       // bias
  double lambda = 0;  // all impulses so far; at first those of the step before
};
}  // namespace plain

/// Once a step, before its sweeps: applies the λ that the rows remember.
void warm_start(std::span<Row> rows, Velocities& V);

/// One Gauss–Seidel sweep: solves each row in order and adds its impulse to λ and to V.
void sweep(std::span<Row> rows, Velocities& V);

#define FUNCTIONS warm_start, sweep
