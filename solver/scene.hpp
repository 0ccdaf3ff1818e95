#pragma once

#include <tuple>
#include <utility>
#include <vector>

#include "solver/body.hpp"
#include "solver/collide/shape.hpp"
#include "solver/constraints/contact.hpp"
#include "solver/constraints/face_contact.hpp"
#include "solver/graph.hpp"
#include "solver/system.hpp"

namespace byhand {

/// How a body's surface behaves. Two that touch have the friction √(μ1 μ2) and the larger restitution.
struct Surface {
  double friction = 0.6;   // μ >= 0
  double restitution = 0;  // e in [0, 1]
};

/// What of the bodies can touch, by body.
template <class M>
struct Colliders {
  std::vector<Shape<M>> shapes;
  std::vector<Surface> surfaces;
  double margin = 0.02;  // what is nearer than this becomes a contact, for it may touch within the step [m]
};
struct NoColliders {};

/// The bodies and constraints of one scene. The kinds of constraint are part of the type: a kind that is not
/// named costs nothing, neither a branch nor a byte. `Scene<PlaneParticle, Distance>` is a mesh of rods in
/// the plane.
template <class M, template <class> class... Kinds>
class Scene {
 public:
  using model = M;

  template <template <class> class Kind>
  static constexpr bool names = (std::is_same_v<Kind<M>, Kinds<M>> || ...);
  /// Whether contacts are looked for: only where the scene's type names what they would become.
  static constexpr bool touches = [] {
    if constexpr (std::is_same_v<M, PlaneBody>)
      return names<Contact> || names<FaceContact>;
    else
      return M::angular > 0 && names<Contact>;
  }();

  Bodies<M> bodies;
  Linear<M> gravity = -9.81 * Linear<M>::Unit(1);  // [m/s²]; y is up
  [[no_unique_address]] std::conditional_t<touches, Colliders<M>, NoColliders> colliders;

  /// Adds a body (see InverseMass for how to fix one) and returns its index.
  int add_body(const Pose<M>& pose, const InverseMass<M>& mass,
               const Velocity<M>& velocity = Velocity<M>::Zero()) {
    return bodies.add(pose, mass, velocity);
  }
  /// Adds an unturned body at a point [m].
  int add_body(const Linear<M>& position, const InverseMass<M>& mass,
               const Velocity<M>& velocity = Velocity<M>::Zero()) {
    Pose<M> pose;
    pose.position = position;
    return bodies.add(pose, mass, velocity);
  }

  /// Lets a body touch others. Throws std::invalid_argument for a shape or surface outside its range.
  void set_shape(int body, const Shape<M>& shape, const Surface& surface = {}) requires touches {
    require_body(bodies, body);
    require_valid<M>(shape);
    require_in("friction coefficient", surface.friction, 0, 1e300);
    require_in("restitution", surface.restitution, 0, 1);
    colliders.shapes.resize(bodies.size());
    colliders.surfaces.resize(bodies.size());
    colliders.shapes[body] = shape;
    colliders.surfaces[body] = surface;
  }

  /// Adds a constraint and returns its number: constraints are counted in the order in which they come,
  /// whatever their kind, and that is their natural order. Throws std::invalid_argument for what the kind
  /// refuses.
  template <template <class> class Kind>
  int add(const Kind<M>& constraint) {
    constraint.require_valid(bodies);
    if constexpr (Kind<M>::bound == Bound::ball) {
      bool presses = false;
      if (0 <= constraint.leader && constraint.leader < count())
        visit(numbered_[constraint.leader],
              [&]<class Leader>(const Leader&) { presses = Leader::bound == Bound::interval; });
      require(presses, "leading constraint", constraint.leader, "the number of a contact that was added before");
    }
    forget_found();
    const int number = append(constraint);
    lasting_ = count();
    return number;
  }

  int count() const { return static_cast<int>(numbered_.size()); }
  /// How many of them were added and stay; the others were found.
  int lasting() const { return lasting_; }
  /// Changes whenever constraints come or go.
  int version() const { return version_; }

  /// Adds a constraint that stands only until the next look for contacts, and returns its number.
  template <template <class> class Kind>
  int add_found(const Kind<M>& constraint) {
    return append(constraint);
  }
  /// Removes all constraints that were found.
  void forget_found() {
    if (count() == lasting_) return;
    numbered_.resize(lasting_);
    std::apply([&](auto&... kinds) { (kinds.resize(how_many_of(kinds)), ...); }, constraints_);
    ++version_;
  }
  /// The constraint of that number, which is of that kind.
  template <template <class> class Kind>
  Kind<M>& at(int number) {
    return std::get<std::vector<Kind<M>>>(constraints_)[numbered_[number].index];
  }

