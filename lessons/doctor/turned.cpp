#include "lessons/doctor/doctor.hpp"

namespace byhand::doctor {

SceneFile turned(SceneFile file, const Knob& knob) {
  const auto set = [&](auto& choices, auto member) { std::visit([&](auto& one) { member(one); }, choices); };
  if (knob.name == "substeps") file.method.substeps = static_cast<int>(knob.value);
  if (knob.name == "solver") {
    if (knob.words == "solver = gauss_seidel")
      file.method.solver = GaussSeidel{};
    else
      file.method.solver = ByGraph{};
  }
  if (knob.name == "cure") file.method.drift = SplitImpulse{};
  set(file.method.solver, [&](auto& one) {
    if constexpr (requires { one.sweeps; })
      if (knob.name == "sweeps") one.sweeps = static_cast<int>(knob.value);
    if constexpr (requires { one.relaxation; })
      if (knob.name == "relaxation") one.relaxation = knob.value;
    if constexpr (requires { one.regularisation; })
      if (knob.name == "regularisation") one.regularisation = knob.value;
  });
  set(file.method.drift, [&](auto& one) {
    if constexpr (requires { one.beta; })
      if (knob.name == "beta") one.beta = knob.value;
    if constexpr (requires { one.frequency; })
      if (knob.name == "frequency") one.frequency = knob.value;
  });
  return file;
}

}  // namespace byhand::doctor
