// This course's solver, as a user of the library has it, and three of lesson 9's methods for joints.

#include <limits>

#include "lessons/engines/engine.hpp"
#include "lessons/methods/accelerations.hpp"
#include "lessons/methods/generalised.hpp"
#include "lessons/methods/rattle.hpp"
#include "solver/step.hpp"

namespace byhand::engines {
namespace {

template <class M, class Method>
class ThisCourse : public World<M> {
 public:
  ThisCourse(const Scene<M>& scene, const Method& method)
      : simulation_{scene, method}, refused_(!refusal(scene, method).empty()) {}
  void step(double h) override {
    if (refused_) return;
    try {
      simulation_.step(h);
    } catch (const std::runtime_error&) {  // a step that these methods cannot take
      refused_ = true;
    }
  }
  void read(Bodies<M>& bodies) const override {
    bodies.pose = simulation_.scene.bodies().pose;
    bodies.velocity = simulation_.scene.bodies().velocity;
    if (refused_)
      for (Pose<M>& pose : bodies.pose) pose.position.setConstant(std::numeric_limits<double>::quiet_NaN());
  }
  void set_velocities(const Bodies<M>& bodies) override { simulation_.scene.state().velocity = bodies.velocity; }

 private:
  Simulation<M, Method> simulation_;
  bool refused_;
};

VelocityStepping by_velocities(const Knobs& knobs) {
  VelocityStepping method;
  knobs.turn("substeps", method.substeps);
  knobs.turn("beta", std::get<Baumgarte>(method.drift).beta);
  knobs.turn("sweeps", std::get<ByGraph>(method.solver).loops.sweeps);
  return method;
}

template <class M>
std::unique_ptr<World<M>> build(const Scene<M>& scene, const Knobs& knobs) {
  const int substeps = static_cast<int>(knobs.value("substeps", 1));
  if (knobs.value("RK4", 0) != 0)
    return std::make_unique<ThisCourse<M, Accelerations>>(
        scene, Accelerations{.scheme = Scheme::rk4, .substeps = substeps});
  if (knobs.value("RATTLE", 0) != 0)
    return std::make_unique<ThisCourse<M, Rattle>>(scene, Rattle{.substeps = substeps});
  for (const auto& [name, rule] : {std::pair("Euler in joint coordinates", JointRule::semi_implicit_euler),
                                   std::pair("RK4 in joint coordinates", JointRule::rk4)})
    if (knobs.value(name, 0) != 0)
      return std::make_unique<ThisCourse<M, Generalised>>(scene, Generalised{.rule = rule, .substeps = substeps});
  return std::make_unique<ThisCourse<M, VelocityStepping>>(scene, by_velocities(knobs));
}

}  // namespace

const Engine& this_course() {
  static const Engine engine{
      .name = "this course",
      .method = "by the scene's graph: directly, by conjugate sweeps, or by semismooth Newton where these stall",
      .file = "lessons/engines/settings/this_course.cpp",
      .home = Home::both,
      .settings = this_course_settings(),
      .in_plane = build<PlaneBody>,
      .in_space = build<SpaceBody>};
  return engine;
}

}  // namespace byhand::engines
