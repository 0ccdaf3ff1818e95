#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "solver/constraint.hpp"
#include "solver/contact/shape.hpp"

namespace byhand {

struct Graph;
template <class M>
class ContactManager;

/// How a body's surface behaves. Two that touch have the friction √(μ1 μ2) and the larger restitution.
struct Surface {
  double friction = 0.6;   // μ >= 0
  double restitution = 0;  // e in [0, 1]
};

/// Whom a body can touch: two do where each meets a layer that the other is in, one bit a layer.
struct Layers {
  std::uint32_t in = 1, meets = ~std::uint32_t{};
};
inline bool meet(const Layers& a, const Layers& b) { return (a.meets & b.in) && (b.meets & a.in); }

/// What bodies that touch become: in the plane one ContactManifold for both points; or a Contact for each point,
/// with Friction where the surfaces have any. In space always the latter.
enum class ContactRows { manifold, points };

/// Collision shapes and surfaces, indexed by body; empty where nothing can touch.
template <class M>
struct Colliders {
  std::vector<Shape<M>> shapes;
  std::vector<Surface> surfaces;
  std::vector<Layers> layers;
  std::vector<std::uint64_t> stamps;  // of the body that has the shape: no other in any scene, but its copies
  // Bodies nearer than margin + lookahead |v| h get a contact, for they may touch within the step h.
  double margin = 0.02;  // [m]
  double lookahead = 1;
  ContactRows rows = M::linear == 2 ? ContactRows::manifold : ContactRows::points;
};

/// Names a constraint as long as its scene has it, whatever else comes and goes.
template <class Kind>
struct Handle {
  int id = -1;
  operator int() const { return id; }
};

/// The bodies and constraints of one scene. The model is its type; kinds of constraint are not, and one that no
/// constraint has costs nothing. Only the scene adds, changes and removes bodies and constraints, and `version`
/// changes whenever that alters how rows are laid out. A call that throws leaves the scene as it was.
template <class M>
class Scene {
 public:
  using model = M;

  Linear<M> gravity = -9.81 * Linear<M>::Unit(1);  // [m/s²]; y is up

  /// A constraint by its kind's store and its index there, with its bodies; by its place in natural order.
  struct Entry {
    int kind = 0, index = 0;
    int id = 0;  // negative for a constraint that was found
    int body1 = 0, body2 = 0;
    // No other constraint that was added to any scene has it; copies of the scene keep it.
    std::uint64_t stamp = 0;
  };

  Scene();
  Scene(const Scene& other);
  Scene& operator=(const Scene& other);
  Scene(Scene&&) noexcept;
  Scene& operator=(Scene&&) noexcept;
  ~Scene();

  const Bodies<M>& bodies() const { return bodies_; }
  /// For methods, which move bodies; anyone else uses the functions below, which check what they are given.
  Bodies<M>& state() { return bodies_; }

  /// Adds a body (`fixed` holds it, or moves it with its velocity) and returns its index. That of a removed body
  /// is used again.
  int add_body(const Pose<M>& pose, const InverseMass<M>& mass, const Velocity<M>& velocity = Velocity<M>::Zero());
  /// Adds an unturned body at a point [m].
  int add_body(const Linear<M>& position, const InverseMass<M>& mass,
               const Velocity<M>& velocity = Velocity<M>::Zero());
  /// Removes a body and all constraints that hold it.
  void remove_body(int body);
  void set_pose(int body, const Pose<M>& pose);
  void set_position(int body, const Linear<M>& position);  // [m]
  void set_velocity(int body, const Velocity<M>& velocity);
  /// Gives a body another mass. `fixed` stops it where it is; a mass frees it again.
  void set_mass(int body, const InverseMass<M>& mass);
  /// Slows a body down as by v' = -linear v and ω' = -angular ω [1/s] >= 0, stable for any time step.
  void set_damping(int body, double linear, double angular = 0);
  /// Multiplies the gravity on a body: 0 lets it float, a factor below 0 rise.
  void set_gravity_scale(int body, double factor);

