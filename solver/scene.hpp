#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "solver/constraint_list.hpp"
#include "solver/contact/shape.hpp"

namespace byhand {

struct Graph;

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
  // Bodies that come nearer than the margin within lookahead · h, moved on as fast as now, get a contact.
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
///
/// Contacts that are found from shapes are no constraints of the scene: a ContactManager keeps them from step to
/// step. What lays out or writes rows is given them, and their rows follow those of the scene.
template <class M>
class Scene {
 public:
  using model = M;

  Linear<M> gravity = -9.81 * Linear<M>::Unit(1);  // [m/s²]; y is up

  using Entry = typename ConstraintList<M>::Entry;

  Scene();
  Scene(const Scene& other);
  Scene(Scene&& other) noexcept;
  Scene& operator=(const Scene& other);
  Scene& operator=(Scene&& other) noexcept;
  ~Scene();

  const Bodies<M>& bodies() const { return bodies_; }
  /// For methods, which move bodies; anyone else uses the functions below, which check what they are given.
  Bodies<M>& state() { return bodies_; }

  /// Adds a body (`fixed` holds it, or moves it with its velocity) and returns its index. That of a removed body
  /// is used again.
  int add_body(Pose<M> pose, InverseMass<M> mass, Velocity<M> velocity = Velocity<M>::Zero());
  /// Adds an unturned body at a point [m].
  int add_body(const Linear<M>& position, InverseMass<M> mass, Velocity<M> velocity = Velocity<M>::Zero());
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
  void set_shape(int body, Shape<M> shape, Surface surface = {}, Layers layers = {}) requires(M::angular > 0);
  /// Bodies get a contact where they are nearer than the margin, or will be within the next lookahead · h, moved
  /// on as fast as now: h is the step. Without the lookahead what is fast passes thin walls unseen. margin [m] >
  /// 0, lookahead >= 0.
  void set_margin(double margin, double lookahead = 1);
  void set_contact_rows(ContactRows rows);
  const Colliders<M>& colliders() const { return colliders_; }

  /// Adds a constraint. Constraints are counted in the order in which they come, whatever their kind, and that is
  /// their natural order. Throws std::invalid_argument for what the kind refuses.
  template <class Kind>
  Handle<Kind> add(Kind constraint) {
    require_valid(constraint, bodies_);
    if constexpr (bound_of<Kind>() == Bound::friction) require_presses(constraint.contact);
    constraints_.add(constraint, next_id_, new_stamp());
    changed();
    return {next_id_++};
  }
  /// Removes a constraint, and with a contact the friction that it presses.
  void remove(int id);
  bool has(int id) const { return constraints_.find(id) >= 0; }

  template <class Kind>
  const Kind& get(const Handle<Kind>& handle) const {
    return constraints_.template of<Kind>(entry_of(handle));
  }
  /// The constraint at a place in natural order, or nullptr if it is of another kind or there is none.
  template <class Kind>
  const Kind* get_if(int place) const {
    if (place < 0 || place >= count()) return nullptr;
    const Entry& entry = entries()[place];
    return store(entry.kind).kind() == typeid(Kind) ? &constraints_.template of<Kind>(entry) : nullptr;
  }
  /// Calls change(constraint) on a copy, and takes that in its place if it is valid. Its bodies have to stay.
  template <class Kind, class F>
  void change(const Handle<Kind>& handle, F&& change) {
    const Entry entry = entry_of(handle);
    const Kind changed = changed_one(entry, change, constraints_.template of<Kind>(entry));
    constraints_.replace(entry_of(handle), changed);  // `change` may have added and removed others
  }
  /// The same for all constraints of a kind: all are changed, or none.
  template <template <class> class Kind, class F>
  void change_all(F&& change) {
    std::vector<Kind<M>> changed;
    std::vector<Handle<Kind<M>>> handles;
    for (const Entry& entry : entries())
      if (store(entry.kind).kind() == typeid(Kind<M>)) handles.push_back({entry.id});
    for (const auto& handle : handles) {
      const Entry entry = entry_of(handle);
      changed.push_back(changed_one(entry, change, constraints_.template of<Kind<M>>(entry)));
    }
    for (const auto& handle : handles) place(handle);  // throws if `change` has removed it
    for (std::size_t i = 0; i < handles.size(); ++i) constraints_.replace(entry_of(handles[i]), changed[i]);
  }

