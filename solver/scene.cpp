#include "solver/scene.hpp"

#include "solver/direct/graph.hpp"
#include "solver/support/each_model.hpp"

namespace byhand {

namespace {

constexpr std::uint64_t found_stamp = ~std::uint64_t{};  // of all that were found, which come last

/// Makes room for one more, so that adding it cannot fail half-way.
template <class T>
void make_room(std::vector<T>& all) {
  if (all.size() == all.capacity()) all.reserve(2 * all.size() + 8);
}

}  // namespace

template <class M>
Scene<M>::Scene() : version_(new_stamp()) {}

template <class M>
Scene<M>::Scene(const Scene& other)
    : gravity(other.gravity),
      bodies_(other.bodies_),
      colliders_(other.colliders_),
      entries_(other.entries_),
      lasting_(other.lasting_),
      next_id_(other.next_id_),
      version_(other.version_),
      written_(other.written_) {
  for (const auto& store : other.stores_) stores_.push_back(store->clone());
}

template <class M>
Scene<M>& Scene<M>::operator=(const Scene& other) {
  return *this = Scene(other);
}

template <class M>
Scene<M>::Scene(Scene&& other) noexcept : Scene() {
  *this = std::move(other);
}

/// Swaps, so that the other is still a scene, and not one of no bodies with the version of this one.
template <class M>
Scene<M>& Scene<M>::operator=(Scene&& other) noexcept {
  std::swap(gravity, other.gravity);
  std::swap(bodies_, other.bodies_);
  std::swap(colliders_, other.colliders_);
  std::swap(stores_, other.stores_);
  std::swap(entries_, other.entries_);
  std::swap(lasting_, other.lasting_);
  std::swap(next_id_, other.next_id_);
  std::swap(version_, other.version_);
  std::swap(written_, other.written_);
  return *this;
}

template <class M>
Scene<M>::~Scene() = default;

template <class M>
void Scene<M>::changed() {
  version_ = new_stamp();
}

template <class M>
int Scene<M>::add_body(const Pose<M>& pose, const InverseMass<M>& mass, const Velocity<M>& velocity) {
  require_valid<M>(pose);
  require_valid<M>(mass);
  require_valid<M>(velocity);
  auto& [poses, velocities, masses, removed, forces, applied] = bodies_;
  int body = bodies_.size();
  if (!removed.empty()) {
    body = removed.back();
    removed.pop_back();
    poses[body] = pose;
    velocities[body] = velocity;
    masses.all_[body] = mass;
  } else {
    make_room(poses);
    make_room(velocities);
    make_room(masses.all_);
    if (!forces.empty()) forces.resize(body + 1);
    if (!applied.empty()) applied.resize(body + 1, Velocity<M>::Zero());
    poses.push_back(pose);
    velocities.push_back(velocity);
    masses.all_.push_back(mass);
  }
  changed();
  return body;
}

template <class M>
int Scene<M>::add_body(const Linear<M>& position, const InverseMass<M>& mass, const Velocity<M>& velocity) {
  Pose<M> pose;
  pose.position = position;
  return add_body(pose, mass, velocity);
}

template <class M>
void Scene<M>::remove_body(int body) {
  require_body(bodies_, body);
  forget_found();
  for (int place = count() - 1; place >= 0; --place)
    if (entries_[place].body1 == body || entries_[place].body2 == body) remove(entries_[place].id);
  set_mass(body, fixed<M>());
  if (body < static_cast<int>(colliders_.shapes.size())) colliders_.shapes[body] = {};
  if (!bodies_.forces.empty()) bodies_.forces[body] = {};
  if (body < std::ssize(bodies_.applied)) bodies_.applied[body].setZero();
  bodies_.removed.push_back(body);
}

template <class M>
void Scene<M>::set_pose(int body, const Pose<M>& pose) {
  require_body(bodies_, body);
  require_valid<M>(pose);
  bodies_.pose[body] = pose;
}

template <class M>
void Scene<M>::set_position(int body, const Linear<M>& position) {
  require_body(bodies_, body);
  Pose<M> pose = bodies_.pose[body];
  pose.position = position;
  set_pose(body, pose);
}

template <class M>
void Scene<M>::set_velocity(int body, const Velocity<M>& velocity) {
  require_body(bodies_, body);
  require_valid<M>(velocity);
  bodies_.velocity[body] = velocity;
}

template <class M>
void Scene<M>::set_mass(int body, const InverseMass<M>& mass) {
  require_body(bodies_, body);
  require_valid<M>(mass);
  bodies_.inverse_mass.all_[body] = mass;
  if (!moves(mass)) bodies_.velocity[body].setZero();
  changed();
}

template <class M>
BodyForces& Scene<M>::forces_of(int body) {
  bodies_.forces.resize(bodies_.size());
  return bodies_.forces[body];
}

template <class M>
void Scene<M>::set_damping(int body, double linear, double angular) {
  require_body(bodies_, body);
  require_in("linear damping", linear, 0, 1e300, "1/s");
  require_in("angular damping", angular, 0, 1e300, "1/s");
  BodyForces& own = forces_of(body);
  own.linear_damping = linear;
  own.angular_damping = angular;
}

template <class M>
void Scene<M>::set_gravity_scale(int body, double factor) {
  require_body(bodies_, body);
  require_finite("gravity scale", factor);
  forces_of(body).gravity_scale = factor;
}

/// A force or impulse and its moment about the centre of mass, for a point of the world or for the centre.
template <class M>
Velocity<M> Scene<M>::with_moment(int body, const char* name, const Linear<M>& push, const Linear<M>* at) const {
  require_body(bodies_, body);
  for (const double component : push) require_finite(name, component);
  Velocity<M> result = Velocity<M>::Zero();
  result.template head<M::linear>() = push;
  if constexpr (M::angular > 0)
    if (at) {
      for (const double x : *at) require_finite("point of a push", x, "m");
      result.template tail<M::angular>() = cross(Linear<M>(*at - bodies_.pose[body].position), push);
    }
  return result;
}

template <class M>
void Scene<M>::add_push(int body, const Linear<M>& force, const Linear<M>* at) {
  const Velocity<M> push = with_moment(body, "force", force, at);
  bodies_.applied.resize(bodies_.size(), Velocity<M>::Zero());
  bodies_.applied[body] += push;
}

template <class M>
void Scene<M>::add_torque(int body, const Angular<M>& torque) requires(M::angular > 0) {
  require_body(bodies_, body);
  for (const double component : torque) require_finite("torque", component, "N m");
  bodies_.applied.resize(bodies_.size(), Velocity<M>::Zero());
  bodies_.applied[body].template tail<M::angular>() += torque;
}

template <class M>
void Scene<M>::strike(int body, const Linear<M>& impulse, const Linear<M>* at) {
  const Velocity<M> push = with_moment(body, "impulse", impulse, at);
  bodies_.velocity[body] += times_inverse_mass<M>(push, bodies_.inverse_mass[body], bodies_.pose[body]);
}

template <class M>
void Scene<M>::apply_angular_impulse(int body, const Angular<M>& impulse) requires(M::angular > 0) {
  require_body(bodies_, body);
  for (const double component : impulse) require_finite("angular impulse", component, "N m s");
  Velocity<M> push = Velocity<M>::Zero();
  push.template tail<M::angular>() = impulse;
  bodies_.velocity[body] += times_inverse_mass<M>(push, bodies_.inverse_mass[body], bodies_.pose[body]);
}

template <class M>
void Scene<M>::set_shape(int body, const Shape<M>& shape, const Surface& surface,
                         const Layers& layers) requires(M::angular > 0) {
  require_body(bodies_, body);
  require_valid<M>(shape);
  require_in("friction coefficient", surface.friction, 0, 1e300);
  require_in("restitution", surface.restitution, 0, 1);
  colliders_.shapes.resize(bodies_.size());
  colliders_.surfaces.resize(bodies_.size());
  colliders_.layers.resize(bodies_.size());
  colliders_.stamps.resize(bodies_.size());
  if (std::holds_alternative<std::monostate>(colliders_.shapes[body])) colliders_.stamps[body] = new_stamp();
  colliders_.shapes[body] = shape;
  colliders_.surfaces[body] = surface;
  colliders_.layers[body] = layers;
  changed();
}

template <class M>
void Scene<M>::set_margin(double margin, double lookahead) {
  require_positive("contact margin", margin, "m");
  require_in("lookahead", lookahead, 0, 1e300);
  colliders_.margin = margin;
  colliders_.lookahead = lookahead;
  changed();
}

template <class M>
void Scene<M>::set_contact_rows(ContactRows rows) {
  require(rows == ContactRows::points || M::linear == 2, "number of axes of a contact manifold", M::linear,
          "2: contacts in space are points");
  colliders_.rows = rows;
  changed();
}

template <class M>
void Scene<M>::prepare_to_add() {
  forget_found();
  make_room(entries_);
}

template <class M>
void Scene<M>::append(int kind, int body1, int body2, int id) {
  entries_.push_back({kind, stores_[kind]->size() - 1, id, body1, body2, id < 0 ? found_stamp : new_stamp()});
  if (id < 0) return;
  lasting_ = count();
  changed();
}

template <class M>
void Scene<M>::forget_found() {
  if (count() == lasting_) return;
  std::vector<int> sizes(stores_.size(), 0);
  for (int place = 0; place < lasting_; ++place) ++sizes[entries_[place].kind];
  for (std::size_t kind = 0; kind < stores_.size(); ++kind) stores_[kind]->truncate(sizes[kind]);
  entries_.resize(lasting_);
  changed();
}

template <class M>
void Scene<M>::remove_place(int place) {
  const Entry entry = entries_[place];
  stores_[entry.kind]->erase(entry.index);
  entries_.erase(entries_.begin() + place);
  lasting_ = count();
  for (Entry& other : entries_)
    if (other.kind == entry.kind && other.index > entry.index) --other.index;
  changed();
}

template <class M>
void Scene<M>::remove(int id) {
  const int at = added_place(id);
  forget_found();
  for (int other = count() - 1; other > at; --other)
    if (store(entries_[other].kind).contact_of(entries_[other].index) == id) remove_place(other);
  remove_place(at);
}

template <class M>
int Scene<M>::find(int id) const {
  if (id < 0) return id >= -count() && -1 - id >= lasting_ ? -1 - id : -1;
  const auto end = entries_.begin() + lasting_;
  const auto entry =
      std::lower_bound(entries_.begin(), end, id, [](const Entry& e, int wanted) { return e.id < wanted; });
  return entry != end && entry->id == id ? static_cast<int>(entry - entries_.begin()) : -1;
}

template <class M>
int Scene<M>::place(int id) const {
  const int at = find(id);
  require(at >= 0, "constraint", id, "one that this scene has");
  return at;
}

template <class M>
int Scene<M>::added_place(int id) const {
  const int at = id < 0 ? -1 : find(id);
  require(at >= 0, "constraint", id, "one that was added to this scene and not removed");
  return at;
}

template <class M>
void Scene<M>::require_kind(const Entry& entry, const std::type_info& kind) const {
  require(store(entry.kind).kind() == kind, "constraint", entry.id, "of the kind of its handle");
}

template <class M>
void Scene<M>::require_presses(int id) const {
  const int at = id < 0 ? -1 : find(id);
  const auto presses = [](const ConstraintStore<M>& store) {  // a motor, which has no C, pulls as well
    return store.bound == Bound::interval && store.position_rows > 0;
  };
  require(at >= 0 && presses(store(entries_[at].kind)), "contact of a friction", id,
          "the handle of a contact that was added before");
}

template <class M>
void Scene<M>::require_same(const char* name, int now, int before) {
  require(now == before, name + std::string(" of a changed constraint"), now,
          std::to_string(before) + ", as it was");
}

template <class M>
bool Scene<M>::bounded() const {
  return std::ranges::any_of(entries_, [&](const Entry& entry) { return store(entry.kind).bound != Bound::none; });
}

template <class M>
Graph Scene<M>::graph() const {
  Graph graph{bodies_.size(), {}, bounded()};
  graph.edges.reserve(entries_.size());
  const auto end = [&](int body) { return moves(bodies_.inverse_mass[body]) ? body : Edge::no_body; };
  for (const Entry& entry : entries_)
    graph.edges.push_back({end(entry.body1), end(entry.body2), store(entry.kind).rows});
  return graph;
}

template <class M>
void Scene<M>::lay_out(const std::vector<int>& order, System<M>& system) const {
  const std::vector<double> old_lambda = kept(system, system.lambda),
                            old_stiffness = kept(system, system.stiffness);
  std::apply([](auto&... blocks) { (blocks.clear(), ...); }, system.blocks);
  system.runs.clear();
  system.row_of.assign(count(), 0);
  system.bounded = false;
  system.layout = new_stamp();
  system.inverse_mass.assign(bodies_.inverse_mass.begin(), bodies_.inverse_mass.end());
  int row = 0;
  for (const int place : order) {
    const Entry& entry = entries_[place];
    const ConstraintStore<M>& store = this->store(entry.kind);
    for_type<M>(store.block_type, [&](auto type) {
      auto& blocks = std::get<type>(system.blocks);
      if (system.runs.empty() || system.runs.back().kind != entry.kind)
        system.runs.push_back(
            {entry.kind, store.block_type, static_cast<int>(blocks.size()), 0, row, store.position_rows});
      ++system.runs.back().count;
      BlockHeader& block = blocks.emplace_back();
      block.body1 = entry.body1;
      block.body2 = entry.body2;
      block.moves1 = moves(bodies_.inverse_mass[entry.body1]);
      block.moves2 = moves(bodies_.inverse_mass[entry.body2]);
      block.row = row;
      block.constraint = entry.index;
    });
    system.row_of[place] = row;
    system.bounded = system.bounded || store.bound != Bound::none;
    row += store.rows;
  }
  for (auto* numbers : {&system.lambda, &system.C, &system.bias, &system.gamma, &system.target_rate, &system.lower,
                        &system.upper, &system.restitution})
    numbers->assign(row, 0.0);
  for (const Run& run : system.runs)
    if (stores_[run.kind]->bound == Bound::friction)
      for_type<M>(run.type, [&](auto type) {
        for (auto& block : std::span(&std::get<type>(system.blocks)[run.first], run.count))
          block.normal_row = system.row_of[place(stores_[run.kind]->contact_of(block.constraint))];
      });
  system.stiffness.assign(system.stiffness.empty() ? 0 : row, 0.0);
  system.stamp_of.clear();
  for (const Entry& entry : entries_) system.stamp_of.push_back(entry.stamp);
  int from = 0;
  for (int place = 0; place < lasting_; ++place) {
    const int to = system.row_of[place], rows = store(entries_[place].kind).rows;
    if (!old_lambda.empty()) std::copy_n(&old_lambda[from], rows, &system.lambda[to]);
    if (!old_stiffness.empty()) std::copy_n(&old_stiffness[from], rows, &system.stiffness[to]);
    from += rows;
  }
}

/// Of one number a row: those of the constraints that were added, in natural order, where the system has them
/// already, and 0 where it does not. Empty if there are no numbers yet.
template <class M>
std::vector<double> Scene<M>::kept(const System<M>& system, const std::vector<double>& numbers) const {
  std::vector<double> result;
  if (numbers.empty()) return result;
  int rows = 0;
  for (int place = 0; place < lasting_; ++place) rows += store(entries_[place].kind).rows;
  result.assign(rows, 0.0);
  std::size_t old = 0;
  int to = 0;
  for (int place = 0; place < lasting_; ++place) {
    const Entry& entry = entries_[place];
    while (old < system.stamp_of.size() && system.stamp_of[old] < entry.stamp) ++old;
    if (old == system.stamp_of.size()) break;
    const int count = store(entry.kind).rows;
    if (system.stamp_of[old] == entry.stamp) std::copy_n(&numbers[system.row_of[old]], count, &result[to]);
    to += count;
  }
  return result;
}

#define BYHAND_INSTANTIATE(M) template class Scene<M>
BYHAND_FOR_EACH_MODEL(BYHAND_INSTANTIATE);
#undef BYHAND_INSTANTIATE

}  // namespace byhand
