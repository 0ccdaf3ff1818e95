// The Open Dynamics Engine, in double precision, with its two solvers: QuickStep and the direct one. It knows
// space alone: in the plane boxes are 1 m deep, and a joint (Plane2D) holds each there.

#include <ode/ode.h>

#include <algorithm>
#include <cstdarg>

#include "lessons/engines/in_space.hpp"

namespace byhand::engines {
namespace {

constexpr int most_points = 8;  // of two boxes

template <class M, bool quick>
class Ode : public World<M> {
 public:
  Ode(const Scene<M>& scene, const Knobs& knobs) {
    static const bool begun = dInitODE2(0) != 0;
    if (!begun) throw std::runtime_error("ODE could not be initialised");
    dSetMessageHandler([](int, const char*, va_list) {});  // it warns on standard error
    dRandSetSeed(static_cast<unsigned long>(knobs.value("seed", 1)));
    world_ = dWorldCreate();
    space_ = dHashSpaceCreate(nullptr);
    touching_ = dJointGroupCreate(0);
    const Eigen::Vector3d g = in_space(scene.gravity);
    dWorldSetGravity(world_, g.x(), g.y(), g.z());
    dWorldSetAutoDisableFlag(world_, 0);
    dWorldSetQuickStepNumIterations(
        world_, static_cast<int>(knobs.value("iterations", dWorldGetQuickStepNumIterations(world_))));
    dWorldSetERP(world_, knobs.value("ERP", dWorldGetERP(world_)));
    dWorldSetCFM(world_, knobs.value("CFM", dWorldGetCFM(world_)));
    dWorldSetContactSurfaceLayer(world_, knobs.value("layer", dWorldGetContactSurfaceLayer(world_)));
    for (int i = 0; i < scene.bodies().size(); ++i) add(scene.bodies(), i);
    friction_.assign(bodies_.size(), 0);
    for_each_shape(
        scene,
        [&](int i, const Box<M>& box, const Surface& surface) {
          const Eigen::Vector3d sides = sides_in_space(box);
          add(i, dCreateBox(space_, sides.x(), sides.y(), sides.z()), surface);
          if (bodies_[i]) dGeomSetBody(geoms_.back(), bodies_[i]);
        },
        [&](int i, const HalfSpace<M>& half_space, const Surface& surface) {
          const Eigen::Vector3d up = in_space(half_space.normal);
          add(i, dCreatePlane(space_, up.x(), up.y(), up.z(), 0), surface);
        });
    for_each_joint(
        scene,
        [&](const Pin<M>& pin) {
          const bool hinge = M::linear == 2;
          const dJointID joint = hinge ? dJointCreateHinge(world_, nullptr) : dJointCreateBall(world_, nullptr);
          dJointAttach(joint, bodies_[pin.at.body1], bodies_[pin.at.body2]);
          const Eigen::Vector3d point = at(scene, pin.at.body2, pin.at.arms.second);
          if (hinge) {
            dJointSetHingeAnchor(joint, point.x(), point.y(), point.z());
            dJointSetHingeAxis(joint, 0, 0, 1);
          } else {
            dJointSetBallAnchor(joint, point.x(), point.y(), point.z());
          }
        },
        [&](const Distance<M>& rod) {
          const dJointID joint = dJointCreateDBall(world_, nullptr);
          dJointAttach(joint, bodies_[rod.at.body1], bodies_[rod.at.body2]);
          const Eigen::Vector3d first = at(scene, rod.at.body1, rod.at.arms.first),
                                second = at(scene, rod.at.body2, rod.at.arms.second);
          dJointSetDBallAnchor1(joint, first.x(), first.y(), first.z());
          dJointSetDBallAnchor2(joint, second.x(), second.y(), second.z());
        });
  }
  ~Ode() override {
    dJointGroupDestroy(touching_);
    dSpaceDestroy(space_);
    dWorldDestroy(world_);
  }

  void step(double h) override {
    if (std::ranges::any_of(bodies_, exploded)) return;
    dSpaceCollide(space_, this, touch);
    quick ? dWorldQuickStep(world_, h) : dWorldStep(world_, h);
    dJointGroupEmpty(touching_);
  }

  void read(Bodies<M>& bodies) const override {
    const auto vector = [](const dReal* v) { return Eigen::Vector3d(v[0], v[1], v[2]); };
    for (int i = 0; i < bodies.size(); ++i) {
      if (!bodies_[i]) continue;
      const dReal* q = dBodyGetQuaternion(bodies_[i]);
      put(bodies, i, vector(dBodyGetPosition(bodies_[i])), {q[0], q[1], q[2], q[3]},
          vector(dBodyGetLinearVel(bodies_[i])), vector(dBodyGetAngularVel(bodies_[i])));
    }
  }

