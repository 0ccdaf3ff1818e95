// Box2D 3, in C and single precision.

#include <box2d/box2d.h>

#include "lessons/engines/adapters.hpp"

namespace byhand::engines {
namespace {

using M = PlaneBody;

b2Vec2 vector(const Eigen::Vector2d& v) { return {static_cast<float>(v.x()), static_cast<float>(v.y())}; }

class Box2d3 : public World<M> {
 public:
  Box2d3(const Scene<M>& scene, const Knobs& knobs) : knobs_(knobs) {
    knobs.turn("substeps", substeps_);
    b2WorldDef def = b2DefaultWorldDef();
    knobs.turn("contact hertz", def.contactHertz);
    knobs.turn("contact damping", def.contactDampingRatio);
    def.gravity = vector(scene.gravity);
    def.enableSleep = false;
    world_ = b2CreateWorld(&def);
    b2World_SetMaximumLinearSpeed(world_, no_limit_of_speed);
    for (int i = 0; i < scene.bodies().size(); ++i) add(scene.bodies(), i);
    for_each_shape(
        scene,
        [&](int i, const Box<M>& box, const Surface& surface) {
          const b2ShapeDef shape = shape_of(surface);
          const b2Polygon polygon = b2MakeBox(vector(box.half()).x, vector(box.half()).y);
          b2CreatePolygonShape(bodies_[i], &shape, &polygon);
        },
        [&](int i, const HalfSpace<M>& half_space, const Surface& surface) {
          const b2ShapeDef shape = shape_of(surface);
          const Eigen::Vector2d up = half_space.normal, middle = -ground_depth * up;
          const b2Polygon polygon = b2MakeOffsetBox(ground_breadth, ground_depth, vector(middle),
                                                    {static_cast<float>(up.y()), static_cast<float>(-up.x())});
          b2CreatePolygonShape(bodies_[i], &shape, &polygon);
        });
    for (int i = 0; i < scene.bodies().size(); ++i) weigh(scene.bodies(), i);
    for_each_joint(
        scene,
        [&](const Pin<M>& pin) {
          b2RevoluteJointDef joint = b2DefaultRevoluteJointDef();
          attach(joint.base, pin.at);
          b2CreateRevoluteJoint(world_, &joint);
        },
        [&](const Distance<M>& rod) {
          b2DistanceJointDef joint = b2DefaultDistanceJointDef();
          attach(joint.base, rod.at);
          joint.length = static_cast<float>(rod.length);
          b2CreateDistanceJoint(world_, &joint);
        });
  }
  ~Box2d3() override { b2DestroyWorld(world_); }

  void step(double h) override { b2World_Step(world_, static_cast<float>(h), substeps_); }

  void read(Bodies<M>& bodies) const override {
    for (int i = 0; i < bodies.size(); ++i) {
      const b2Pos position = b2Body_GetPosition(bodies_[i]);
      const b2Rot rotation = b2Body_GetRotation(bodies_[i]);
      const b2Vec2 v = b2Body_GetLinearVelocity(bodies_[i]);
      const double length = std::hypot(rotation.c, rotation.s);
      bodies.pose[i].position = {position.x, position.y};
      bodies.pose[i].rotation = {rotation.c / length, rotation.s / length};
      bodies.velocity[i] = {v.x, v.y, b2Body_GetAngularVelocity(bodies_[i])};
    }
  }

  void set_velocities(const Bodies<M>& bodies) override {
    for (int i = 0; i < bodies.size(); ++i) {
      b2Body_SetLinearVelocity(bodies_[i], vector(bodies.velocity[i].head<2>()));
      b2Body_SetAngularVelocity(bodies_[i], static_cast<float>(bodies.velocity[i][2]));
    }
  }

 private:
  void add(const Bodies<M>& bodies, int i) {
    b2BodyDef def = b2DefaultBodyDef();
    def.type = moves(bodies.inverse_mass[i]) ? b2_dynamicBody : b2_staticBody;
    const b2Vec2 at = vector(bodies.pose[i].position);
    def.position = {at.x, at.y};
    def.rotation = {static_cast<float>(bodies.pose[i].rotation.cos),
                    static_cast<float>(bodies.pose[i].rotation.sin)};
    def.linearVelocity = vector(bodies.velocity[i].head<2>());
    def.angularVelocity = static_cast<float>(bodies.velocity[i][2]);
    bodies_.push_back(b2CreateBody(world_, &def));
  }
  void weigh(const Bodies<M>& bodies, int i) {
    const InverseMass<M>& mass = bodies.inverse_mass[i];
    if (!moves(mass)) return;
    b2MassData data = b2Body_GetMassData(bodies_[i]);
    data.mass = static_cast<float>(1 / mass.linear);
    data.rotationalInertia = static_cast<float>(1 / mass.angular[0]);
    data.center = {0, 0};
    b2Body_SetMassData(bodies_[i], data);
  }
  static b2ShapeDef shape_of(const Surface& surface) {
    b2ShapeDef shape = b2DefaultShapeDef();
    shape.material.friction = static_cast<float>(surface.friction);
    shape.material.restitution = static_cast<float>(surface.restitution);
    return shape;
  }
  void attach(b2JointDef& joint, const Anchors<M>& at) const {
    joint.bodyIdA = bodies_[at.body1];
    joint.bodyIdB = bodies_[at.body2];
    joint.localFrameA.p = vector(at.arms.first);
    joint.localFrameB.p = vector(at.arms.second);
    knobs_.turn("joint hertz", joint.constraintHertz);
    knobs_.turn("joint damping", joint.constraintDampingRatio);
  }

  Knobs knobs_;
  int substeps_ = 4;  // "usually 4", says b2World_Step
  b2WorldId world_;
  std::vector<b2BodyId> bodies_;
};

std::unique_ptr<World<M>> build(const Scene<M>& scene, const Knobs& knobs) {
  return std::make_unique<Box2d3>(scene, knobs);
}

}  // namespace

void add_box2d_3(std::vector<Engine>& all) {
  const b2Version version = b2GetVersion();
  all.push_back({.name = "Box2D 3",
                 .version = version_text(version.major, version.minor, version.revision),
                 .method = "one sweep a substep, soft joints and contacts, then a relaxing sweep",
                 .file = "lessons/engines/settings/box2d_3.cpp",
                 .home = Home::plane,
                 .single = true,
                 .build = "built without its option of double precision",
                 .settings = box2d_3_settings(),
                 .in_plane = build});
}

}  // namespace byhand::engines
