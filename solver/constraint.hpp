#pragma once

#include <limits>
#include <memory>
#include <new>
#include <typeinfo>
#include <vector>

#include "solver/integrate/jet.hpp"
#include "solver/system.hpp"

// A kind of constraint is a plain struct. Each file of constraints/ has one, with its derivation; a program may
// add its own. A kind for a model M has
//
//   static constexpr int rows               number of rows K
//   Anchors<M> at                           the two bodies, or any struct with body1, body2, require_valid(bodies)
//   Rows<K, T> value<T>(pose1, pose2)       C, for any scalar T so that it can be differentiated automatically; of
//                                           a row that constrains only a rate, the integral of that rate
//   Jacobian<M, K> jacobian(pose1, pose2)   J, the gradient of `value`, derived by hand
//
// and, where the default does not fit:
//
//   static constexpr int position_rows      number of leading rows with a C; the others constrain only a rate.
//                                           Default: all rows
//   static constexpr Bound bound            bound of λ. Default: none
//   bounds(h)                               lower and upper bound of λ over a step h [s], for Bound::interval.
//                                           Default: a one-sided row, λ >= 0
//   double softness                         γ >= 0 of all rows [unit of JM⁻¹Jᵀ]. Default: 0
//   Soft soft(pose1, pose2, h)              γ and bias of a single row that acts like a spring or a motor
//   double coefficient                      μ >= 0, for Bound::friction and Bound::manifold
//   int contact                             handle of the contact whose λ limits the row, for Bound::friction
//   double restitution                      e of a contact, in [0, 1]
//   static constexpr bool periodic          whether `value` is an angle in (-π, π], which may jump by 2π
//   static constexpr bool holds_where_found whether C and J are known at the poses of a substep's start alone, as
//                                           of a contact, whose points are where the shapes touch. Methods
//                                           on positions then go on with C + J times the displacement
//   void require_valid(bodies)              throws std::invalid_argument for other members out of range
//
// A scene keeps all constraints of a kind in one store (Store below). Each stage of a step calls a store once for
// many constraints, so kinds cost no branches within a stage, and a kind that a scene does not use costs nothing.
namespace byhand {

/// A row that acts like a spring or motor over a time step: Δλ = -E(JV + rate + γλ).
struct Soft {
  double gamma = 0, rate = 0;  // γ and the row's own bias [units of C per second]
};

template <class Kind>
constexpr int position_rows_of() {
  if constexpr (requires { Kind::position_rows; }) return Kind::position_rows;
  return Kind::rows;
}
template <class Kind>
constexpr Bound bound_of() {
  if constexpr (requires { Kind::bound; }) return Kind::bound;
  return Bound::none;
}

/// Throws std::invalid_argument unless a scene with these bodies can have this constraint.
template <class Kind, class M>
void require_valid(const Kind& constraint, const Bodies<M>& bodies) {
  constraint.at.require_valid(bodies);
  if constexpr (requires { constraint.softness; }) require_in("softness", constraint.softness, 0, 1e300);
  if constexpr (bound_of<Kind>() == Bound::friction || bound_of<Kind>() == Bound::manifold)
    require_in("friction coefficient", constraint.coefficient, 0, 1e300);
  if constexpr (requires { constraint.restitution; }) require_in("restitution", constraint.restitution, 0, 1);
  if constexpr (requires { constraint.require_valid(bodies); }) constraint.require_valid(bodies);
}

/// The constraints of one kind, with the kind erased. A constraint is named by its index in the store.
template <class M>
class ConstraintStore {
 public:
  int rows = 0, position_rows = 0;
  Bound bound = Bound::none;
  int block_type = 0;
  bool periodic = false, holds_where_found = false;

  virtual ~ConstraintStore() = default;
  virtual std::unique_ptr<ConstraintStore> clone() const = 0;
  virtual const std::type_info& kind() const = 0;
  virtual void erase(int index) = 0;
  virtual void clear() = 0;

  /// Handle of the contact whose λ limits Bound::friction, else -1.
  virtual int contact_of(int index) const = 0;
  /// γ of a constraint, 0 if the kind has `soft` instead.
  virtual double softness(int index) const = 0;

  /// Writes a run of rows at the bodies' poses for a time step h [s]: J, M⁻¹Jᵀ, C, γ, bounds and the rows' own
  /// bias.
  virtual void write_rows(const Run& run, const Bodies<M>& bodies, double h, System<M>& system) const = 0;
  /// J̇V of a run of rows along the paths of all bodies, at the rows' places in `result`.
  virtual void write_bias_accelerations(const Run& run, const std::vector<Pose<M, Jet>>& paths,
                                        const System<M>& system, std::vector<double>& result) const = 0;
  /// Writes `value` of one constraint at the bodies' poses: `rows` numbers.
  virtual void write_value(int index, const Bodies<M>& bodies, double* value) const = 0;
  /// Linearises one constraint, for methods on positions: writes its value, and J and M⁻¹Jᵀ into a Block of this
  /// store's type.
  virtual void linearise(const Bodies<M>& bodies, BlockHeader& block, double* value) const = 0;
};

/// The constraints of one kind, with the kind known.
template <class M, class Kind>
class Constraints : public ConstraintStore<M> {
 public:
  std::vector<Kind> all;
};

/// An empty store, adapted to a kind.
template <class M, class Kind>
std::unique_ptr<ConstraintStore<M>> make_store();

template <class M, class Kind>
class Store final : public Constraints<M, Kind> {
  static constexpr int K = Kind::rows, positions = position_rows_of<Kind>();
  static constexpr Bound B = bound_of<Kind>();
  static constexpr int type = byhand::block_type<M, K, B>();
  using BlockOfKind = Block<M, K, B>;

