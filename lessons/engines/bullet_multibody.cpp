// Bullet's multi-bodies, in double precision: trees of pins in coordinates that cannot part, by Featherstone's
// articulated bodies. All pins start from one fixed body; a body without a pin is a tree of its own.

#include <BulletDynamics/Featherstone/btMultiBody.h>
#include <BulletDynamics/Featherstone/btMultiBodyConstraintSolver.h>
#include <BulletDynamics/Featherstone/btMultiBodyDynamicsWorld.h>
#include <btBulletDynamicsCommon.h>

#include <map>

#include "lessons/engines/in_space.hpp"

namespace byhand::engines {
namespace {

btVector3 vector(const Eigen::Vector3d& v) { return {v.x(), v.y(), v.z()}; }
Eigen::Vector3d vector(const btVector3& v) { return {v.x(), v.y(), v.z()}; }
btQuaternion quaternion(const Eigen::Quaterniond& q) { return {q.x(), q.y(), q.z(), q.w()}; }

template <class M>
class Multibody : public World<M> {
 public:
  Multibody(const Scene<M>& scene, const Knobs& knobs)
      : rk4_(knobs.value("RK4", 0) != 0),
        dispatcher_(&configuration_),
        world_(&dispatcher_, &broad_phase_, &solver_, &configuration_),
        places_(scene.bodies().size()) {
    world_.setGravity(vector(in_space(scene.gravity)));
    std::map<int, Anchors<M>> parent;  // by the body that hangs there
    for_each_joint(
        scene,
        [&](const Pin<M>& pin) {
          if (!moves(scene.bodies().inverse_mass[pin.at.body2]) || !parent.emplace(pin.at.body2, pin.at).second)
            throw std::invalid_argument("Bullet's multi-bodies are given trees of pins only");
        },
        [](const Distance<M>&) { throw std::invalid_argument("Bullet has no rigid rod"); });
    if (!parent.empty()) add_tree(scene.bodies(), parent);
    for (int i = 0; i < scene.bodies().size(); ++i)
      if (moves(scene.bodies().inverse_mass[i]) && !parent.count(i)) add_free(scene.bodies(), i);
    set_velocities(scene.bodies());
  }
  ~Multibody() override {
    for (const auto& body : bodies_) world_.removeMultiBody(body.get());
  }

  void step(double h) override { world_.stepSimulation(h, 0); }

  void read(Bodies<M>& bodies) const override {
    for (const auto& body : bodies_) {
      const int count = body->getNumLinks() + 1;
      std::vector<btVector3> spin(count), v(count);  // along the axes of each link; the base first
      body->compTreeLinkVelocities(spin.data(), v.data());
      for (int i = 0; i < bodies.size(); ++i) {
        const auto [owner, link] = places_[i];
        if (owner != body.get()) continue;
        const auto to_world = [&, link = link](const btVector3& a) {
          return vector(body->localDirToWorld(link, a));
        };
        Eigen::Matrix3d axes;
        axes << to_world({1, 0, 0}), to_world({0, 1, 0}), to_world({0, 0, 1});
        put(bodies, i, vector(body->localPosToWorld(link, {0, 0, 0})), Eigen::Quaterniond(axes),
            to_world(v[link + 1]), to_world(spin[link + 1]));
      }
    }
  }
  void set_velocities(const Bodies<M>& bodies) override {
    for (int i = 0; i < bodies.size(); ++i) {
      const auto [owner, link] = places_[i];
      if (owner && link < 0) {
        owner->setBaseVel(vector(velocity_in_space<M>(bodies.velocity[i])));
        owner->setBaseOmega(vector(spin_in_space<M>(bodies.velocity[i])));
      } else if (!bodies.velocity[i].isZero()) {
        throw std::invalid_argument("Bullet's multi-bodies are given trees at rest only");
      }
    }
  }

 private:
  struct Place {
    btMultiBody* body = nullptr;
    int link = -1;  // the base
  };

