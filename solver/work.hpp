#pragma once

#include "solver/contact/contact_manager.hpp"
#include "solver/rows/row_solver.hpp"
#include "solver/scene.hpp"

namespace byhand {

/// Poses and velocities of all bodies.
template <class M>
struct State {
  std::vector<Pose<M>> pose;
  std::vector<Velocity<M>> velocity;
};

/// What a method has done besides row-solves, counted where it is done.
struct Executed {
  long long laid_out_rows = 0;       // whenever the scene has changed
  long long solves = 0, passes = 0;  // how often the rows were solved, and passes over them
  long long prepared_rows = 0;       // made ready for a solve
  long long projected_rows = 0;      // solved on positions; row-solves, too
};

/// What every method keeps between steps. λ of `system` is the impulse of the last substep, so that λ/h is the
/// mean force in it.
template <class M>
struct StepWork {
  BYHAND_DECLARE_COPIES(StepWork);

  System<M> system;
  ContactManager<M> contacts;
  std::vector<double> parting;                 // by row, the least rate that a bounce leaves
  std::vector<Rotation<M, double>> rotations;  // in space: by body, when the rows were written
  Layout layout = Layout::none;
  std::uint64_t version = 0;  // of the scene when it was laid out; 0 to lay it out anew
  double h = 0;               // the substep that λ belongs to [s]
  long long row_solves = 0;   // total cost; a direct solve counts as the row solves of as many multiplications
  Executed executed;          // what else its time goes to
  State<M> start;             // at the start of the step
};

/// Finds the contacts of a step [s]. If they are others than before, rows are to be laid out anew.
template <class M>
void find_contacts(const Scene<M>& scene, double step, StepWork<M>& work) {
  if (work.contacts.find(scene, step)) work.version = 0;
}

/// Writes all rows at the present poses for a substep h [s], contacts of balls where these touch now.
template <class M>
void write_rows(const Scene<M>& scene, double h, StepWork<M>& work) {
  work.contacts.follow_balls(scene, work.system);
  scene.write_rows(work.system, h, work.contacts.constraints());
  if constexpr (M::angular == 3) {
    work.rotations.clear();
    for (const Pose<M>& pose : scene.bodies().pose) work.rotations.push_back(pose.rotation);
  }
}

/// λ is force times h: a new time step rescales it, so that the warm start keeps the forces.
template <class M>
void rescale_impulses(StepWork<M>& work, double h) {
  if (work.h > 0 && work.h != h)
    for (double& lambda : work.system.lambda) lambda *= h / work.h;
  work.h = h;
}

}  // namespace byhand
