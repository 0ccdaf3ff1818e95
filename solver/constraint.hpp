#pragma once

#include <algorithm>
#include <memory>
#include <new>
#include <typeinfo>
#include <vector>

#include "solver/integrate/jet.hpp"
#include "solver/system.hpp"

// A kind of constraint is a plain struct, one file each in constraints/; a program may have kinds of its own. It
// has
//
//   static constexpr int rows                         K
//   static constexpr int position_rows                how many of them, the first, have a C; the others have only
//   a rate static constexpr Bound bound                      of λ at.body1, at.body2 the two bodies Rows<K, T>
//   value<T>(pose1, pose2)                 C, for any scalar T; of a row without a C, what JV is the rate of
//   Jacobian<M, K> jacobian(pose1, pose2)             J, the gradient of `value`, derived by hand
//   void require_valid(bodies)                        throws std::invalid_argument
//   double softness, or Soft soft(pose1, pose2, h)    γ, or γ and what the row adds to its bias
//
// and, by its bound: bounds(h) with Bound::interval; coefficient μ with Bound::friction and Bound::manifold, with
// friction also `contact`, the identity of the constraint that presses. Contacts have a restitution besides.
//
// A scene keeps all constraints of a kind together, in a store that is adapted to the kind once (Store below).
// Stages of a step call it once for many constraints, so that the kind costs no branch within a stage and a kind
// that no scene has costs nothing.
namespace byhand {

/// What a row that acts like a spring or a motor asks for over a time step: Δλ = -E(JV + rate + γλ).
struct Soft {
  double gamma = 0, rate = 0;  // γ, and what is added to the bias [units of C per second]
};

/// The constraints of one kind, whatever it is: what a scene and the methods ask of them. Constraints are named by
/// their index in the store.
template <class M>
class ConstraintStore {
 public:
  int rows = 0, position_rows = 0;
  Bound bound = Bound::none;
  int block_type = 0;
  bool periodic = false;  // whether its value is an angle in (-π, π], which may pass half a turn within a step

  virtual ~ConstraintStore() = default;
  virtual std::unique_ptr<ConstraintStore> clone() const = 0;
  virtual const std::type_info& kind() const = 0;
  virtual int size() const = 0;
  virtual void erase(int index) = 0;
  virtual void truncate(int size) = 0;

  /// The identity of the constraint that presses, for Bound::friction.
  virtual int contact_of(int index) const = 0;
  /// γ of its first row without a step, and whether it acts like a spring or a motor.
  virtual double softness(int index) const = 0;

  /// Writes a run of rows at the bodies' poses, for a time step h [s]: J, M⁻¹Jᵀ, C, γ, bounds, and what a row adds
  /// to its bias.
  virtual void write_rows(const Run& run, const Bodies<M>& bodies, double h, System<M>& system) const = 0;
  /// J̇V of a run of rows along the paths of all bodies.
  virtual void write_bias_accelerations(const Run& run, const std::vector<Pose<M, Jet>>& paths,
                                        const System<M>& system, std::vector<double>& result) const = 0;
  /// `value` of one constraint, at the bodies' poses, into `rows` numbers.
  virtual void write_value(int index, const Bodies<M>& bodies, double* value) const = 0;
  /// One constraint for methods on positions: its value, and J and M⁻¹Jᵀ into a Block of this store's type.
  virtual void linearise(const Bodies<M>& bodies, BlockHeader& block, double* value) const = 0;
};

/// The constraints of one kind, as they are.
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
  static constexpr int K = Kind::rows;
  using BlockOfKind = Block<M, K, Kind::bound>;

 public:
  Store() {
    this->rows = K;
    this->position_rows = Kind::position_rows;
    this->bound = Kind::bound;
    this->block_type = byhand::block_type<M, K, Kind::bound>();
    if constexpr (requires { Kind::periodic; }) this->periodic = Kind::periodic;
  }
  std::unique_ptr<ConstraintStore<M>> clone() const override { return std::make_unique<Store>(*this); }
  const std::type_info& kind() const override { return typeid(Kind); }
  int size() const override { return static_cast<int>(this->all.size()); }
  void erase(int index) override { this->all.erase(this->all.begin() + index); }
  void truncate(int size) override { this->all.erase(this->all.begin() + size, this->all.end()); }

