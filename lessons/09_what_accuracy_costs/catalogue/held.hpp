#pragma once

#include "lessons/09_what_accuracy_costs/catalogue/any_scene.hpp"

// What AnyScene does, for one type of scene. Included only where a type is instantiated.
namespace byhand {

namespace detail {

/// A simulation of S for each family that Method names.
template <class S, class Families>
struct SimulationsOf;
template <class S, class... Family>
struct SimulationsOf<S, std::variant<Family...>> {
  using type = std::variant<Simulation<S, Family>...>;
};

/// Three numbers of what has two in the plane, and of a rate of turning, which has one.
template <class V>
Eigen::Vector3d in_space(const Eigen::MatrixBase<V>& v) {
  if constexpr (V::RowsAtCompileTime == 0)
    return Eigen::Vector3d::Zero();
  else if constexpr (V::RowsAtCompileTime == 1)
    return {0, 0, v[0]};
  else if constexpr (V::RowsAtCompileTime == 2)
    return {v[0], v[1], 0};
  else
    return v;
}

template <class M>
Eigen::Matrix3d rotation_in_space(const Pose<M>& pose) {
  Eigen::Matrix3d R = Eigen::Matrix3d::Identity();
  if constexpr (M::angular == 1) {
    R(0, 0) = R(1, 1) = pose.rotation.cos;
    R(1, 0) = pose.rotation.sin;
    R(0, 1) = -pose.rotation.sin;
  }
  if constexpr (M::angular == 3) R = pose.rotation.toRotationMatrix();
  return R;
}

template <class Family, class Families>
inline constexpr bool is_among = false;
template <class Family, class... Families>
inline constexpr bool is_among<Family, std::variant<Families...>> = (std::is_same_v<Family, Families> || ...);

template <class S, class Families>
class HeldScene final : public RunningScene {
  using M = typename S::model;

 public:
  explicit HeldScene(S scene) : simulation_(Simulation<S, VelocityStepping>{std::move(scene), {}}) {}

  std::unique_ptr<RunningScene> clone() const override { return std::make_unique<HeldScene>(*this); }

  void use(const Method& method) override {
    std::visit([](const auto& family) { require_valid(family); }, method);
    if (const std::string reason = refusal(method); !reason.empty()) throw std::invalid_argument(reason);
    std::visit(
        [&]<class Family>(const Family& family) {
          if constexpr (is_among<Family, Families>) {
            const double now = time();
            simulation_ = Simulation<S, Family>{S(scene()), family, {}, now};
          }
        },
        method);
  }
  std::string refusal(const Method& method) const override {
    return std::visit(
        [&]<class Family>(const Family& family) -> std::string {
          if constexpr (is_among<Family, Families>)
            return byhand::refusal(scene(), family);
          else
            return "this scene shows what its model costs, and is stepped by velocities alone";
        },
        method);
  }

  void step(double h) override {
    std::visit([&](auto& simulation) { simulation.step(h); }, simulation_);
  }
  double time() const override {
    return std::visit([](const auto& simulation) { return simulation.time; }, simulation_);
  }
  long long row_solves() const override {
    return std::visit([](const auto& simulation) { return static_cast<long long>(simulation.work.row_solves); },
                      simulation_);
  }

  PositionError position_error() const override { return byhand::position_error(scene()); }
  double separation() const override {
    double largest = 0;
    scene().for_each([&](const auto& constraint) {
      using Kind = std::remove_cvref_t<decltype(constraint)>;
      if constexpr (Kind::position_rows > 0) {
        const auto C = constraint.template value<double>(pose(constraint.at.body1), pose(constraint.at.body2))
                           .template head<Kind::position_rows>()
                           .eval();
        largest = std::max(largest, Kind::bound == Bound::none ? C.norm() : -C.minCoeff());
      }
    });
    return largest;
  }
  double energy() const override { return byhand::energy(scene()); }
  double energy_scale() const override {
    double scale = 0;
    for_each_moving([&](int i, double mass) { scale += mass * pose(i).position.norm(); });
    scale *= scene().gravity.norm();
    return scale > 0 ? scale : kinetic_energy(scene().bodies());
  }
  Eigen::Vector3d momentum() const override { return in_space(linear_momentum(scene().bodies())); }
  Eigen::Vector3d angular_momentum() const override {
    return in_space(byhand::angular_momentum<M>(scene().bodies()));
  }
  Eigen::Vector3d weight() const override {
    double mass = 0;
    for_each_moving([&](int, double m) { mass += m; });
    return in_space(Linear<M>(mass * scene().gravity));
  }
  double algebraic_error(double h) const override {
    const auto* stepping = std::get_if<Simulation<S, VelocityStepping>>(&simulation_);
    if (!stepping) return NAN;
    Simulation<S, VelocityStepping> one = *stepping;
    h /= std::exchange(one.method.substeps, 1);
    try {
      return byhand::algebraic_error(one, h);
    } catch (const SingularSystem&) {
      return NAN;
    }
  }
  bool finite() const override {
    for (int i = 0; i < scene().bodies().size(); ++i)
      if (!pose(i).position.allFinite() || !scene().bodies().velocity[i].allFinite()) return false;
    return true;
  }

