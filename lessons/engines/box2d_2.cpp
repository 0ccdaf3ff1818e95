// Box2D 2.4, in single precision. A polygon has a skin of b2_polygonRadius outside its
// sides, at which it touches; so the boxes are made smaller by it.

#include <box2d/box2d.h>

#include "lessons/engines/adapters.hpp"

namespace byhand::engines {
namespace {

using M = PlaneBody;

b2Vec2 vector(const Eigen::Vector2d& v) { return {static_cast<float>(v.x()), static_cast<float>(v.y())}; }

class Box2d2 : public World<M> {
 public:
  Box2d2(const Scene<M>& scene, const Knobs& knobs) : world_(vector(scene.gravity)) {
    knobs.turn("velocity iterations", on_velocities_);
    knobs.turn("position iterations", on_positions_);
    world_.SetAllowSleeping(false);
    for (int i = 0; i < scene.bodies().size(); ++i) add(scene.bodies(), i);
    for_each_shape(
        scene,
        [&](int i, const Box<M>& box, const Surface& surface) {
          const b2Vec2 half = vector(box.half());
          b2PolygonShape polygon;
          polygon.SetAsBox(half.x - b2_polygonRadius, half.y - b2_polygonRadius);
          add(i, polygon, surface);
        },
        [&](int i, const HalfSpace<M>& half_space, const Surface& surface) {
          const Eigen::Vector2d up = half_space.normal, middle = -(ground_depth + b2_polygonRadius) * up;
          b2PolygonShape polygon;
          polygon.SetAsBox(ground_breadth, ground_depth, vector(middle),
                           static_cast<float>(std::atan2(-up.x(), up.y())));
          add(i, polygon, surface);
        });
    for (int i = 0; i < scene.bodies().size(); ++i) weigh(scene.bodies(), i);
    for_each_joint(
        scene,
        [&](const Pin<M>& pin) {
          b2RevoluteJointDef joint;
          attach(joint, pin.at);
          world_.CreateJoint(&joint);
        },
        [&](const Distance<M>& rod) {
          b2DistanceJointDef joint;
          attach(joint, rod.at);
          joint.length = joint.minLength = joint.maxLength = static_cast<float>(rod.length);
          world_.CreateJoint(&joint);
        });
  }

  void step(double h) override { world_.Step(static_cast<float>(h), on_velocities_, on_positions_); }

  void read(Bodies<M>& bodies) const override {
    for (int i = 0; i < bodies.size(); ++i) {
      const b2Body& body = *bodies_[i];
      bodies.pose[i].position = {body.GetPosition().x, body.GetPosition().y};
      bodies.pose[i].rotation = rotation_of(body.GetAngle());
      bodies.velocity[i] = {body.GetLinearVelocity().x, body.GetLinearVelocity().y, body.GetAngularVelocity()};
    }
  }

  void set_velocities(const Bodies<M>& bodies) override {
    for (int i = 0; i < bodies.size(); ++i) {
      bodies_[i]->SetLinearVelocity(vector(bodies.velocity[i].head<2>()));
      bodies_[i]->SetAngularVelocity(static_cast<float>(bodies.velocity[i][2]));
    }
  }

 private:
  void add(const Bodies<M>& bodies, int i) {
    b2BodyDef def;
    def.type = moves(bodies.inverse_mass[i]) ? b2_dynamicBody : b2_staticBody;
    def.position = vector(bodies.pose[i].position);
    def.angle = static_cast<float>(angle_of(bodies.pose[i].rotation));
    def.linearVelocity = vector(bodies.velocity[i].head<2>());
    def.angularVelocity = static_cast<float>(bodies.velocity[i][2]);
    bodies_.push_back(world_.CreateBody(&def));
  }
  void add(int i, const b2PolygonShape& polygon, const Surface& surface) {
    b2FixtureDef def;
    def.shape = &polygon;
    def.density = 1;
    def.friction = static_cast<float>(surface.friction);
    def.restitution = static_cast<float>(surface.restitution);
    bodies_[i]->CreateFixture(&def);
  }
  void weigh(const Bodies<M>& bodies, int i) {
    const InverseMass<M>& mass = bodies.inverse_mass[i];
    if (!moves(mass)) return;
    b2MassData data;
    data.mass = static_cast<float>(1 / mass.linear);
    data.I = static_cast<float>(1 / mass.angular[0]);
    data.center.SetZero();
    bodies_[i]->SetMassData(&data);
  }
  template <class Joint>
  void attach(Joint& joint, const Anchors<M>& at) const {
    joint.bodyA = bodies_[at.body1];
    joint.bodyB = bodies_[at.body2];
    joint.localAnchorA = vector(at.arms.first);
    joint.localAnchorB = vector(at.arms.second);
  }

  int on_velocities_ = 6, on_positions_ = 2;  // iterations, of HelloWorld.cpp
  b2World world_;
  std::vector<b2Body*> bodies_;
};

std::unique_ptr<World<M>> build(const Scene<M>& scene, const Knobs& knobs) {
  return std::make_unique<Box2d2>(scene, knobs);
}

}  // namespace

void add_box2d_2(std::vector<Engine>& all) {
  all.push_back({.name = "Box2D 2.4",
                 .version = BYHAND_BOX2D_2_VERSION,
                 .method = "Gauss–Seidel on velocities, then on positions",
                 .file = "lessons/engines/settings/box2d_2.cpp",
                 .home = Home::plane,
                 .single = true,
                 .build = "Debian's is compiled with its checks on",
                 .settings = box2d_2_settings(),
                 .in_plane = build});
}

}  // namespace byhand::engines
