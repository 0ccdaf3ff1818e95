#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "lessons/doctor/doctor.hpp"
#include "lessons/doctor/opening.hpp"
#include "lessons/doctor/treatment.hpp"

// What is noted of a scene while it is examined.
namespace byhand::doctor {

inline Grade beyond(double number, double limit) { return number > limit ? Grade::fails : Grade::fine; }
inline Knob turn_to(const std::string& name, double value) {
  const std::string shown = value >= 1000 ? fmt::format("{:.0f}", value) : fmt::format("{:.3g}", value);
  return {name, value, name + " = " + shown};
}
inline Knob exactly() { return {"solver", 0, "solver = by_graph"}; }

template <class M>
struct Notes {
  const SceneFile& file;
  const Scene<M>& scene;  // as it begins
  Treatment treatment = treatment_of(file);
  std::vector<double> sizes = doctor::sizes(scene);           // of the bodies [m]
  double time = 0;                                            // of what is noted [s]
  double kick = 0;                                            // what the first step's sweeps leave [m/s]
  std::map<std::pair<int, std::string>, Finding> worst = {};  // by law and quantity

  /// Whether it is followed with longer steps, so that findings take no longer than a reader waits.
  bool is_large() const { return scene.bodies().size() > 100; }
  double size_of_pair(int body1, int body2) const { return size_of_both(sizes, body1, body2); }
  std::vector<int> moving(int body1, int body2) const {
    std::vector<int> all;
    for (const int body : {body1, body2})
      if (moves(scene.bodies().inverse_mass[body])) all.push_back(body);
    return all;
  }

  /// Keeps a law's worst finding, with the time at which the law first fails.
  void keep(Finding finding) {
    finding.time = time;
    if (finding.grade != Grade::fails)
      finding.grade = finding.excess() > 0.7 ? Grade::near_the_limit : Grade::fine;
    const auto [place, is_new] = worst.try_emplace({finding.law, finding.quantity}, finding);
    if (is_new || finding.excess() <= place->second.excess()) return;
    if (place->second.grade == Grade::fails) finding.time = place->second.time, finding.grade = Grade::fails;
    place->second = finding;
  }

  Knob more_substeps(double factor) const {
    return turn_to("substeps", std::ceil(file.method.substeps * std::max(factor, 1.01)));
  }
  Knob more_sweeps(double factor) const {
    const int now = std::max(1, treatment.passes);
    return turn_to("sweeps", std::min(1e6, std::ceil(now * std::max(factor, 1.2))));
  }
};

}  // namespace byhand::doctor
