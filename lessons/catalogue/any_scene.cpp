#include "lessons/catalogue/any_scene.hpp"

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>
#include <variant>

#include "lessons/catalogue/separation.hpp"
#include "solver/constraints/contact_manifold.hpp"
#include "solver/constraints/normalised_distance.hpp"
#include "solver/constraints/pin.hpp"
#include "solver/direct/newton_work.hpp"
#include "solver/measure.hpp"

namespace byhand {
namespace {

/// Three numbers of what has two in the plane, and of a rate of turning, which has one.
template <class V>
Eigen::Vector3d in_space(const Eigen::MatrixBase<V>& v) {
  if constexpr (V::RowsAtCompileTime == 1)
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

/// Calls f(i, mass [kg]) for each body that moves.
template <class M, class F>
void for_each_moving(const Bodies<M>& bodies, F&& f) {
  for (int i = 0; i < bodies.size(); ++i)
    if (moves(bodies.inverse_mass[i])) f(i, 1 / bodies.inverse_mass[i].linear);
}

/// Bytes of all constraints and contacts: of every kind that scenes of the catalogue have.
template <class M>
std::size_t constraint_bytes(const Scene<M>& scene, const ConstraintList<M>& contacts) {
  const auto rods = scene.template all<NormalisedDistance>();
  const auto pins = scene.template all<Pin>();
  std::size_t bytes = rods.size_bytes() + pins.size_bytes(), counted = rods.size() + pins.size();
  if constexpr (std::is_same_v<M, PlaneBody>) {
    const auto manifolds = contacts.template all<ContactManifold<M>>();
    bytes += manifolds.size_bytes(), counted += manifolds.size();
  }
  require(counted == static_cast<std::size_t>(scene.count() + contacts.count()), "constraints whose size is known",
          counted, "all");
  return bytes;
}

/// A scene with any method and what that keeps between steps.
template <class M>
struct SceneWithMethod {
  Scene<M> scene;
  Method method = {};
  int bodies = 0;  // that move
  std::variant<AnyStepping::Work<M>, Accelerations::Work<M>, Rattle::Work<M>, Xpbd::Work<M>, Avbd::Work<M>,
               Generalised::Work<M>, Controlled<Rattle>::Work<M>, Controlled<Generalised>::Work<M>>
      work = {};  // that of the method's family

  explicit SceneWithMethod(Scene<M>&& given) : scene(std::move(given)) {
    for_each_moving(scene.bodies(), [&](int, double) { ++bodies; });
  }
};

/// Parts of a time step that was made with this work: equal ones, or as many as were tried.
template <class Family, class Work>
int substeps_of(const Family& family, const Work& work) {
  if constexpr (requires { family.substeps; })
    return family.substeps;
  else if constexpr (requires { work.tried; })
    return work.tried;
  else
    return 1;
}

}  // namespace

struct AnyScene::Running {
  std::variant<SceneWithMethod<PlaneParticle>, SceneWithMethod<PlaneBody>, SceneWithMethod<SpaceParticle>,
               SceneWithMethod<SpaceBody>>
      one;
};

/// Calls f(const Scene<M>&).
template <class F>
auto AnyScene::read(F&& f) const {
  return std::visit([&](const auto& running) { return f(running.scene); }, running_->one);
}

/// Calls f(const Scene<M>&, const ContactManager<M>&).
template <class F>
auto AnyScene::read_with_contacts(F&& f) const {
  return std::visit(
      [&](const auto& running) {
        return std::visit([&](const auto& work) { return f(running.scene, work.contacts); }, running.work);
      },
      running_->one);
}

template <class M>
AnyScene::AnyScene(Scene<M> scene)
    : running_(new Running{decltype(Running::one)(std::in_place_type<SceneWithMethod<M>>, std::move(scene))}) {}
AnyScene::AnyScene(const AnyScene& other)
    : running_(std::make_unique<Running>(*other.running_)), time_(other.time_), effort_(other.effort_) {}
AnyScene::AnyScene(AnyScene&& other) noexcept = default;
AnyScene& AnyScene::operator=(AnyScene other) noexcept {
  running_.swap(other.running_);
  time_ = other.time_;
  effort_ = other.effort_;
  return *this;
}
AnyScene::~AnyScene() = default;

void AnyScene::use(const Method& method) {
  std::visit([](const auto& family) { require_valid(family); }, method);
  if (const std::string reason = refusal(method); !reason.empty()) throw std::invalid_argument(reason);
  std::visit(
      [&]<class M, class Family>(SceneWithMethod<M>& running, const Family& family) {
        running.method = family;
        running.work.template emplace<typename Family::template Work<M>>();
      },
      running_->one, method);
  effort_ = {};
}

std::string AnyScene::refusal(const Method& method) const {
  return read([&](const auto& scene) {
    return std::visit([&](const auto& family) { return byhand::refusal(scene, family); }, method);
  });
}

void AnyScene::step(double h) {
  std::visit(
      [&]<class M>(SceneWithMethod<M>& running) {
        std::visit(
            [&]<class Family>(const Family& family) {
              auto& work = std::get<typename Family::template Work<M>>(running.work);
              advance(running.scene, family, h, work);
              const int substeps = substeps_of(family, work);
              effort_.substeps += substeps;
              effort_.written_rows += static_cast<long long>(substeps) * work.system.rows();
              effort_.bodies += static_cast<long long>(substeps) * running.bodies;
              if (!running.scene.colliders().shapes.empty()) effort_.contacts += work.system.rows();
            },
            running.method);
      },
      running_->one);
  ++effort_.steps;
  time_ += h;
}

Effort AnyScene::effort() const {
  Effort effort = effort_;
  const auto add = [&]<class M>(const SceneWithMethod<M>& running) {
    std::visit(
        [&](const StepWork<M>& work) {
          effort.row_solves = work.row_solves - work.executed.projected_rows;
          effort.executed = work.executed;
          if constexpr (M::angular > 0) effort.computed_pairs = work.contacts.computed();
        },
        running.work);
    if (const auto* work = std::get_if<AnyStepping::Work<M>>(&running.work)) {
      if (const auto* direct = std::any_cast<DirectWork<M>>(&work->solver)) effort.planned = direct->planned;
      if (const auto* by_graph = std::any_cast<ByGraphWork<M>>(&work->solver))
        effort.planned = by_graph->direct.planned;
    }
  };
  std::visit(add, running_->one);
  return effort;
}

double AnyScene::separation() const {
  return read_with_contacts(
      [](const auto& scene, const auto& contacts) { return byhand::separation(scene, contacts); });
}

double AnyScene::energy() const {
  return read([](const auto& scene) { return byhand::energy(scene); });
}

double AnyScene::energy_scale() const {
  return read([]<class M>(const Scene<M>& scene) {
    const auto& bodies = scene.bodies();
    const auto fixed = std::ranges::find_if(bodies.inverse_mass, [](const auto& mass) { return !moves(mass); });
    const auto from = fixed - bodies.inverse_mass.begin();
    Linear<M> centre = Linear<M>::Zero();
    if (fixed != bodies.inverse_mass.end()) centre = bodies.pose[static_cast<std::size_t>(from)].position;
    double scale = 0;
    for_each_moving(bodies,
                    [&](int i, double mass) { scale += mass * (bodies.pose[i].position - centre).norm(); });
    scale *= scene.gravity.norm();
    return scale > 0 ? scale : kinetic_energy(scene.bodies());
  });
}

Eigen::Vector3d AnyScene::momentum() const {
  return read([](const auto& scene) { return in_space(linear_momentum(scene.bodies())); });
}

Eigen::Vector3d AnyScene::angular_momentum() const {
  return read([](const auto& scene) { return in_space(byhand::angular_momentum(scene.bodies())); });
}

Eigen::Vector3d AnyScene::weight() const {
  return read([]<class M>(const Scene<M>& scene) {
    double sum = 0;
    for_each_moving(scene.bodies(), [&](int, double mass) { sum += mass; });
    return in_space(Linear<M>(sum * scene.gravity));
  });
}

double AnyScene::algebraic_error(double h) const {
  return std::visit(
      [=]<class M>(const SceneWithMethod<M>& running) {
        const auto* method = std::get_if<AnyStepping>(&running.method);
        if (!method) return static_cast<double>(NAN);
        Simulation<M, AnyStepping> one{running.scene, *method, std::get<Work<M>>(running.work)};
        const int substeps = std::exchange(one.method.substeps, 1);
        try {
          return byhand::algebraic_error(std::move(one), h / substeps);
        } catch (const SingularSystem&) {
          return static_cast<double>(NAN);
        }
      },
      running_->one);
}

double AnyScene::residual() const {
  return std::visit(
      []<class M>(const SceneWithMethod<M>& running) {
        const auto* work = std::get_if<Work<M>>(&running.work);
        return work && work->version ? byhand::residual(work->system, running.scene.bodies().velocity)
                                     : static_cast<double>(NAN);
      },
      running_->one);
}

double AnyScene::farthest_from(const std::vector<Eigen::Vector3d>& places) const {
  return read([&](const auto& scene) {
    double largest = 0;
    auto place = places.begin();
    for_each_moving(scene.bodies(), [&](int i, double) {
      largest = std::max(largest, (in_space(scene.bodies().pose[i].position) - *place++).squaredNorm());
    });
    return std::sqrt(largest);
  });
}

bool AnyScene::finite() const {
  return read([](const auto& scene) {
    const auto& bodies = scene.bodies();
    for (int i = 0; i < bodies.size(); ++i)
      if (!bodies.pose[i].position.allFinite() || !bodies.velocity[i].allFinite()) return false;
    return true;
  });
}

std::vector<Placement> AnyScene::placements() const {
  return read([](const auto& scene) {
    const auto& bodies = scene.bodies();
    std::vector<Placement> all;
    for (int i = 0; i < bodies.size(); ++i)
      all.push_back(
          {in_space(bodies.pose[i].position), rotation_in_space(bodies.pose[i]), moves(bodies.inverse_mass[i])});
    return all;
  });
}

int AnyScene::degrees_of_freedom() const {
  return read([]<class M>(const Scene<M>& scene) {
    int count = 0;
    for_each_moving(scene.bodies(), [&](int, double) { count += M::dof; });
    return count;
  });
}

namespace {

/// The numbers of rows of its joints. Where they differ, a direct solve takes its general loops.
template <class M>
std::set<int> rows_a_joint(const Scene<M>& scene) {
  std::set<int> rows;
  for_each_constraint(scene, ContactManager<M>(),
                      [&](const ConstraintStore<M>& store, const auto&) { rows.insert(store.rows); });
  return rows;
}

/// Whether most constraints follow one of another kind. Each such turn costs, as those of one kind are solved in
/// one go.
template <class M>
bool alternate(const Scene<M>& scene) {
  std::set<int> kinds;
  int turns = 0, last = -1;
  for (const auto& entry : scene.entries()) {
    turns += entry.kind != last;
    kinds.insert(last = entry.kind);
  }
  return turns > static_cast<int>(kinds.size()) && 2 * turns > scene.count();
}

}  // namespace

std::string AnyScene::row_kind() const {
  return read([]<class M>(const Scene<M>& scene) -> std::string {
    const std::vector<Shape<M>>& shapes = scene.colliders().shapes;
    const auto round = [&](const Shape<M>& shape) {
      const int body = static_cast<int>(&shape - shapes.data());
      return !moves(scene.bodies().inverse_mass[body]) || std::holds_alternative<Ball<M>>(shape) ||
             std::holds_alternative<std::monostate>(shape);
    };
    const bool joined = scene.count() > 0, bounded = scene.bounded();
    std::string kind;
    if (!shapes.empty())
      kind = joined ? "joined shapes" : std::ranges::all_of(shapes, round) ? "balls that touch" : "boxes";
    else if (!joined)
      kind = M::angular == 0 ? "free bobs" : "free bodies";
    else if (M::angular == 0)
      kind = bounded ? "ropes" : alternate(scene) ? "mixed bobs" : "bobs";
    else if (const std::set<int> rows = rows_a_joint(scene); bounded)
      kind = *rows.rbegin() > 3 ? "mixed machines" : "machines";  // in space alone
    else if (rows.size() > 1)
      kind = "mixed joints";
    else if (rows.contains(5))
      kind = "hinges";
    else
      kind = scene.template all<Pin>().empty() ? "balls" : "links";
    return kind + (M::linear == 2 ? "" : " in space");
  });
}

int AnyScene::rows() const {
  return read_with_contacts([](const auto& scene, const auto& contacts) {
    int count = 0;
    for_each_constraint(scene, contacts, [&](const auto& store, const auto&) { count += store.rows; });
    return count;
  });
}

std::size_t AnyScene::scene_bytes() const {
  return read_with_contacts([]<class M>(const Scene<M>& scene, const ContactManager<M>& contacts) {
    return scene.bodies().size() * (sizeof(Pose<M>) + sizeof(Velocity<M>) + sizeof(InverseMass<M>)) +
           scene.colliders().shapes.size() * (sizeof(Shape<M>) + sizeof(Surface)) +
           constraint_bytes(scene, contacts.constraints());
  });
}

std::size_t AnyScene::row_bytes() const {
  return read_with_contacts([]<class M>(const Scene<M>& scene, const ContactManager<M>& contacts) {
    constexpr std::size_t numbers = 8;  // λ, C, bias, γ, rate, two bounds, restitution
    std::size_t bytes = 0;
    for_each_constraint(scene, contacts, [&](const ConstraintStore<M>& store, const auto&) {
      bytes += store.rows * numbers * sizeof(double);
      for_type<M>(store.block_type, [&](auto type) {
        using Blocks = std::tuple_element_t<type, decltype(System<M>::blocks)>;
        bytes += sizeof(typename Blocks::value_type);
      });
    });
    return bytes;
  });
}

template AnyScene::AnyScene(Scene<PlaneParticle>);
template AnyScene::AnyScene(Scene<PlaneBody>);
template AnyScene::AnyScene(Scene<SpaceParticle>);
template AnyScene::AnyScene(Scene<SpaceBody>);

}  // namespace byhand