  /// Pushes a body at its centre of mass with a force [N] throughout the next step, with all others of that step.
  void add_force(int body, const Linear<M>& force) { add_push(body, force, nullptr); }
  /// Pushes it at a point of the world [m].
  void add_force(int body, const Linear<M>& force, const Linear<M>& at) requires(M::angular > 0) {
    add_push(body, force, &at);
  }
  /// Turns a body with a torque [N m] throughout the next step.
  void add_torque(int body, const Angular<M>& torque) requires(M::angular > 0);
  /// Strikes a body at its centre of mass: its velocity changes at once by impulse/m [N s].
  void apply_impulse(int body, const Linear<M>& impulse) { strike(body, impulse, nullptr); }
  /// Strikes it at a point of the world [m].
  void apply_impulse(int body, const Linear<M>& impulse, const Linear<M>& at) requires(M::angular > 0) {
    strike(body, impulse, &at);
  }
  /// Changes the angular velocity of a body at once by I⁻¹ impulse [N m s].
  void apply_angular_impulse(int body, const Angular<M>& impulse) requires(M::angular > 0);

  /// Lets a body touch others. Throws std::invalid_argument for a shape or surface outside its range.
  void set_shape(int body, const Shape<M>& shape, const Surface& surface = {},
                 const Layers& layers = {}) requires(M::angular > 0);
  /// Bodies nearer than margin + lookahead |v| h get a contact, v their relative velocity and h the step. Without
  /// the lookahead what is fast passes thin walls unseen. margin [m] > 0, lookahead >= 0.
  void set_margin(double margin, double lookahead = 1);
  void set_contact_rows(ContactRows rows);
  const Colliders<M>& colliders() const { return colliders_; }

  /// Adds a constraint. Constraints are counted in the order in which they come, whatever their kind, and that is
  /// their natural order. Throws std::invalid_argument for what the kind refuses.
  template <class Kind>
  Handle<Kind> add(Kind constraint) {
    require_valid(constraint, bodies_);
    if constexpr (bound_of<Kind>() == Bound::friction) require_presses(constraint.contact);
    prepare_to_add();
    const int kind = kind_to_add<Kind>();
    constraints<Kind>(kind).all.push_back(constraint);
    append(kind, constraint.at.body1, constraint.at.body2, next_id_);
    return {next_id_++};
  }
  /// Removes a constraint, and with a contact the friction that it presses.
  void remove(int id);
  bool has(int id) const { return find(id) >= 0; }

  template <class Kind>
  const Kind& get(const Handle<Kind>& handle) const {
    const Entry& entry = entries_[place(handle)];
    require_kind(entry, typeid(Kind));
    return static_cast<const Constraints<M, Kind>&>(*stores_[entry.kind]).all[entry.index];
  }
  /// The constraint at a place in natural order, or nullptr if it is of another kind.
  template <class Kind>
  const Kind* get_if(int place) const {
    const Entry& entry = entries_[place];
    if (stores_[entry.kind]->kind() != typeid(Kind)) return nullptr;
    return &static_cast<const Constraints<M, Kind>&>(*stores_[entry.kind]).all[entry.index];
  }
  /// Calls change(constraint) on a copy, and takes that in its place if it is valid. Its bodies have to stay.
  template <class Kind, class F>
  void change(const Handle<Kind>& handle, F&& change) {
    const Entry entry = entries_[added_place(handle)];
    require_kind(entry, typeid(Kind));
    Kind changed = constraints<Kind>(entry.kind).all[entry.index];
    change_one(entry, change, changed);
    replace(handle, changed);
  }
  /// The same for all constraints of a kind that were added: all are changed, or none.
  template <template <class> class Kind, class F>
  void change_all(F&& change) {
    const int kind = kind_of<Kind<M>>();
    if (kind < 0) return;
    std::vector<Kind<M>> changed = constraints<Kind<M>>(kind).all;
    std::vector<Entry> entries(entries_.begin(), entries_.begin() + lasting_);
    std::erase_if(entries, [&](const Entry& entry) { return entry.kind != kind; });
    for (const Entry& entry : entries) change_one(entry, change, changed[entry.index]);
    for (const Entry& entry : entries) replace(entry.id, changed[entry.index]);
  }

  /// All constraints of a kind, in natural order.
  template <class Kind>
  std::span<const Kind> all() const {
    const int kind = kind_of<Kind>();
    if (kind < 0) return {};
    return static_cast<const Constraints<M, Kind>&>(*stores_[kind]).all;
  }
  template <template <class> class Kind>
  std::span<const Kind<M>> all() const {
    return all<Kind<M>>();
  }