  void set_velocities(const Bodies<M>& bodies) override {
    for (int i = 0; i < bodies.size(); ++i) {
      if (!bodies_[i]) continue;
      const Eigen::Vector3d v = velocity_in_space<M>(bodies.velocity[i]),
                            spin = spin_in_space<M>(bodies.velocity[i]);
      dBodySetLinearVel(bodies_[i], v.x(), v.y(), v.z());
      dBodySetAngularVel(bodies_[i], spin.x(), spin.y(), spin.z());
    }
  }

 private:
  /// A body faster than 10⁶ m/s or rad/s. Where numbers overflow, ODE's checks end the program.
  static bool exploded(dBodyID body) {
    const auto fast = [](const dReal* v) { return !(Eigen::Vector3d(v[0], v[1], v[2]).norm() < 1e6); };
    return body && (fast(dBodyGetLinearVel(body)) || fast(dBodyGetAngularVel(body)));
  }

  static Eigen::Vector3d at(const Scene<M>& scene, int body, const Arm<M>& arm) {
    const Pose<M>& pose = scene.bodies().pose[body];
    return in_space(anchor<M, double>(pose, in_world<M, double>(pose, arm)));
  }

  /// What does not move is no body of ODE's.
  void add(const Bodies<M>& bodies, int i) {
    const InverseMass<M>& mass = bodies.inverse_mass[i];
    if (!moves(mass)) return bodies_.push_back(nullptr);
    const dBodyID body = dBodyCreate(world_);
    bodies_.push_back(body);
    const Eigen::Vector3d x = in_space(bodies.pose[i].position), v = velocity_in_space<M>(bodies.velocity[i]),
                          spin = spin_in_space<M>(bodies.velocity[i]), inertia = inertia_in_space(mass);
    const Eigen::Quaterniond q = rotation_in_space<M>(bodies.pose[i]);
    const dReal rotation[] = {q.w(), q.x(), q.y(), q.z()};
    dMass shared;
    dMassSetParameters(&shared, 1 / mass.linear, 0, 0, 0, inertia.x(), inertia.y(), inertia.z(), 0, 0, 0);
    dBodySetMass(body, &shared);
    dBodySetPosition(body, x.x(), x.y(), x.z());
    dBodySetQuaternion(body, rotation);
    dBodySetLinearVel(body, v.x(), v.y(), v.z());
    dBodySetAngularVel(body, spin.x(), spin.y(), spin.z());
    if constexpr (M::linear == 2) dJointAttach(dJointCreatePlane2D(world_, nullptr), body, nullptr);
  }
  void add(int i, dGeomID geom, const Surface& surface) {
    friction_[i] = friction_factor(surface);
    dGeomSetData(geom, &friction_[i]);
    geoms_.push_back(geom);
  }
  static void touch(void* self, dGeomID first, dGeomID second) {
    const auto* world = static_cast<const Ode*>(self);
    const dBodyID body1 = dGeomGetBody(first), body2 = dGeomGetBody(second);
    if (!body1 && !body2) return;
    if (body1 && body2 && dAreConnectedExcluding(body1, body2, dJointTypeContact)) return;
    dContact contacts[most_points];
    const int points = dCollide(first, second, most_points, &contacts[0].geom, sizeof(dContact));
    for (int p = 0; p < points; ++p) {
      contacts[p].surface.mode = dContactApprox1;
      contacts[p].surface.mu =
          *static_cast<double*>(dGeomGetData(first)) * *static_cast<double*>(dGeomGetData(second));
      dJointAttach(dJointCreateContact(world->world_, world->touching_, &contacts[p]), body1, body2);
    }
  }

  dWorldID world_;
  dSpaceID space_;
  dJointGroupID touching_;
  std::vector<dBodyID> bodies_;
  std::vector<dGeomID> geoms_;
  std::vector<double> friction_;
};

template <class M, bool quick>
std::unique_ptr<World<M>> build(const Scene<M>& scene, const Knobs& knobs) {
  return std::make_unique<Ode<M, quick>>(scene, knobs);
}

}  // namespace

void add_ode(std::vector<Engine>& all) {
  const Engine ode{.name = "ODE",
                   .version = "0.16",
                   .file = "lessons/engines/settings/ode.cpp",
                   .build = "Debian's is compiled with its checks on"};
  Engine& quick = all.emplace_back(ode);
  quick.name += " QuickStep";
  quick.method = "Gauss–Seidel with over-relaxation, rows in random order";
  quick.random_rows = true;
  quick.settings = ode_quick_settings();
  quick.in_plane = build<PlaneBody, true>, quick.in_space = build<SpaceBody, true>;
  Engine& direct = all.emplace_back(ode);
  direct.name += " direct";
  direct.method = "all rows at once: Dantzig's method on a dense matrix";
  direct.settings = ode_direct_settings();
  direct.in_plane = build<PlaneBody, false>, direct.in_space = build<SpaceBody, false>;
  direct.refusal = [](const Asked& asked) -> std::string {
    if (asked.boxes > 1)
      return "piles: as shipped a straight stack of ten falls, and the time grows as the cube of the number "
             "of rows";
    return asked.pins > 60 ? "takes a time that grows as the cube of the number of rows" : "";
  };
}

}  // namespace byhand::engines
