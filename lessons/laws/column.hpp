#pragma once

#include "lessons/laws/closed_forms.hpp"
#include "lessons/laws/law.hpp"

// Columns of boxes of 1 kg, one upon the other, which laws 9, 17, 18, 19 and 20 are about.
namespace byhand::laws {

struct Column {
  int boxes = 10;
  BoxSize size = {};
  int sweeps = 10;         // of Gauss–Seidel from a warm start; 0 solves each step exactly, by an active set
  double beta = 0;         // Baumgarte's; 0 corrects nothing
  double gravity = 9.81;   // [m/s²]
  double top_mass = 1;     // of the topmost box [kg]
  double step = 1.0 / 60;  // [s]
  int substeps = 1;
  double frequency = 0;  // of soft contacts [Hz], critically damped; 0: hard ones, with β
  double friction = 0.6;
  double regularisation = 0;  // of the exact solve
  int steps = 3000;
};

/// Whether a column that is pushed sideways by a ten-millionth of a metre per second stays: settles, drifts (leans
/// further and further) or explodes (falls).
Outcome lean(const Column& column);

/// Whether a column comes to rest that is put down: its first steps bear no weight, so that it sinks by about gh².
Outcome hop(const Column& column);

/// Whether a column that begins with each box sunk into the one below by `overlap` [m] leaves the ground.
bool pops(const Column& column, double overlap);

/// Whether a column on soft contacts, of `frequency`, that is pushed sideways by a ten-millionth of a metre per
/// second comes back.
Outcome buckle(const Column& column);

/// How long a column stands whose top is pushed sideways with 0.02 m/s [s], at most `time`.
double time_to_fall(const Column& column, double time);

}  // namespace byhand::laws