  btMultiBody& add(int links, double mass, const Eigen::Vector3d& inertia, bool fixed, const btTransform& at) {
    bodies_.push_back(std::make_unique<btMultiBody>(links, mass, vector(inertia), fixed, false));
    bodies_.back()->setBaseWorldTransform(at);
    return *bodies_.back();
  }
  void finish(btMultiBody& body) {
    body.finalizeMultiDof();
    body.setLinearDamping(0);  // 0.04 as shipped
    body.setAngularDamping(0);
    body.setMaxCoordinateVelocity(1e10);
    body.useRK4Integration(rk4_);
    world_.addMultiBody(&body);
  }
  static btTransform place_of(const Pose<M>& pose) {
    return btTransform(quaternion(rotation_in_space<M>(pose)), vector(in_space(pose.position)));
  }

  void add_free(const Bodies<M>& bodies, int i) {
    const InverseMass<M>& mass = bodies.inverse_mass[i];
    btMultiBody& body = add(0, 1 / mass.linear, inertia_in_space(mass), false, place_of(bodies.pose[i]));
    places_[i] = {&body, -1};
    finish(body);
  }
  void add_tree(const Bodies<M>& bodies, const std::map<int, Anchors<M>>& parent) {
    const int root = parent.begin()->second.body1;
    btMultiBody& body =
        add(static_cast<int>(parent.size()), 0, Eigen::Vector3d::Zero(), true, place_of(bodies.pose[root]));
    int link = 0;
    for (const auto& [i, at] : parent) {
      if (at.body1 != root && !places_[at.body1].body)
        throw std::invalid_argument("Bullet's multi-bodies are given trees from one fixed body only");
      const InverseMass<M>& mass = bodies.inverse_mass[i];
      const btQuaternion turned = quaternion(Eigen::Quaterniond(rotation_in_space<M>(bodies.pose[i]).conjugate() *
                                                                rotation_in_space<M>(bodies.pose[at.body1])));
      const btVector3 to_pin = vector(in_space(at.arms.first)), from_pin = -vector(in_space(at.arms.second));
      const btVector3 inertia = vector(inertia_in_space(mass));
      const int above = at.body1 == root ? -1 : places_[at.body1].link;
      if (M::linear == 2)
        body.setupRevolute(link, 1 / mass.linear, inertia, above, turned, {0, 0, 1}, to_pin, from_pin);
      else
        body.setupSpherical(link, 1 / mass.linear, inertia, above, turned, to_pin, from_pin);
      places_[i] = {&body, link++};
    }
    finish(body);
  }

  bool rk4_;
  btDefaultCollisionConfiguration configuration_;
  btCollisionDispatcher dispatcher_;
  btDbvtBroadphase broad_phase_;
  btMultiBodyConstraintSolver solver_;
  btMultiBodyDynamicsWorld world_;
  std::vector<std::unique_ptr<btMultiBody>> bodies_;
  std::vector<Place> places_;  // by body; none of what does not move
};

template <class M>
std::unique_ptr<World<M>> build(const Scene<M>& scene, const Knobs& knobs) {
  return std::make_unique<Multibody<M>>(scene, knobs);
}

}  // namespace

void add_bullet_multibody(std::vector<Engine>& all) {
  all.push_back({.name = "Bullet multi-body",
                 .version = std::to_string(btGetVersion() / 100) + "." + std::to_string(btGetVersion() % 100),
                 .method = "one coordinate a hinge: Featherstone's articulated bodies",
                 .file = "lessons/engines/settings/bullet.cpp",
                 .home = Home::both,
                 .settings = bullet_multibody_settings(),
                 .refusal = [](const Asked& asked) -> std::string {
                   if (asked.rods > 0) return "no rigid distance joint between turning bodies";
                   return asked.boxes > 0 ? "compared on joints only: free boxes are Bullet's" : "";
                 },
                 .in_plane = build<PlaneBody>,
                 .in_space = build<SpaceBody>});
}

}  // namespace byhand::engines
