#include "lessons/laws/column.hpp"

#include <cmath>
#include <numbers>
#include <utility>

#include "lessons/laws/record.hpp"
#include "lessons/scenes/boxes.hpp"
#include "solver/constraints/contact_manifold.hpp"
#include "solver/step.hpp"

namespace byhand::laws {
namespace {

/// The column, each box sunk into the one below by `overlap` [m], before any contact has borne a weight.
Simulation<PlaneBody> put_down(const Column& column, double overlap) {
  VelocityStepping method{GaussSeidel{column.sweeps}, Baumgarte{column.beta}};
  // A tolerance that one solve meets, though it is regularised: law 20 is about one solve a step.
  if (column.sweeps == 0) method.solver = Direct{.regularisation = column.regularisation, .tolerance = 1e-5};
  if (column.frequency > 0) method.drift = SoftConstraints{.frequency = 2 * std::numbers::pi * column.frequency};
  method.substeps = column.substeps;
  Simulation<PlaneBody> simulation{{}, method};
  Scene<PlaneBody>& scene = simulation.scene;
  scene.gravity = {0, -column.gravity};
  const double width = column.size.width, height = column.size.height;
  scene.add_body({0, 0}, fixed<PlaneBody>());
  for (int i = 1; i <= column.boxes; ++i) {
    const double y = i * (height - overlap) - height / 2;
    scene.add_body({0, y}, box<PlaneBody>(i == column.boxes ? column.top_mass : 1, {width, height}));
    const auto meet = [&](double x) {
      Anchors<PlaneBody> at{i - 1, i};
      at.arms = {Arm<PlaneBody>(x, i == 1 ? 0 : height / 2), Arm<PlaneBody>(x, -height / 2)};
      return at;
    };
    ContactManifold<PlaneBody> face;
    face.at = meet(-width / 2);
    face.second = meet(width / 2).arms;
    face.coefficient = column.friction;
    scene.add(face);
  }
  return simulation;
}

/// The same with all weights borne as they should be.
Simulation<PlaneBody> stand(const Column& column, double overlap) {
  Simulation<PlaneBody> simulation = put_down(column, overlap);
  const VelocityStepping method = std::exchange(simulation.method, {Direct{}, NoDriftCure{}});
  simulation.step(column.step);
  simulation.method = method;
  return simulation;
}

}  // namespace

Outcome lean(const Column& column) {
  // Sunk in, or a box that leans would open a gap, which closes by itself.
  Simulation<PlaneBody> simulation = stand(column, 1e-4 * column.size.height);
  const double push = 1e-7;
  kick(simulation.scene, push);
  Record record(push, column.size.height);
  for (int i = 0; i < column.steps; ++i) {
    simulation.step(column.step);
    if (!record.note(simulation.scene.bodies().velocity[column.boxes].x())) break;
  }
  return record.outcome();
}

Outcome hop(const Column& column) {
  Simulation<PlaneBody> simulation = put_down(column, 0);
  const double h = column.step / column.substeps, sinks = column.gravity * h * h;
  for (int i = 0, quiet = 0; i < column.steps; ++i) {
    simulation.step(column.step);
    const double off = std::abs(simulation.scene.bodies().pose[column.boxes].position.y() -
                                (column.boxes - 0.5) * column.size.height);
    if (!(off < column.size.height)) return Outcome::explodes;
    quiet = off < 1e-5 * sinks ? quiet + 1 : 0;
    if (quiet == 500) return Outcome::settles;
  }
  return Outcome::rings;
}

bool pops(const Column& column, double overlap) {
  Simulation<PlaneBody> simulation = put_down(column, overlap);
  for (int i = 0; i < column.steps; ++i) {
    simulation.step(column.step);
    if (simulation.scene.bodies().pose[1].position.y() > column.size.height / 2 + 1e-9) return true;
  }
  return false;
}

Outcome buckle(const Column& column) {
  Simulation<PlaneBody> simulation = put_down(column, 0);
  for (int i = 0; i < 200; ++i)
    simulation.step(column.step);  // until the contacts bear the weights, or it would slip
  const double push = 1e-7;
  kick(simulation.scene, push);
  Record record(push, column.size.height);
  for (int i = 0; i < column.steps; ++i) {
    simulation.step(column.step);
    if (!record.note(simulation.scene.bodies().pose[column.boxes].position.x())) break;
  }
  return record.outcome();
}

double time_to_fall(const Column& column, double time) {
  Simulation<PlaneBody> simulation = stand(column, 0);
  kick(simulation.scene, 0.02);
  while (simulation.time < time &&
         simulation.scene.bodies().pose[column.boxes].position.y() > (column.boxes - 1) * column.size.height)
    simulation.step(column.step);
  return simulation.time;
}

}  // namespace byhand::laws