  /// All constraints of a kind, in natural order.
  template <class Kind>
  std::span<const Kind> all() const {
    return constraints_.template all<Kind>();
  }
  template <template <class> class Kind>
  std::span<const Kind<M>> all() const {
    return all<Kind<M>>();
  }

  const ConstraintList<M>& constraints() const { return constraints_; }
  int count() const { return constraints_.count(); }
  const std::vector<Entry>& entries() const { return constraints_.entries(); }
  const ConstraintStore<M>& store(int kind) const { return constraints_.store(kind); }
  /// Where a constraint is in natural order. Throws std::invalid_argument if the scene does not have it.
  int place(int id) const;

  /// Equal only if layout, masses and shapes are: of this scene, of a copy, or of any other. See
  /// support/stamp.hpp.
  std::uint64_t version() const { return version_.stamp(); }

  // What follows takes the rows of `contacts` after those of the scene's own constraints.

  /// Whether any row has a bound.
  bool bounded(const ConstraintList<M>& contacts = {}) const;
  /// What the order of solving depends on; a body that does not move takes no part.
  Graph graph(const ConstraintList<M>& contacts = {}) const;
  /// Lays the system's blocks out in this order of places. λ is kept for the scene's own constraints that stay.
  void lay_out(const std::vector<int>& order, System<M>& system, const ConstraintList<M>& contacts = {}) const;
  /// The store of a run of the system.
  const ConstraintStore<M>& store(const Run& run, const ConstraintList<M>& contacts) const {
    return (run.found ? contacts : constraints_).store(run.kind);
  }
  /// Writes J, M⁻¹Jᵀ, C, γ, bounds and what a row adds to its bias, at the current poses, for a time step h [s].
  void write_rows(System<M>& system, double h, const ConstraintList<M>& contacts = {}) const {
    if constexpr (M::angular > 0)
      for (int i = 0; i < bodies_.size(); ++i)
        system.inverse_inertia[i] = inverse_inertia(bodies_.inverse_mass[i], bodies_.pose[i]);
    for (const Run& run : system.runs) store(run, contacts).write_rows(run, bodies_, h, system);
  }
  /// J̇V of all rows along the paths of the bodies.
  void write_bias_accelerations(const System<M>& system, const std::vector<Pose<M, Jet>>& paths,
                                std::vector<double>& result, const ConstraintList<M>& contacts = {}) const {
    for (const Run& run : system.runs) store(run, contacts).write_bias_accelerations(run, paths, system, result);
  }

 private:
  template <class Kind>
  const Entry& entry_of(const Handle<Kind>& handle) const {
    const Entry& entry = entries()[place(handle)];
    require(store(entry.kind).kind() == typeid(Kind), "constraint", handle.id, "of the kind of its handle");
    return entry;
  }
  template <class Kind, class F>
  Kind changed_one(const Entry& entry, F& change, Kind constraint) const {
    change(constraint);
    require_valid(constraint, bodies_);
    require_same("first body", constraint.at.body1, entry.body1);
    require_same("second body", constraint.at.body2, entry.body2);
    if constexpr (bound_of<Kind>() == Bound::friction)
      require_same("contact", constraint.contact, store(entry.kind).contact_of(entry.index));
    return constraint;
  }

  std::vector<int> rows_in(const System<M>& system) const;
  BodyForces& forces_of(int body);
  Velocity<M> with_moment(int body, const char* name, const Linear<M>& push, const Linear<M>* at) const;
  void add_push(int body, const Linear<M>& force, const Linear<M>* at);
  void strike(int body, const Linear<M>& impulse, const Linear<M>* at);
  void require_presses(int id) const;
  static void require_same(const char* name, int now, int before);
  void changed() { version_ = {}; }

  Bodies<M> bodies_;
  Colliders<M> colliders_;
  ConstraintList<M> constraints_;
  int next_id_ = 0;
  Version version_;
};

}  // namespace byhand
