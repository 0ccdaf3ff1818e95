// Box3D, in C and single precision. In the plane boxes are 1 m deep, and locks hold them there.

#include <box3d/box3d.h>

#include "lessons/engines/in_space.hpp"

namespace byhand::engines {
namespace {

b3Vec3 vector(const Eigen::Vector3d& v) {
  return {static_cast<float>(v.x()), static_cast<float>(v.y()), static_cast<float>(v.z())};
}
b3Quat quaternion(const Eigen::Quaterniond& q) { return {vector(q.vec()), static_cast<float>(q.w())}; }

template <class M>
class Box3d : public World<M> {
 public:
  Box3d(const Scene<M>& scene, const Knobs& knobs) : knobs_(knobs) {
    knobs.turn("substeps", substeps_);
    b3WorldDef def = b3DefaultWorldDef();
    knobs.turn("contact hertz", def.contactHertz);
    knobs.turn("contact damping", def.contactDampingRatio);
    def.gravity = vector(in_space(scene.gravity));
    def.enableSleep = false;
    world_ = b3CreateWorld(&def);
    b3World_SetMaximumLinearSpeed(world_, no_limit_of_speed);
    for (int i = 0; i < scene.bodies().size(); ++i) add(scene.bodies(), i);
    for_each_shape(
        scene,
        [&](int i, const Box<M>& box, const Surface& surface) {
          const b3Vec3 half = vector(0.5 * sides_in_space(box));
          add(i, b3MakeBoxHull(half.x, half.y, half.z), surface);
        },
        [&](int i, const HalfSpace<M>& half_space, const Surface& surface) {
          const Eigen::Vector3d up = in_space(half_space.normal);
          const b3Transform place{vector(-ground_depth * up),
                                  quaternion(Eigen::Quaterniond::FromTwoVectors(Eigen::Vector3d::UnitY(), up))};
          add(i, b3MakeTransformedBoxHull(ground_breadth, ground_depth, ground_breadth, place), surface);
        });
    for (int i = 0; i < scene.bodies().size(); ++i) weigh(scene.bodies(), i);
    for_each_joint(
        scene,
        [&](const Pin<M>& pin) {
          b3SphericalJointDef joint = b3DefaultSphericalJointDef();
          attach(joint.base, pin.at);
          b3CreateSphericalJoint(world_, &joint);
        },
        [&](const Distance<M>& rod) {
          b3DistanceJointDef joint = b3DefaultDistanceJointDef();
          attach(joint.base, rod.at);
          joint.length = static_cast<float>(rod.length);
          b3CreateDistanceJoint(world_, &joint);
        });
  }
  ~Box3d() override { b3DestroyWorld(world_); }

  void step(double h) override { b3World_Step(world_, static_cast<float>(h), substeps_); }

  void read(Bodies<M>& bodies) const override {
    const auto from = [](const auto& v) { return Eigen::Vector3d(v.x, v.y, v.z); };
    for (int i = 0; i < bodies.size(); ++i) {
      const b3Quat q = b3Body_GetRotation(bodies_[i]);
      put(bodies, i, from(b3Body_GetPosition(bodies_[i])), {q.s, q.v.x, q.v.y, q.v.z},
          from(b3Body_GetLinearVelocity(bodies_[i])), from(b3Body_GetAngularVelocity(bodies_[i])));
    }
  }
  void set_velocities(const Bodies<M>& bodies) override {
    for (int i = 0; i < bodies.size(); ++i) {
      b3Body_SetLinearVelocity(bodies_[i], vector(velocity_in_space<M>(bodies.velocity[i])));
      b3Body_SetAngularVelocity(bodies_[i], vector(spin_in_space<M>(bodies.velocity[i])));
    }
  }

 private:
  void add(const Bodies<M>& bodies, int i) {
    b3BodyDef def = b3DefaultBodyDef();
    def.type = moves(bodies.inverse_mass[i]) ? b3_dynamicBody : b3_staticBody;
    const b3Vec3 at = vector(in_space(bodies.pose[i].position));
    def.position = {at.x, at.y, at.z};
    def.rotation = quaternion(rotation_in_space<M>(bodies.pose[i]));
    def.linearVelocity = vector(velocity_in_space<M>(bodies.velocity[i]));
    def.angularVelocity = vector(spin_in_space<M>(bodies.velocity[i]));
    if (M::linear == 2) def.motionLocks.linearZ = def.motionLocks.angularX = def.motionLocks.angularY = true;
    bodies_.push_back(b3CreateBody(world_, &def));
  }
  void add(int i, const b3BoxHull& hull, const Surface& surface) {
    b3ShapeDef shape = b3DefaultShapeDef();
    shape.baseMaterial.friction = static_cast<float>(surface.friction);
    shape.baseMaterial.restitution = static_cast<float>(surface.restitution);
    b3CreateHullShape(bodies_[i], &shape, &hull.base);
  }
  void weigh(const Bodies<M>& bodies, int i) {
    const InverseMass<M>& mass = bodies.inverse_mass[i];
    if (!moves(mass)) return;
    const Eigen::Vector3d inertia = inertia_in_space(mass);
    b3MassData data = b3Body_GetMassData(bodies_[i]);
    data.mass = static_cast<float>(1 / mass.linear);
    data.center = {0, 0, 0};
    data.inertia = {vector(inertia.x() * Eigen::Vector3d::UnitX()), vector(inertia.y() * Eigen::Vector3d::UnitY()),
                    vector(inertia.z() * Eigen::Vector3d::UnitZ())};
    b3Body_SetMassData(bodies_[i], data);
  }
  void attach(b3JointDef& joint, const Anchors<M>& at) const {
    joint.bodyIdA = bodies_[at.body1];
    joint.bodyIdB = bodies_[at.body2];
    joint.localFrameA.p = vector(in_space(at.arms.first));
    joint.localFrameB.p = vector(in_space(at.arms.second));
    knobs_.turn("joint hertz", joint.constraintHertz);
    knobs_.turn("joint damping", joint.constraintDampingRatio);
  }

  Knobs knobs_;
  int substeps_ = 4;  // "usually 4", says b3World_Step
  b3WorldId world_;
  std::vector<b3BodyId> bodies_;
};

template <class M>
std::unique_ptr<World<M>> build(const Scene<M>& scene, const Knobs& knobs) {
  return std::make_unique<Box3d<M>>(scene, knobs);
}

}  // namespace

void add_box3d(std::vector<Engine>& all) {
  const b3Version version = b3GetVersion();
  all.push_back({.name = "Box3D",
                 .version = version_text(version.major, version.minor, version.revision),
                 .method = "one sweep a substep, soft joints and contacts, then a relaxing sweep",
                 .file = "lessons/engines/settings/box3d.cpp",
                 .single = true,
                 .build = "built without its option of double precision",
                 .settings = box3d_settings(),
                 .in_plane = build<PlaneBody>,
                 .in_space = build<SpaceBody>});
}

}  // namespace byhand::engines
