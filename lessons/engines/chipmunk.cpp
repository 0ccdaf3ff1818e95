// Chipmunk 7, in double precision. It multiplies the friction of two bodies.

#include <chipmunk/chipmunk.h>
#include <fcntl.h>
#include <unistd.h>

#include <cstdio>

#include "lessons/engines/adapters.hpp"

namespace byhand::engines {
namespace {

using M = PlaneBody;

cpVect vector(const Eigen::Vector2d& v) { return cpv(v.x(), v.y()); }

/// At its first space Debian's Chipmunk prints that it checks what it is given.
bool greeted_in_silence() {
  std::fflush(stdout);
  const int nowhere = open("/dev/null", O_WRONLY);
  const int kept[] = {dup(STDOUT_FILENO), dup(STDERR_FILENO)};
  for (const int stream : {STDOUT_FILENO, STDERR_FILENO}) dup2(nowhere, stream);
  cpSpaceFree(cpSpaceNew());
  std::fflush(stdout);
  for (const int stream : {STDOUT_FILENO, STDERR_FILENO}) dup2(kept[stream - STDOUT_FILENO], stream);
  for (const int file : {nowhere, kept[0], kept[1]}) close(file);
  return true;
}

cpSpace* new_space() {
  [[maybe_unused]] static const bool greeted = greeted_in_silence();
  return cpSpaceNew();
}

class Chipmunk : public World<M> {
 public:
  Chipmunk(const Scene<M>& scene, const Knobs& knobs)
      : space_(new_space()), joint_bias_(knobs.value("joint bias", 0.1)) {
    cpSpaceSetGravity(space_, vector(scene.gravity));
    cpSpaceSetIterations(space_, static_cast<int>(knobs.value("iterations", cpSpaceGetIterations(space_))));
    cpSpaceSetCollisionSlop(space_, knobs.value("slop", cpSpaceGetCollisionSlop(space_)));
    cpSpaceSetCollisionBias(space_, left_after_a_second(knobs.value("collision bias", 0.1)));
    for (int i = 0; i < scene.bodies().size(); ++i) add(scene.bodies(), i);
    for_each_shape(
        scene,
        [&](int i, const Box<M>& box, const Surface& surface) {
          add(cpBoxShapeNew(bodies_[i], box.sides.x(), box.sides.y(), 0), surface);
        },
        [&](int i, const HalfSpace<M>& half_space, const Surface& surface) {
          const Eigen::Vector2d up = half_space.normal, along(up.y(), -up.x());
          const Eigen::Vector2d left = -ground_breadth * along, right = ground_breadth * along,
                                down = -2 * ground_depth * up;
          const cpVect corners[] = {vector(left), vector(left + down), vector(right + down), vector(right)};
          add(cpPolyShapeNewRaw(bodies_[i], 4, corners, 0), surface);
        });
    for_each_joint(
        scene,
        [&](const Pin<M>& pin) {
          add(cpPivotJointNew2(bodies_[pin.at.body1], bodies_[pin.at.body2], vector(pin.at.arms.first),
                               vector(pin.at.arms.second)));
        },
        [&](const Distance<M>& rod) {
          cpConstraint* joint = cpPinJointNew(bodies_[rod.at.body1], bodies_[rod.at.body2],
                                              vector(rod.at.arms.first), vector(rod.at.arms.second));
          cpPinJointSetDist(joint, rod.length);
          add(joint);
        });
  }
  ~Chipmunk() override {
    for (cpShape* shape : shapes_) cpSpaceRemoveShape(space_, shape), cpShapeFree(shape);
    for (cpConstraint* joint : joints_) cpSpaceRemoveConstraint(space_, joint), cpConstraintFree(joint);
    for (cpBody* body : bodies_) cpSpaceRemoveBody(space_, body), cpBodyFree(body);
    cpSpaceFree(space_);
  }

  void step(double h) override { cpSpaceStep(space_, h); }

  void read(Bodies<M>& bodies) const override {
    for (int i = 0; i < bodies.size(); ++i) {
      const cpVect position = cpBodyGetPosition(bodies_[i]), v = cpBodyGetVelocity(bodies_[i]);
      bodies.pose[i].position = {position.x, position.y};
      bodies.pose[i].rotation = rotation_of(cpBodyGetAngle(bodies_[i]));
      bodies.velocity[i] = {v.x, v.y, cpBodyGetAngularVelocity(bodies_[i])};
    }
  }

  void set_velocities(const Bodies<M>& bodies) override {
    for (int i = 0; i < bodies.size(); ++i) {
      if (!moves(bodies.inverse_mass[i])) continue;
      cpBodySetVelocity(bodies_[i], vector(bodies.velocity[i].head<2>()));
      cpBodySetAngularVelocity(bodies_[i], bodies.velocity[i][2]);
    }
  }

 private:
  void add(const Bodies<M>& bodies, int i) {
    const InverseMass<M>& mass = bodies.inverse_mass[i];
    cpBody* body = moves(mass) ? cpBodyNew(1 / mass.linear, 1 / mass.angular[0]) : cpBodyNewStatic();
    cpBodySetPosition(body, vector(bodies.pose[i].position));
    cpBodySetAngle(body, angle_of(bodies.pose[i].rotation));
    if (moves(mass)) {
      cpBodySetVelocity(body, vector(bodies.velocity[i].head<2>()));
      cpBodySetAngularVelocity(body, bodies.velocity[i][2]);
    }
    bodies_.push_back(cpSpaceAddBody(space_, body));
  }
  void add(cpShape* shape, const Surface& surface) {
    cpShapeSetFriction(shape, friction_factor(surface));
    cpShapeSetElasticity(shape, surface.restitution);
    shapes_.push_back(cpSpaceAddShape(space_, shape));
  }
  void add(cpConstraint* joint) {
    cpConstraintSetErrorBias(joint, left_after_a_second(joint_bias_));
    joints_.push_back(cpSpaceAddConstraint(space_, joint));
  }
  /// Chipmunk's measure of a bias, of which each sixtieth of a second takes a share.
  static double left_after_a_second(double share) { return std::pow(1 - share, 60); }

  cpSpace* space_;
  double joint_bias_;
  std::vector<cpBody*> bodies_;
  std::vector<cpShape*> shapes_;
  std::vector<cpConstraint*> joints_;
};

std::unique_ptr<World<M>> build(const Scene<M>& scene, const Knobs& knobs) {
  return std::make_unique<Chipmunk>(scene, knobs);
}

}  // namespace

void add_chipmunk(std::vector<Engine>& all) {
  all.push_back(
      {.name = "Chipmunk",
       .version = version_text(CP_VERSION_MAJOR, CP_VERSION_MINOR, CP_VERSION_RELEASE),
       .method = "Gauss–Seidel on velocities; position errors by separate bias velocities (as in split impulse)",
       .file = "lessons/engines/settings/chipmunk.cpp",
       .home = Home::plane,
       .build = "Debian's is compiled with its checks on",
       .settings = chipmunk_settings(),
       .in_plane = build});
}

}  // namespace byhand::engines