  int contact_of(int index) const override {
    if constexpr (Kind::bound == Bound::friction)
      return this->all[index].contact;
    else
      return -1;
  }
  double softness(int index) const override {
    if constexpr (requires { this->all[index].softness; })
      return this->all[index].softness;
    else
      return 0;
  }

  void write_rows(const Run& run, const Bodies<M>& bodies, double h, System<M>& system) const override {
    BlockOfKind* block = part<byhand::block_type<M, K, Kind::bound>()>(system.blocks, run).data();
    for (int i = 0; i < run.count; ++i) write(this->all[block[i].constraint], bodies, h, block[i], system);
  }
  void write_bias_accelerations(const Run& run, const std::vector<Pose<M, Jet>>& paths, const System<M>& system,
                                std::vector<double>& result) const override {
    for (const BlockOfKind& block : part<byhand::block_type<M, K, Kind::bound>()>(system.blocks, run)) {
      Eigen::Map<Rows<K>> J_dot_V(&result[block.row]);
      J_dot_V = bias_acceleration<Kind, M>(this->all[block.constraint], paths[block.body1], paths[block.body2]);
    }
  }
  void write_value(int index, const Bodies<M>& bodies, double* value) const override {
    const Kind& constraint = this->all[index];
    Eigen::Map<Rows<K>> C(value);
    C = constraint.template value<double>(bodies.pose[constraint.at.body1], bodies.pose[constraint.at.body2]);
  }
  void linearise(const Bodies<M>& bodies, BlockHeader& block, double* value) const override {
    write_value(block.constraint, bodies, value);
    write_jacobian(this->all[block.constraint], bodies, static_cast<BlockOfKind&>(block));
  }

 private:
  static void write_jacobian(const Kind& constraint, const Bodies<M>& bodies, BlockOfKind& block) {
    const Pose<M>&pose1 = bodies.pose[block.body1], &pose2 = bodies.pose[block.body2];
    // Constructed in place: assigned, J and W would be stored number by number and at once loaded in pairs, which
    // stalls.
    using J = Jacobian<M, K>;
    new (&block.J) J(constraint.jacobian(pose1, pose2));
    new (&block.W) J(times_inverse_mass(block.J, bodies.inverse_mass[block.body1], pose1,
                                        bodies.inverse_mass[block.body2], pose2));
  }

  //! [write_rows]
  static void write(const Kind& constraint, const Bodies<M>& bodies, double h, BlockOfKind& block,
                    System<M>& system) {
    const Pose<M>&pose1 = bodies.pose[block.body1], &pose2 = bodies.pose[block.body2];
    const int row = block.row;
    if constexpr (Kind::position_rows > 0) {
      const Rows<K> C = constraint.template value<double>(pose1, pose2);
      for (int k = 0; k < Kind::position_rows; ++k) system.C[row + k] = C[k];
    }
    write_jacobian(constraint, bodies, block);
    if constexpr (requires { constraint.soft(pose1, pose2, h); }) {
      const Soft soft = constraint.soft(pose1, pose2, h);
      system.gamma[row] = soft.gamma;
      system.rate[row] = soft.rate;
    } else {
      for (int k = 0; k < K; ++k) system.gamma[row + k] = constraint.softness;
    }
    if constexpr (requires { constraint.restitution; }) system.restitution[row] = constraint.restitution;
    if constexpr (Kind::bound == Bound::interval) {
      const auto [lower, upper] = constraint.bounds(h);
      system.lower[row] = lower;
      system.upper[row] = upper;
    }
    if constexpr (Kind::bound == Bound::friction || Kind::bound == Bound::manifold)
      system.upper[row] = constraint.coefficient;
  }
  //! [write_rows]
};

template <class M, class Kind>
std::unique_ptr<ConstraintStore<M>> make_store() {
  return std::make_unique<Store<M, Kind>>();
}

/// Declares that the store of a kind is compiled in the library, for one model or for each.
#define BYHAND_STORE_IN_LIBRARY(M, Kind) \
  extern template std::unique_ptr<ConstraintStore<M>> make_store<M, Kind<M>>()
#define BYHAND_STORES_IN_LIBRARY(Kind)          \
  BYHAND_STORE_IN_LIBRARY(PlaneParticle, Kind); \
  BYHAND_STORE_IN_LIBRARY(PlaneBody, Kind);     \
  BYHAND_STORE_IN_LIBRARY(SpaceParticle, Kind); \
  BYHAND_STORE_IN_LIBRARY(SpaceBody, Kind)

}  // namespace byhand