  /// How many constraints there are.
  int count() const { return static_cast<int>(entries_.size()); }
  /// How many of them, the first, were added; the others were found and last until contacts are looked for again.
  int lasting() const { return lasting_; }
  const std::vector<Entry>& entries() const { return entries_; }
  /// Where a constraint is in natural order. Throws std::invalid_argument if the scene does not have it.
  int place(int id) const;
  const ConstraintStore<M>& store(int kind) const { return *stores_[kind]; }

  /// Equal only if layout, masses and shapes are: of this scene, of a copy, or of any other.
  std::uint64_t version() const { return version_; }

  /// Whether any row has a bound.
  bool bounded() const;
  /// What the order of solving depends on; a body that does not move takes no part.
  Graph graph() const;
  /// Lays the system's blocks out in this order of places. λ is kept for constraints that were added and stay.
  void lay_out(const std::vector<int>& order, System<M>& system) const;
  /// Writes J, M⁻¹Jᵀ, C, γ, bounds and what a row adds to its bias, at the current poses, for a time step h [s].
  void write_rows(System<M>& system, double h) const {
    for (const Run& run : system.runs) stores_[run.kind]->write_rows(run, bodies_, h, system);
  }
  /// J̇V of all rows along the paths of the bodies.
  void write_bias_accelerations(const System<M>& system, const std::vector<Pose<M, Jet>>& paths,
                                std::vector<double>& result) const {
    for (const Run& run : system.runs) stores_[run.kind]->write_bias_accelerations(run, paths, system, result);
  }

 private:
  friend class ContactManager<M>;
  using Stores = std::vector<std::unique_ptr<ConstraintStore<M>>>;

  template <class Kind>
  int kind_of() const {
    for (std::size_t kind = 0; kind < stores_.size(); ++kind)
      if (stores_[kind]->kind() == typeid(Kind)) return static_cast<int>(kind);
    return -1;
  }
  template <class Kind>
  int kind_to_add() {
    const int kind = kind_of<Kind>();
    if (kind >= 0) return kind;
    stores_.push_back(make_store<M, Kind>());
    return static_cast<int>(stores_.size()) - 1;
  }
  template <class Kind>
  Constraints<M, Kind>& constraints(int kind) {
    return static_cast<Constraints<M, Kind>&>(*stores_[kind]);
  }
  template <class Kind, class F>
  void change_one(const Entry& entry, F& change, Kind& constraint) const {
    change(constraint);
    require_valid(constraint, bodies_);
    require_same("first body", constraint.at.body1, entry.body1);
    require_same("second body", constraint.at.body2, entry.body2);
    if constexpr (bound_of<Kind>() == Bound::friction)
      require_same("contact", constraint.contact, store(entry.kind).contact_of(entry.index));
  }

  /// Looks for its place anew: what changed it may have added and removed others.
  template <class Kind>
  void replace(int id, const Kind& changed) {
    const Entry& entry = entries_[added_place(id)];
    constraints<Kind>(entry.kind).all[entry.index] = changed;
  }

  /// Adds a constraint that lasts until contacts are looked for again; returns its identity, -1 - its place.
  template <class Kind>
  int add_found(const Kind& constraint) {
    const int kind = kind_to_add<Kind>(), id = -1 - count();
    constraints<Kind>(kind).all.push_back(constraint);
    append(kind, constraint.at.body1, constraint.at.body2, id);
    return id;
  }
  void append(int kind, int body1, int body2, int id);
  std::vector<double> kept(const System<M>& system, const std::vector<double>& numbers) const;
  BodyForces& forces_of(int body);
  Velocity<M> with_moment(int body, const char* name, const Linear<M>& push, const Linear<M>* at) const;
  void add_push(int body, const Linear<M>& force, const Linear<M>* at);
  void strike(int body, const Linear<M>& impulse, const Linear<M>* at);
  void forget_found();
  void prepare_to_add();
  void remove_place(int place);
  int find(int id) const;
  int added_place(int id) const;
  void require_kind(const Entry& entry, const std::type_info& kind) const;
  void require_presses(int id) const;
  static void require_same(const char* name, int now, int before);
  void changed();

  Bodies<M> bodies_;
  Colliders<M> colliders_;
  Stores stores_;
  std::vector<Entry> entries_;
  int lasting_ = 0, next_id_ = 0;
  std::uint64_t version_;
  std::uint64_t written_ = 0;  // stamp of the contacts that were found last; copies of the scene keep it
};

}  // namespace byhand
