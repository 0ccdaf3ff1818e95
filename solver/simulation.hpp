#pragma once

#include "solver/step.hpp"

namespace byhand {

/// A scene, the method that moves it and what is kept between steps: a value, so that a copy is a way back. The
/// family of methods is part of the type, so that a program compiles only those that it names.
template <class S, class Method = VelocityStepping>
struct Simulation {
  S scene;
  Method method;
  typename Method::template Work<typename S::model> work = {};
  double time = 0;  // [s]

  /// One time step h [s]. Errors as `advance`.
  void step(double h) {
    advance(scene, method, h, work);
    time += h;
  }
};

template <class S>
Simulation(S, VelocityStepping) -> Simulation<S>;
template <class S, class Method>
Simulation(S, Method) -> Simulation<S, Method>;

}  // namespace byhand
