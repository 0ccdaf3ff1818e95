// MuJoCo, in double precision. A pin is a joint of its tree of bodies: coordinates that cannot part in place of
// rows. A body without a pin is free. Of two bodies that touch it takes the greater friction, so both have the
// same here.

#include <mujoco/mujoco.h>

#include <cstring>
#include <locale>
#include <map>
#include <sstream>

#include "lessons/engines/in_space.hpp"

namespace byhand::engines {
namespace {

/// It would print what goes wrong and end the program.
void take_errors() {
  mju_user_warning = [](const char*) {};
  mju_user_error = [](const char* what) { throw std::runtime_error(std::string("MuJoCo: ") + what); };
}

/// The model of a scene, in MuJoCo's XML.
template <class M>
class Model {
 public:
  Model(const Scene<M>& scene, const Knobs& knobs) : scene_(scene), shape_(scene.bodies().size()) {
    xml_.imbue(std::locale::classic());
    xml_.precision(17);
    for_each_joint(
        scene, [&](const Pin<M>& pin) { hang(pin.at); },
        [](const Distance<M>&) { throw std::invalid_argument("MuJoCo has no rigid rod"); });
    describe_shapes();
    const Eigen::Vector3d g = in_space(scene.gravity);
    xml_ << "<mujoco><compiler angle='radian'/><option gravity='" << row(g) << "' integrator='"
         << (knobs.value("RK4", 0) != 0 ? "RK4" : "Euler") << "' cone='"
         << (knobs.value("elliptic", 0) != 0 ? "elliptic" : "pyramidal") << "' impratio='"
         << knobs.value("impratio", 1) << "'/><default><geom solref='" << knobs.value("solref", 0.02)
         << " 1'/></default><worldbody>";
    for (int i = 0; i < scene.bodies().size(); ++i)
      if (!moves(scene.bodies().inverse_mass[i]))
        put_fixed(i);
      else if (!parent_.count(i))
        put_moving(i, nullptr);
    xml_ << "</worldbody></mujoco>";
  }
  std::string text() const { return xml_.str(); }

 private:
  static std::string row(const Eigen::Vector3d& v) {
    std::ostringstream words;
    words.imbue(std::locale::classic());
    words.precision(17);
    words << v.x() << ' ' << v.y() << ' ' << v.z();
    return words.str();
  }
  static std::string row(const Eigen::Quaterniond& q) {
    std::ostringstream words;
    words.imbue(std::locale::classic());
    words.precision(17);
    words << q.w() << ' ' << q.x() << ' ' << q.y() << ' ' << q.z();
    return words.str();
  }

  void hang(const Anchors<M>& at) {
    if (!moves(scene_.bodies().inverse_mass[at.body2]) || !parent_.emplace(at.body2, at).second)
      throw std::invalid_argument("MuJoCo is given trees of pins only");
    children_[at.body1].push_back(at.body2);
  }
  void describe_shapes() {
    for_each_shape(
        scene_,
        [&](int i, const Box<M>& box, const Surface& surface) {
          shape_[i] =
              "<geom type='box' size='" + row(Eigen::Vector3d(0.5 * sides_in_space(box))) + friction(surface);
        },
        [&](int i, const HalfSpace<M>& half_space, const Surface& surface) {
          shape_[i] = "<geom type='plane' size='0 0 1' zaxis='" +
                      row(Eigen::Vector3d(in_space(half_space.normal))) + friction(surface);
        });
  }
  static std::string friction(const Surface& surface) {
    return "' friction='" + std::to_string(surface.friction) + " 0 0'/>";
  }

  void put_fixed(int i) {
    open(i, Eigen::Vector3d::Zero(), Eigen::Quaterniond::Identity());
    close(i);
  }
  /// A body under its parent, whose place in the world is given.
  void put_moving(int i, const Anchors<M>* at, const Eigen::Vector3d& from = Eigen::Vector3d::Zero(),
                  const Eigen::Quaterniond& turned = Eigen::Quaterniond::Identity()) {
    open(i, from, turned);
    const InverseMass<M>& mass = scene_.bodies().inverse_mass[i];
    if (at)
      xml_ << "<joint type='" << (M::linear == 2 ? "hinge' axis='0 0 1" : "ball") << "' pos='"
           << row(Eigen::Vector3d(in_space(at->arms.second))) << "'/>";
    else if (M::linear == 2)
      xml_ << "<joint type='slide' axis='1 0 0'/><joint type='slide' axis='0 1 0'/><joint type='hinge' axis='0 0 "
              "1'/>";
    else
      xml_ << "<freejoint/>";
    xml_ << "<inertial pos='0 0 0' mass='" << 1 / mass.linear << "' diaginertia='" << row(inertia_in_space(mass))
         << "'/>";
    close(i);
  }
  void open(int i, const Eigen::Vector3d& from, const Eigen::Quaterniond& turned) {
    const Pose<M>& pose = scene_.bodies().pose[i];
    const Eigen::Vector3d place = turned.conjugate() * (Eigen::Vector3d(in_space(pose.position)) - from);
    xml_ << "<body name='" << i << "' pos='" << row(place) << "' quat='"
         << row(Eigen::Quaterniond(turned.conjugate() * rotation_in_space<M>(pose))) << "'>";
  }
  void close(int i) {
    xml_ << shape_[i];
    const Pose<M>& pose = scene_.bodies().pose[i];
    if (const auto found = children_.find(i); found != children_.end())
      for (const int child : found->second)
        put_moving(child, &parent_.at(child), in_space(pose.position), rotation_in_space<M>(pose));
    xml_ << "</body>";
  }

