#pragma once

#include "solver/methods/velocity_stepping.hpp"

namespace byhand {

/// A scene, the method that moves it and what is kept between steps: a value, so that a copy is a way back.
template <class S>
struct Simulation {
  S scene;
  VelocityStepping method;
  Work<typename S::model> work = {};
  double time = 0;  // [s]

  /// One time step h [s]. Errors as `advance`.
  void step(double h) {
    advance(scene, method, h, work);
    time += h;
  }
};

template <class S>
Simulation(S, VelocityStepping) -> Simulation<S>;

}  // namespace byhand
