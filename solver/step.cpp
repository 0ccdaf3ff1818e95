#include "solver/step.hpp"

namespace byhand {
namespace {

/// The cure before the rows are solved: b of (21), and γ of soft rows.
template <class M>
void begin_cure(const DriftCure& cure, double h, Work<M>& work) {
  set_bias(std::visit([&](const auto& choice) { return correction(choice, h); }, cure), h, work.system);
  if (const auto* soft = std::get_if<SoftConstraints>(&cure)) soften(*soft, h, work.system, work.soft);
}

/// The cure after the poses have moved.
template <class M>
void end_cure(const VelocityStepping& method, double h, Scene<M>& scene, Work<M>& work) {
  if (const auto* projection = std::get_if<Projection>(&method.drift)) {
    work.contacts.follow_balls(scene, work.system);
    work.row_solves += project(*projection, scene);
  }
  if (const auto* split = std::get_if<SplitImpulse>(&method.drift))
    push_poses(*split, method.solver, h, scene.state(), work, work.split_impulse);
  if (const auto* soft = std::get_if<SoftConstraints>(&method.drift))
    relax(*soft, method.solver, h, scene, work, work.soft);
}

/// Solves bouncing contacts a second time, after the poses have moved.
template <class M>
void bounce(const VelocityStepping& method, Bodies<M>& bodies, Work<M>& work) {
  if (!set_bounce(work.parting, work.system)) return;
  solve_rows(method.solver, bodies, work, Begin::resume);
  forget_bounce(work.parting, work.system);
}

}  // namespace

void require_valid(const VelocityStepping& method) {
  std::visit([](const auto& solver) { require_valid(solver); }, method.solver);
  std::visit([](const auto& cure) { require_valid(cure); }, method.drift);
  require(method.substeps >= 1, "number of substeps", method.substeps, "at least 1");
  require_in("bounce threshold", method.bounce_threshold, 0, 1e300, "m/s");
}

template <class M>
std::string refusal(const Scene<M>& scene, const VelocityStepping& method) {
  if (!std::holds_alternative<ConjugateGradients>(method.solver)) return {};
  const auto bounded = [&](const auto& entry) { return scene.store(entry.kind).bound != Bound::none; };
  if (scene.colliders().shapes.empty() && std::none_of(scene.entries().begin(), scene.entries().end(), bounded))
    return {};
  return "conjugate gradients hold no bounds, and this scene has contacts or other rows with bounds: conjugate "
         "sweeps or an accelerated gradient would";
}

//! [step]
template <class M>
void advance(Scene<M>& scene, const VelocityStepping& method, double step, Work<M>& work) {
  require_steppable(scene, method, step);
  Attempt attempt(scene, work);
  work.solution = {};
  work.contacts.find(scene, step);  // the article's n, P1 and P2, from shapes
  lay_out(scene, method.solver, work);
  work.contacts.write_impulses(work.system);
  Bodies<M>& bodies = scene.state();
  const double h = step / method.substeps;
  for (int i = 0; i < method.substeps; ++i) {
    write_rows(scene, h, work);         // J, C, M⁻¹Jᵀ at the current poses
    begin_cure(method.drift, h, work);  // b of (21), (22)
    if (method.euler == Euler::explicit_) advance_poses(bodies, h);
    note_parting(scene, h, method.bounce_threshold, work.system, work.parting);
    damp(bodies, h);
    begin_turn(method.gyroscopic, bodies, h);
    add_gravity(bodies, scene.gravity, h);    // before λ, or the rows cannot answer it
    rescale_impulses(work, h);                // λ of last step, for the warm start
    solve_rows(method.solver, bodies, work);  // (17) and (20) over all rows
    if (method.euler == Euler::symplectic) advance_poses(bodies, h);
    end_cure(method, h, scene, work);
    end_turn(method.gyroscopic, bodies, h);
    bounce(method, bodies, work);
  }
  work.contacts.read_impulses(work.system);
  attempt.finish();
}
//! [step]

#define BYHAND_INSTANTIATE(M)                                             \
  template std::string refusal(const Scene<M>&, const VelocityStepping&); \
  template void advance(Scene<M>&, const VelocityStepping&, double, Work<M>&)
BYHAND_FOR_EACH_MODEL(BYHAND_INSTANTIATE);
#undef BYHAND_INSTANTIATE

}  // namespace byhand
