#include "lessons/cases/case.hpp"

namespace byhand::cases {
namespace {

using M = PlaneParticle;

double largest_gap(const SceneFile& file, double seconds) {
  const Simulation<M> chain = after<M>(file, seconds);
  return position_error(chain.scene).max;
}
/// The stretch of the second rod, the largest: it carries four bobs of 1 kg, and its JM⁻¹Jᵀ is 2/kg.
double stretch(double frequency) { return 4 * 9.81 * 2 / (frequency * frequency); }
double frequency_of(const SceneFile& file) { return std::get<SoftConstraints>(file.method.drift).frequency; }

Case make() {
  return {
      .title = "Joints do not stiffen with substeps",
      .report =
          "A chain stretches as much with 64 substeps as with 4: its soft joints have a frequency of their own, "
          "which the engine caps at 60 Hz.",
      .link = "https://github.com/Birch-san/box2d3-wasm/issues/49",
      .law = 11,
      .why =
          "A soft row of frequency ω acts as a spring with k = mω², m = 1/(JM⁻¹Jᵀ). Under a pull T it gives way "
          "by T/(mω²), whatever the number of substeps. The second of five rods carries four bobs of 1 kg and has "
          "m = ½ "
          "kg. Four times the frequency makes the gap a sixteenth as large.",
      .equation = {"C = T·JM⁻¹Jᵀ/ω²", R"(C = \frac{T\,JM^{-1}J^T}{\omega^2})"},
      .numbers =
          [](const SceneFile& file) {
            SceneFile finer = file, stiffer = file;
            finer.method.substeps *= 8;
            std::get<SoftConstraints>(stiffer.method.drift).frequency *= 4;
            const double gap = largest_gap(file, 60);
            return std::vector<Number>{{"largest gap with 4 substeps", "m", stretch(frequency_of(file)), gap,
                                        "Hooke's law of a soft row", 0.01},
                                       {"the same with 32 substeps", "m", stretch(frequency_of(file)),
                                        largest_gap(finer, 60), "Hooke's law of a soft row", 0.01},
                                       {"how many times smaller at four times the frequency", "1", 16,
                                        gap / largest_gap(stiffer, 60), "Hooke's law of a soft row", 0.01}};
          },
      .cure =
          "Raise the joint's frequency together with the substeps (in Box2D 3: b2JointDef::constraintHertz), or "
          "make the joints hard: with an exact solve Baumgarte has no such limit.",
      .cured =
          [](SceneFile file) {
            file.method = VelocityStepping{};
            file.method.substeps = 4;
            return file;
          },
      .numbers_cured =
          [](const SceneFile& file) {
            return std::vector<Number>{{"largest gap", "m", 0, largest_gap(file, 60), "C = 0 at rest", 1e-6}};
          },
      .takeaway = "A soft joint has two limits: the step and its own frequency. Substeps only move the first."};
}
const bool told = tell(__FILE__, make);

}  // namespace
}  // namespace byhand::cases
