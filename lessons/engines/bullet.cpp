// Bullet, in double precision. It knows space alone: in the plane boxes are 1 m deep, and factors of zero hold
// them there. It multiplies the friction of two bodies, and has no rigid rod between bodies that turn.

#include <BulletDynamics/ConstraintSolver/btNNCGConstraintSolver.h>
#include <BulletDynamics/MLCPSolvers/btDantzigSolver.h>
#include <BulletDynamics/MLCPSolvers/btMLCPSolver.h>
#include <btBulletDynamicsCommon.h>

#include "lessons/engines/in_space.hpp"

namespace byhand::engines {
namespace {

btVector3 vector(const Eigen::Vector3d& v) { return {v.x(), v.y(), v.z()}; }
Eigen::Vector3d vector(const btVector3& v) { return {v.x(), v.y(), v.z()}; }

template <class M>
class Bullet : public World<M> {
 public:
  Bullet(const Scene<M>& scene, const Knobs& knobs)
      : dispatcher_(&configuration_),
        solver_(solver_of(knobs)),
        world_(&dispatcher_, &broad_phase_, solver_.get(), &configuration_) {
    world_.setGravity(vector(in_space(scene.gravity)));
    btContactSolverInfo& info = world_.getSolverInfo();
    knobs.turn("iterations", info.m_numIterations);
    knobs.turn("ERP", info.m_erp);
    knobs.turn("contact ERP", info.m_erp2);
    knobs.turn("CFM", info.m_globalCfm);
    if (knobs.value("DANTZIG", 0) != 0) info.m_minimumSolverBatchSize = 1;  // or its matrix spans all islands
    std::vector<btCollisionShape*> shapes(scene.bodies().size(), keep(std::make_unique<btEmptyShape>()));
    std::vector<double> friction(shapes.size(), 0);
    for_each_shape(
        scene,
        [&](int i, const Box<M>& box, const Surface& surface) {
          shapes[i] = keep(std::make_unique<btBoxShape>(vector(0.5 * sides_in_space(box))));
          friction[i] = friction_factor(surface);
        },
        [&](int i, const HalfSpace<M>& half_space, const Surface& surface) {
          shapes[i] = keep(std::make_unique<btStaticPlaneShape>(vector(in_space(half_space.normal)), 0));
          friction[i] = friction_factor(surface);
        });
    for (int i = 0; i < scene.bodies().size(); ++i) add(scene.bodies(), i, shapes[i], friction[i]);
    for_each_joint(
        scene,
        [&](const Pin<M>& pin) {
          joints_.push_back(std::make_unique<btPoint2PointConstraint>(
              *bodies_[pin.at.body1], *bodies_[pin.at.body2], vector(in_space(pin.at.arms.first)),
              vector(in_space(pin.at.arms.second))));
          world_.addConstraint(joints_.back().get());
        },
        [&](const Distance<M>&) { throw std::invalid_argument("Bullet has no rigid rod"); });
  }
  ~Bullet() override {
    for (const auto& joint : joints_) world_.removeConstraint(joint.get());
    for (const auto& body : bodies_) world_.removeRigidBody(body.get());
  }

  void step(double h) override { world_.stepSimulation(h, 0); }

  void read(Bodies<M>& bodies) const override {
    for (int i = 0; i < bodies.size(); ++i) {
      const btQuaternion q = bodies_[i]->getOrientation();
      put(bodies, i, vector(bodies_[i]->getCenterOfMassPosition()), {q.w(), q.x(), q.y(), q.z()},
          vector(bodies_[i]->getLinearVelocity()), vector(bodies_[i]->getAngularVelocity()));
    }
  }

  void set_velocities(const Bodies<M>& bodies) override {
    for (int i = 0; i < bodies.size(); ++i) {
      if (!moves(bodies.inverse_mass[i])) continue;
      bodies_[i]->setLinearVelocity(vector(velocity_in_space<M>(bodies.velocity[i])));
      bodies_[i]->setAngularVelocity(vector(spin_in_space<M>(bodies.velocity[i])));
    }
  }

 private:
  std::unique_ptr<btSequentialImpulseConstraintSolver> solver_of(const Knobs& knobs) {
    if (knobs.value("DANTZIG", 0) != 0) return std::make_unique<btMLCPSolver>(&dantzig_);
    if (knobs.value("NNCG", 0) != 0) return std::make_unique<btNNCGConstraintSolver>();
    return std::make_unique<btSequentialImpulseConstraintSolver>();
  }
  btCollisionShape* keep(std::unique_ptr<btCollisionShape> shape) {
    shapes_.push_back(std::move(shape));
    return shapes_.back().get();
  }
  void add(const Bodies<M>& bodies, int i, btCollisionShape* shape, double friction) {
    const InverseMass<M>& mass = bodies.inverse_mass[i];
    btRigidBody::btRigidBodyConstructionInfo info(0, nullptr, shape);
    if (moves(mass)) {
      info.m_mass = 1 / mass.linear;
      info.m_localInertia = vector(inertia_in_space(mass));
    }
    const Eigen::Quaterniond q = rotation_in_space<M>(bodies.pose[i]);
    info.m_startWorldTransform =
        btTransform(btQuaternion(q.x(), q.y(), q.z(), q.w()), vector(in_space(bodies.pose[i].position)));
    info.m_friction = friction;
    auto body = std::make_unique<btRigidBody>(info);
    body->setActivationState(DISABLE_DEACTIVATION);
    if constexpr (M::linear == 2) {
      body->setLinearFactor({1, 1, 0});
      body->setAngularFactor({0, 0, 1});
    }
    if (moves(mass)) {
      body->setLinearVelocity(vector(velocity_in_space<M>(bodies.velocity[i])));
      body->setAngularVelocity(vector(spin_in_space<M>(bodies.velocity[i])));
    }
    world_.addRigidBody(body.get());
    bodies_.push_back(std::move(body));
  }

  btDefaultCollisionConfiguration configuration_;
  btCollisionDispatcher dispatcher_;
  btDbvtBroadphase broad_phase_;
  btDantzigSolver dantzig_;
  std::unique_ptr<btSequentialImpulseConstraintSolver> solver_;
  btDiscreteDynamicsWorld world_;
  std::vector<std::unique_ptr<btCollisionShape>> shapes_;
  std::vector<std::unique_ptr<btRigidBody>> bodies_;
  std::vector<std::unique_ptr<btTypedConstraint>> joints_;
};

template <class M>
std::unique_ptr<World<M>> build(const Scene<M>& scene, const Knobs& knobs) {
  return std::make_unique<Bullet<M>>(scene, knobs);
}

}  // namespace

void add_bullet(std::vector<Engine>& all) {
  all.push_back({.name = "Bullet",
                 .version = std::to_string(btGetVersion() / 100) + "." + std::to_string(btGetVersion() % 100),
                 .method = "Gauss–Seidel on velocities",
                 .file = "lessons/engines/settings/bullet.cpp",
                 .settings = bullet_settings(),
                 .refusal = [](const Asked& asked) -> std::string {
                   return asked.rods > 0 ? "no rigid distance joint between turning bodies" : "";
                 },
                 .in_plane = build<PlaneBody>,
                 .in_space = build<SpaceBody>});
}

}  // namespace byhand::engines
