#include "solver/scene.hpp"

#include "solver/direct/graph.hpp"
#include "solver/support/each_model.hpp"

namespace byhand {

namespace {

/// Makes room for one more, so that adding it cannot fail half-way.
template <class T>
void make_room(std::vector<T>& all) {
  if (all.size() == all.capacity()) all.reserve(2 * all.size() + 8);
}

}  // namespace

template <class M>
Scene<M>::Scene() = default;
template <class M>
Scene<M>::Scene(const Scene&) = default;
template <class M>
Scene<M>::Scene(Scene&&) noexcept = default;
template <class M>
Scene<M>& Scene<M>::operator=(Scene&&) noexcept = default;
template <class M>
Scene<M>& Scene<M>::operator=(const Scene& other) {
  return *this = Scene(other);
}
template <class M>
Scene<M>::~Scene() = default;

template <class M>
int Scene<M>::add_body(Pose<M> pose, InverseMass<M> mass, Velocity<M> velocity) {
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
int Scene<M>::add_body(const Linear<M>& position, InverseMass<M> mass, Velocity<M> velocity) {
  Pose<M> pose;
  pose.position = position;
  return add_body(pose, mass, velocity);
}

template <class M>
void Scene<M>::remove_body(int body) {
  require_body(bodies_, body);
  for (int place = count() - 1; place >= 0; --place)
    if (const Entry& entry = entries()[place]; entry.body1 == body || entry.body2 == body) remove(entry.id);
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
void Scene<M>::set_shape(int body, Shape<M> shape, Surface surface, Layers layers) requires(M::angular > 0) {
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
void Scene<M>::remove(int id) {
  const int at = place(id);
  for (int other = count() - 1; other > at; --other)
    if (const Entry& entry = entries()[other]; store(entry.kind).contact_of(entry.index) == id)
      constraints_.remove(other);
  constraints_.remove(at);
  changed();
}

template <class M>
int Scene<M>::place(int id) const {
  const int at = constraints_.find(id);
  require(at >= 0, "constraint", id, "one that this scene has");
  return at;
}

template <class M>
void Scene<M>::require_presses(int id) const {
  const int at = constraints_.find(id);
  const auto presses = [](const ConstraintStore<M>& store) {  // a motor has no C; ropes and stops are never found
    return store.bound == Bound::interval && store.position_rows > 0 && store.holds_where_found;
  };
  require(at >= 0 && presses(store(entries()[at].kind)), "contact of a friction", id,
          "the handle of a contact that was added before");
}

template <class M>
void Scene<M>::require_same(const char* name, int now, int before) {
  require(now == before, name + std::string(" of a changed constraint"), now,
          std::to_string(before) + ", as it was");
}

template <class M>
bool Scene<M>::bounded(const ConstraintList<M>& contacts) const {
  return contacts.count() > 0 || std::ranges::any_of(entries(), [&](const Entry& entry) {
           return store(entry.kind).bound != Bound::none;
         });
}

template <class M>
Graph Scene<M>::graph(const ConstraintList<M>& contacts) const {
  Graph graph{bodies_.size(), {}, bounded(contacts)};
  graph.edges.reserve(count() + contacts.count());
  const auto end = [&](int body) { return moves(bodies_.inverse_mass[body]) ? body : Edge::no_body; };
  for (const ConstraintList<M>* list : {&constraints_, &contacts})
    for (const Entry& entry : list->entries())
      graph.edges.push_back({end(entry.body1), end(entry.body2), list->store(entry.kind).rows});
  return graph;
}

template <class M>
void Scene<M>::lay_out(const std::vector<int>& order, System<M>& system, const ConstraintList<M>& contacts) const {
  const std::vector<int> rows_before = rows_in(system);
  const std::vector<double> lambda_before = system.lambda, stiffness_before = system.stiffness;
  std::apply([](auto&... blocks) { (blocks.clear(), ...); }, system.blocks);
  system.runs.clear();
  system.row_of.assign(order.size(), 0);
  system.bounded = false;
  system.layout = new_stamp();
  system.inverse_mass.assign(bodies_.inverse_mass.begin(), bodies_.inverse_mass.end());
  system.inverse_inertia.resize(bodies_.size());
  int row = 0;
  for (const int place : order) {
    const bool found = place >= count();
    const ConstraintList<M>& list = found ? contacts : constraints_;
    const Entry& entry = list.entries()[found ? place - count() : place];
    const ConstraintStore<M>& store = list.store(entry.kind);
    for_type<M>(store.block_type, [&](auto type) {
      auto& blocks = std::get<type>(system.blocks);
      if (system.runs.empty() || system.runs.back().kind != entry.kind || system.runs.back().found != found)
        system.runs.push_back(
            {found, entry.kind, store.block_type, static_cast<int>(blocks.size()), 0, row, store.position_rows});
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
  system.stiffness.assign(system.stiffness.empty() ? 0 : row, 0.0);
  for (const Run& run : system.runs) {
    const ConstraintList<M>& list = run.found ? contacts : constraints_;
    const ConstraintStore<M>& store = list.store(run.kind);
    if (store.bound != Bound::friction) continue;
    for_type<M>(run.type, [&](auto type) {
      for (auto& block : part<type>(system.blocks, run))
        block.normal_row =
            system.row_of[(run.found ? count() : 0) + list.find(store.contact_of(block.constraint))];
    });
  }
  system.stamp_of.clear();
  for (int place = 0; place < count(); ++place) {
    const Entry& entry = entries()[place];
    system.stamp_of.push_back(entry.stamp);
    if (rows_before[place] < 0) continue;
    const int from = rows_before[place], to = system.row_of[place], rows = store(entry.kind).rows;
    std::copy_n(&lambda_before[from], rows, &system.lambda[to]);
    if (!stiffness_before.empty()) std::copy_n(&stiffness_before[from], rows, &system.stiffness[to]);
  }
}

/// The first row that each constraint has in the system as it is laid out, -1 where it is new.
template <class M>
std::vector<int> Scene<M>::rows_in(const System<M>& system) const {
  std::vector<int> rows;
  rows.reserve(count());
  std::size_t old = 0;
  for (const Entry& entry : entries()) {
    while (old < system.stamp_of.size() && system.stamp_of[old] < entry.stamp) ++old;
    const bool stays = old < system.stamp_of.size() && system.stamp_of[old] == entry.stamp;
    rows.push_back(stays ? system.row_of[old] : -1);
  }
  return rows;
}

#define BYHAND_INSTANTIATE(M) template class Scene<M>
BYHAND_FOR_EACH_MODEL(BYHAND_INSTANTIATE);
#undef BYHAND_INSTANTIATE

}  // namespace byhand