 public:
  Store() {
    this->rows = K;
    this->position_rows = positions;
    this->bound = B;
    this->block_type = type;
    if constexpr (requires { Kind::periodic; }) this->periodic = Kind::periodic;
    if constexpr (requires { Kind::holds_where_found; }) this->holds_where_found = Kind::holds_where_found;
  }
  std::unique_ptr<ConstraintStore<M>> clone() const override { return std::make_unique<Store>(*this); }
  const std::type_info& kind() const override { return typeid(Kind); }
  void erase(int index) override { this->all.erase(this->all.begin() + index); }
  void clear() override { this->all.clear(); }

  int contact_of(int index) const override {
    if constexpr (B == Bound::friction) return this->all[index].contact;
    return -1;
  }
  double softness(int index) const override { return softness_of(this->all[index]); }

  void write_rows(const Run& run, const Bodies<M>& bodies, double h, System<M>& system) const override {
    BlockOfKind* block = part<type>(system.blocks, run).data();
    for (int i = 0; i < run.count; ++i) write(this->all[block[i].constraint], bodies, h, block[i], system);
  }
  void write_bias_accelerations(const Run& run, const std::vector<Pose<M, Jet>>& paths, const System<M>& system,
                                std::vector<double>& result) const override {
    for (const BlockOfKind& block : part<type>(system.blocks, run))
      Eigen::Map<Rows<K>>{&result[block.row]} =
          bias_acceleration<Kind, M>(this->all[block.constraint], paths[block.body1], paths[block.body2]);
  }
  void write_value(int index, const Bodies<M>& bodies, double* value) const override {
    const Kind& constraint = this->all[index];
    Eigen::Map<Rows<K>>{value} =
        constraint.template value<double>(bodies.pose[constraint.at.body1], bodies.pose[constraint.at.body2]);
  }
  void linearise(const Bodies<M>& bodies, BlockHeader& block, double* value) const override {
    write_value(block.constraint, bodies, value);
    write_jacobian(this->all[block.constraint], bodies, bodies.pose, static_cast<BlockOfKind&>(block));
  }

 private:
  static double softness_of(const Kind& constraint) {
    if constexpr (requires { constraint.softness; }) return constraint.softness;
    return 0;
  }
  static void write_jacobian(const Kind& constraint, const Bodies<M>& bodies, auto& turned, BlockOfKind& block) {
    // Constructed in place: assignment would store single numbers and at once load pairs, which stalls.
    using J = Jacobian<M, K>;
    new (&block.J) J(constraint.jacobian(bodies.pose[block.body1], bodies.pose[block.body2]));
    new (&block.W) J(times_inverse_mass(block.J, bodies.inverse_mass[block.body1], turned[block.body1],
                                        bodies.inverse_mass[block.body2], turned[block.body2]));
  }

  //! [write_rows]
  static void write(const Kind& constraint, const Bodies<M>& bodies, double h, BlockOfKind& block,
                    System<M>& system) {
    const Pose<M>&pose1 = bodies.pose[block.body1], &pose2 = bodies.pose[block.body2];
    const int row = block.row;
    Rows<K> C;
    if constexpr (positions > 0) C = constraint.template value<double>(pose1, pose2);
    write_jacobian(constraint, bodies, system.inverse_inertia, block);
    for (int k = 0; k < positions; ++k) system.C[row + k] = C[k];  // after J, which turns the same arms
    if constexpr (requires { constraint.soft(pose1, pose2, h); }) {
      const Soft soft = constraint.soft(pose1, pose2, h);
      system.gamma[row] = soft.gamma;
      system.target_rate[row] = soft.rate;
    } else {
      for (int k = 0; k < K; ++k) system.gamma[row + k] = softness_of(constraint);
    }
    if constexpr (requires { constraint.restitution; }) system.restitution[row] = constraint.restitution;
    if constexpr (requires { constraint.bounds(h); }) {
      const auto [lower, upper] = constraint.bounds(h);
      system.lower[row] = lower;
      system.upper[row] = upper;
    } else if constexpr (B == Bound::interval) {
      system.lower[row] = 0;
      system.upper[row] = std::numeric_limits<double>::infinity();
    }
    if constexpr (B == Bound::friction || B == Bound::manifold) system.upper[row] = constraint.coefficient;
  }
  //! [write_rows]
};

template <class M, class Kind>
std::unique_ptr<ConstraintStore<M>> make_store() {
  return std::make_unique<Store<M, Kind>>();
}

/// The store of a kind for one model, for the two whose bodies turn, or for all four: BYHAND_STORE declares it
/// after `extern` and otherwise compiles it.
#define BYHAND_STORE(M, Kind) template std::unique_ptr<ConstraintStore<M>> make_store<M, Kind<M>>()
#define BYHAND_STORES_OF_BODIES(prefix, Kind) \
  prefix BYHAND_STORE(PlaneBody, Kind);       \
  prefix BYHAND_STORE(SpaceBody, Kind)
#define BYHAND_STORES(prefix, Kind)         \
  prefix BYHAND_STORE(PlaneParticle, Kind); \
  prefix BYHAND_STORE(SpaceParticle, Kind); \
  BYHAND_STORES_OF_BODIES(prefix, Kind)

}  // namespace byhand
