#include "lessons/engines/mujoco_model.hpp"

#include <locale>
#include <map>
#include <sstream>

#include "lessons/engines/in_space.hpp"

namespace byhand::engines {
namespace {

/// Writes it.
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

constexpr int deepest = 90;

}  // namespace

std::string mujoco_refusal(const Asked& asked) {
  if (asked.rods > 0) return "no rigid distance joint";
  if (asked.longest_path <= deepest) return "";
  return "is not given more than " + std::to_string(deepest) +
         " bodies in a row, which nest in its XML: its reader ends near 100";
}

template <class M>
std::string mujoco_model(const Scene<M>& scene, const Knobs& knobs) {
  return Model<M>(scene, knobs).text();
}

template std::string mujoco_model(const Scene<PlaneBody>&, const Knobs&);
template std::string mujoco_model(const Scene<SpaceBody>&, const Knobs&);

}  // namespace byhand::engines