  std::vector<Placement> placements() const override {
    std::vector<Placement> all;
    for (int i = 0; i < scene().bodies().size(); ++i)
      all.push_back(
          {in_space(pose(i).position), rotation_in_space<M>(pose(i)), moves(scene().bodies().inverse_mass[i])});
    return all;
  }
  std::vector<std::pair<Eigen::Vector3d, Eigen::Vector3d>> velocities() const override {
    std::vector<std::pair<Eigen::Vector3d, Eigen::Vector3d>> all;
    for (const Velocity<M>& V : scene().bodies().velocity)
      all.emplace_back(in_space(V.template head<M::linear>()), in_space(V.template tail<M::angular>()));
    return all;
  }
  std::vector<std::pair<Eigen::Vector3d, Eigen::Vector3d>> joints() const override {
    std::vector<std::pair<Eigen::Vector3d, Eigen::Vector3d>> all;
    scene().for_each([&](const auto& constraint) {
      const auto point = [&](int body, const Arm<M>& arm) {
        return in_space(anchor<M, double>(pose(body), in_world<M, double>(pose(body), arm)));
      };
      all.emplace_back(point(constraint.at.body1, constraint.at.arms.first),
                       point(constraint.at.body2, constraint.at.arms.second));
    });
    return all;
  }

  std::string model() const override {
    return std::string(M::angular > 0 ? "bodies" : "particles") + (M::linear == 2 ? " in the plane" : " in space");
  }
  int degrees_of_freedom() const override {
    int count = 0;
    for_each_moving([&](int, double) { count += M::dof; });
    return count;
  }
  int rows() const override {
    int count = 0;
    scene().for_each([&]<class Kind>(const Kind&) { count += Kind::rows; });
    return count;
  }
  int bodies() const override { return scene().bodies().size(); }
  std::size_t scene_bytes() const override {
    std::size_t bytes = bodies() * (sizeof(Pose<M>) + sizeof(Velocity<M>) + sizeof(InverseMass<M>));
    if constexpr (S::touches) bytes += scene().colliders.shapes.size() * (sizeof(Shape<M>) + sizeof(Surface));
    scene().for_each([&](const auto& constraint) { bytes += sizeof constraint; });
    return bytes;
  }
  std::size_t row_bytes() const override {
    constexpr std::size_t numbers = 8;  // λ, C, bias, γ, rate, two bounds, restitution
    std::size_t bytes = 0;
    scene().for_each([&]<class Kind>(const Kind&) {
      bytes += sizeof(Block<M, Kind::rows, Kind::bound>) + Kind::rows * numbers * sizeof(double);
    });
    return bytes;
  }

 private:
  const S& scene() const {
    return std::visit([](const auto& simulation) -> const S& { return simulation.scene; }, simulation_);
  }
  const Pose<M>& pose(int body) const { return scene().bodies().pose[body]; }
  template <class F>
  void for_each_moving(F&& f) const {
    const auto& masses = scene().bodies().inverse_mass;
    for (int i = 0; i < bodies(); ++i)
      if (moves(masses[i])) f(i, 1 / masses[i].linear);
  }

  typename SimulationsOf<S, Families>::type simulation_;
};

}  // namespace detail

template <class S, class Families>
AnyScene any_scene(S scene) {
  return AnyScene(std::make_unique<detail::HeldScene<S, Families>>(std::move(scene)));
}

}  // namespace byhand
