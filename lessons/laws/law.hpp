#pragma once

#include <functional>
#include <string>
#include <vector>

// Where methods fail: each law says at which value of a knob, from a derivation that stands at the head of its
// file, and brings the experiment that finds the same value without it. Runs are cheap (milliseconds), keep
// nothing and share nothing, so that many can be made side by side.
namespace byhand::laws {

/// How a run ends: where it should be; held off from there or still moving away; oscillating without end; far away
/// or not finite; or not at all, because the rows have no solution.
enum class Outcome { settles, drifts, rings, explodes, no_solution };

/// One number that a law predicts, for one setting of all else.
struct Boundary {
  std::string quantity, unit;  // the knob that is turned, or what is measured; "" for a pure number
  std::string setting;         // what is held fixed, with units
  double predicted = 0;
  double tolerance = 0;                    // the share of it by which an experiment may differ
  std::function<double()> measured;        // the same by experiment: many runs
  std::function<bool(double)> holds = {};  // one run: whether it goes well at a value of the knob. It does below
                                           // the boundary and not above. Empty where the law has no two sides.
};

/// The five families of failures.
enum class Family { too_few_iterations, overshooting_correction, too_large_a_step, too_soft, wrong_rows };

struct Law {
  int number;
  Family family;
  std::string name;      // by which texts cite it
  std::string sentence;  // what it says
  std::string formula;   // where the boundary is
  std::vector<Boundary> boundaries;
};

/// All laws in order of their numbers; making them runs nothing.
std::vector<Law> all();

/// For a boundary's `holds`: whether a run settles with one knob of its scene turned.
template <class Scene>
std::function<bool(double)> settles(const Scene& scene, double Scene::*knob, Outcome (*run)(const Scene&)) {
  return [=](double value) {
    Scene turned = scene;
    turned.*knob = value;
    return run(turned) == Outcome::settles;
  };
}

/// "1 sweep", "2 sweeps".
std::string counted(int count, const std::string& what);

/// Where `holds` changes between low and high, both > 0, by halving their ratio until it is below 1 + resolution.
/// Throws std::invalid_argument where it does not change.
double bisect(const std::function<bool(double)>& holds, double low, double high, double resolution);

/// Gives a boundary its experiment: bisection around the predicted value, to a fifth of the tolerance; NaN where
/// nothing changes within a factor of 8.
Boundary bisected(Boundary boundary);

}  // namespace byhand::laws