  template <template <class> class Kind>
  const std::vector<Kind<M>>& all() const {
    return std::get<std::vector<Kind<M>>>(constraints_);
  }
  /// Constraints may be changed between steps in all but their bodies.
  template <template <class> class Kind>
  std::vector<Kind<M>>& all() {
    return std::get<std::vector<Kind<M>>>(constraints_);
  }

  /// Calls f(constraint) for each constraint in natural order.
  template <class F>
  void for_each(F&& f) const {
    for (const Number& number : numbered_) visit(number, f);
  }

  /// Calls f(constraint) for the constraint of that number.
  template <class F>
  void visit(int number, F&& f) const {
    visit(numbered_[number], f);
  }

  /// What the order of solving depends on; a body that does not move takes no part.
  Graph graph() const;

  /// Lays the system's blocks out in this order of constraint numbers. λ is kept for constraints that were added
  /// and stay.
  void lay_out(const std::vector<int>& order, System<M>& system) const;

  /// Writes J, M⁻¹Jᵀ, C, γ, bounds and what a row adds to its bias, at the current poses, for a time step h [s].
  void write_rows(System<M>& system, double h) const;

 private:
  struct Number {
    int kind, index;
  };

  template <class Kind>
  static constexpr int kind_of() {
    int index = 0, found = -1;
    ((std::is_same_v<Kind, Kinds<M>> ? void(found = index++) : void(index++)), ...);
    return found;
  }

  /// Calls f with the vector of constraints of one kind.
  template <class F>
  void visit_kind(int kind, F&& f) const {
    [&]<std::size_t... I>(std::index_sequence<I...>) {
      (void)((static_cast<int>(I) == kind && (f(std::get<I>(constraints_)), true)) || ...);
    }
    (std::index_sequence_for<Kinds<M>...>());
  }

  template <class F>
  void visit(const Number& number, F&& f) const {
    visit_kind(number.kind, [&](const auto& constraints) { f(constraints[number.index]); });
  }

  template <template <class> class Kind>
  int append(const Kind<M>& constraint) {
    auto& all = std::get<std::vector<Kind<M>>>(constraints_);
    numbered_.push_back({kind_of<Kind<M>>(), static_cast<int>(all.size())});
    all.push_back(constraint);
    ++version_;
    return count() - 1;
  }
  /// How many of a kind the numbers name.
  template <class Kind>
  std::size_t how_many_of(const std::vector<Kind>&) const {
    return std::count_if(numbered_.begin(), numbered_.end(),
                         [](const Number& number) { return number.kind == kind_of<Kind>(); });
  }

  template <class Kind, class BlockOfKind>
  void write(const Kind& constraint, BlockOfKind& block, double h, System<M>& system) const;