  const Scene<M>& scene_;
  std::map<int, Anchors<M>> parent_;          // by the body that hangs there
  std::map<int, std::vector<int>> children_;  // by body
  std::vector<std::string> shape_;            // by body
  std::ostringstream xml_;
};

template <class M>
class Mujoco : public World<M> {
 public:
  Mujoco(const Scene<M>& scene, const Knobs& knobs) {
    take_errors();
    const std::string text = Model<M>(scene, knobs).text();
    const auto files = std::make_unique<mjVFS>();
    mj_defaultVFS(files.get());
    mj_makeEmptyFileVFS(files.get(), "scene.xml", static_cast<int>(text.size()));
    std::memcpy(files->filedata[0], text.data(), text.size());
    char error[500] = "";
    model_.reset(mj_loadXML("scene.xml", files.get(), error, sizeof error));
    mj_deleteVFS(files.get());
    if (!model_) throw std::runtime_error(std::string("MuJoCo: ") + error);
    data_.reset(mj_makeData(model_.get()));
    for (int i = 0; i < scene.bodies().size(); ++i)
      bodies_.push_back(mj_name2id(model_.get(), mjOBJ_BODY, std::to_string(i).c_str()));
    set_velocities(scene.bodies());
  }

  void step(double h) override {
    model_->opt.timestep = h;
    mj_step(model_.get(), data_.get());
  }

  void read(Bodies<M>& bodies) const override {
    // After a step positions are new, but what follows from them is that of its beginning.
    mj_kinematics(model_.get(), data_.get());
    mj_comPos(model_.get(), data_.get());
    mj_comVel(model_.get(), data_.get());
    for (int i = 0; i < bodies.size(); ++i) {
      const mjtNum *x = data_->xpos + 3 * bodies_[i], *q = data_->xquat + 4 * bodies_[i];
      mjtNum v[6];  // of rotation, of the centre
      mj_objectVelocity(model_.get(), data_.get(), mjOBJ_BODY, bodies_[i], v, 0);
      put(bodies, i, {x[0], x[1], x[2]}, {q[0], q[1], q[2], q[3]}, {v[3], v[4], v[5]}, {v[0], v[1], v[2]});
    }
  }
  void set_velocities(const Bodies<M>& bodies) override {
    for (int i = 0; i < bodies.size(); ++i) {
      const int first = model_->body_jntadr[bodies_[i]];
      const bool free =
          first >= 0 && model_->jnt_type[first] != mjJNT_HINGE && model_->jnt_type[first] != mjJNT_BALL;
      if (!free) {
        if (!bodies.velocity[i].isZero()) throw std::invalid_argument("MuJoCo is given trees at rest only");
        continue;
      }
      mjtNum* rate = data_->qvel + model_->jnt_dofadr[first];
      Eigen::Map<Velocity<M>> written(rate);
      written = bodies.velocity[i];
      // A free joint counts spin along the axes of the body.
      if constexpr (M::linear == 3)
        written.template tail<3>() = bodies.pose[i].rotation.conjugate() * spin_in_space<M>(bodies.velocity[i]);
    }
  }

 private:
  struct Free {
    void operator()(mjModel* model) const { mj_deleteModel(model); }
    void operator()(mjData* data) const { mj_deleteData(data); }
  };
  std::unique_ptr<mjModel, Free> model_;
  std::unique_ptr<mjData, Free> data_;
  std::vector<int> bodies_;
};

template <class M>
std::unique_ptr<World<M>> build(const Scene<M>& scene, const Knobs& knobs) {
  return std::make_unique<Mujoco<M>>(scene, knobs);
}

constexpr int deepest = 90, most_boxes = 1;

}  // namespace

void add_mujoco(std::vector<Engine>& all) {
  all.push_back({.name = "MuJoCo",
                 .version = mj_versionString(),
                 .method = "one coordinate a hinge; contacts as soft rows, by Newton's method",
                 .file = "lessons/engines/settings/mujoco.cpp",
                 .home = Home::both,
                 .settings = mujoco_settings(),
                 .refusal = [](const Asked& asked) -> std::string {
                   if (asked.rods > 0) return "no rigid distance joint";
                   if (asked.longest_path > deepest)
                     return "not given more than " + std::to_string(deepest) +
                            " nested bodies: its XML reader's nesting ends near 100";
                   return asked.boxes > most_boxes
                              ? "compared on joints only: with contacts its version 3.14 is, in WebAssembly"
                              : "";
                 },
                 .in_plane = build<PlaneBody>,
                 .in_space = build<SpaceBody>});
}

}  // namespace byhand::engines