  std::tuple<std::vector<Kinds<M>>...> constraints_;
  std::vector<Number> numbered_;
  int lasting_ = 0, version_ = 0;
};

template <class M, template <class> class... Kinds>
Graph Scene<M, Kinds...>::graph() const {
  Graph graph{bodies.size(), {}};
  for_each([&](const auto& constraint) {
    const auto end = [&](int body) { return moves(bodies.inverse_mass[body]) ? body : Edge::no_body; };
    graph.edges.push_back(
        {end(constraint.at.body1), end(constraint.at.body2), std::remove_cvref_t<decltype(constraint)>::rows});
  });
  return graph;
}

template <class M, template <class> class... Kinds>
void Scene<M, Kinds...>::lay_out(const std::vector<int>& order, System<M>& system) const {
  const std::vector<int> old_row = std::move(system.row_of);
  const std::vector<double> old_lambda = system.lambda;
  std::apply([](auto&... blocks) { (blocks.clear(), ...); }, system.blocks);
  system.runs.clear();
  system.source.clear();
  system.row_of.assign(count(), 0);
  system.bounded = false;
  int row = 0;
  for (const int number : order) {
    const auto [kind, index] = numbered_[number];
    visit(numbered_[number], [&, k = kind, i = index](const auto& constraint) {
      using Kind = std::remove_cvref_t<decltype(constraint)>;
      constexpr int type = block_type<M, Kind::rows, Kind::bound>();
      auto& blocks = std::get<type>(system.blocks);
      if (system.runs.empty() || system.runs.back().kind != k)
        system.runs.push_back({k, type, static_cast<int>(blocks.size()), 0, row, Kind::drifting});
      ++system.runs.back().count;
      auto& block = blocks.emplace_back();
      block.body1 = constraint.at.body1;
      block.body2 = constraint.at.body2;
      block.moves1 = moves(bodies.inverse_mass[block.body1]);
      block.moves2 = moves(bodies.inverse_mass[block.body2]);
      block.row = row;
      system.source.push_back(i);
      system.row_of[number] = row;
      system.bounded = system.bounded || Kind::bound != Bound::none;
      row += Kind::rows;
    });
  }
  for (auto* numbers : {&system.lambda, &system.C, &system.bias, &system.gamma, &system.rate, &system.lower,
                        &system.upper, &system.restitution})
    numbers->assign(row, 0.0);
  for (int number = 0; number < system.lasting; ++number)
    visit(numbered_[number], [&](const auto& constraint) {
      for (int k = 0; k < std::remove_cvref_t<decltype(constraint)>::rows; ++k)
        system.lambda[system.row_of[number] + k] = old_lambda[old_row[number] + k];
    });
  system.lasting = lasting_;
}

//! [write_rows]
template <class M, template <class> class... Kinds>
void Scene<M, Kinds...>::write_rows(System<M>& system, double h) const {
  const int* source = system.source.data();
  for (const Run& run : system.runs)
    visit_kind(run.kind, [&]<class Kind>(const std::vector<Kind>& constraints) {
      auto& blocks = std::get<block_type<M, Kind::rows, Kind::bound>()>(system.blocks);
      for (int i = run.first; i < run.first + run.count; ++i) write(constraints[*source++], blocks[i], h, system);
    });
}

template <class M, template <class> class... Kinds>
template <class Kind, class BlockOfKind>
void Scene<M, Kinds...>::write(const Kind& constraint, BlockOfKind& block, double h, System<M>& system) const {
  const Pose<M>&pose1 = bodies.pose[block.body1], &pose2 = bodies.pose[block.body2];
  if constexpr (Kind::drifting > 0) {
    const Rows<Kind::rows> C = constraint.template value<double>(pose1, pose2);
    for (int k = 0; k < Kind::drifting; ++k) system.C[block.row + k] = C[k];
  }
  // Made in place: assigned, they would be written number by number and at once read back in pairs, which stalls.
  using J = Jacobian<M, Kind::rows>;
  new (&block.J) J(constraint.jacobian(pose1, pose2));
  new (&block.W) J(times_inverse_mass(block.J, bodies.inverse_mass[block.body1], pose1,
                                      bodies.inverse_mass[block.body2], pose2));
  if constexpr (requires { constraint.soft(pose1, pose2, h); }) {
    const Soft soft = constraint.soft(pose1, pose2, h);
    system.gamma[block.row] = soft.gamma;
    system.rate[block.row] = soft.rate;
  } else {
    for (int k = 0; k < Kind::rows; ++k) system.gamma[block.row + k] = constraint.softness;
  }
  if constexpr (requires { constraint.restitution; }) system.restitution[block.row] = constraint.restitution;
  if constexpr (Kind::bound == Bound::interval) {
    const auto [lower, upper] = constraint.bounds(h);
    system.lower[block.row] = lower;
    system.upper[block.row] = upper;
  }
  if constexpr (Kind::bound == Bound::face) system.upper[block.row] = constraint.coefficient;
  if constexpr (Kind::bound == Bound::ball) {
    system.upper[block.row] = constraint.coefficient;
    block.leader = system.row_of[constraint.leader];
  }
}
//! [write_rows]

/// Whether any row of the scene is bounded, or would be of what may come to touch.
template <class S>
bool has_bounds(const S& scene) {
  bool any = false;
  if constexpr (S::touches) any = !scene.colliders.shapes.empty();
  scene.for_each([&](const auto& constraint) {
    any = any || std::remove_cvref_t<decltype(constraint)>::bound != Bound::none;
  });
  return any;
}

/// What every step begins with: throws std::invalid_argument for a time step [s] that is not positive, gravity
/// that is no number, a method outside its range, and a method that refuses the scene.
template <class S, class Method>
void require_steppable(const S& scene, const Method& method, double step) {
  require_positive("time step", step, "s");
  for (const double g : scene.gravity) require_finite("gravity", g, "m/s²");
  require_valid(method);
  if (const std::string reason = refusal(scene, method); !reason.empty()) throw std::invalid_argument(reason);
}

}  // namespace byhand
