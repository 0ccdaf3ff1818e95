#include "tests/fuzz/laws.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>
#include <random>

#include "solver/measure.hpp"
#include "solver/rows/residual.hpp"

namespace byhand::fuzz {
namespace {

std::string text(const char* what, double number, double most) {
  char line[160];
  std::snprintf(line, sizeof line, "%s: %.3g, at most %.3g is allowed", what, number, most);
  return line;
}

template <class M>
double smallest_size(const Shape<M>& shape) {
  if (const auto* ball = std::get_if<Ball<M>>(&shape)) return 2 * ball->radius;
  if (const auto* box = std::get_if<Box<M>>(&shape)) return box->sides.minCoeff();
  return std::numeric_limits<double>::infinity();
}

/// The state of a simulation as a recipe.
template <class M>
Recipe<M> recipe_of(Recipe<M> recipe, const Scene<M>& scene) {
  for (auto& link : recipe.links) {
    const Pose<M>&before = recipe.parts[link.first].pose, &now = scene.bodies().pose[link.first];
    link.at =
        now.position +
        rotate(now.rotation, Linear<M>(rotate(inverse(before.rotation), Linear<M>(link.at - before.position))));
  }
  for (int i = 0; i < scene.bodies().size(); ++i) {
    recipe.parts[i].pose = scene.bodies().pose[i];
    recipe.parts[i].velocity = scene.bodies().velocity[i];
  }
  return recipe;
}

// Of two seconds.

/// Calls look(simulation, velocities before the step) after each step, until it returns a text.
template <class M, class F>
std::string watch(const Recipe<M>& recipe, const VelocityStepping& method, F&& look) {
  Simulation<M> simulation{scene_of(recipe), method};
  for (int step = 0; step < 120; ++step) {
    const auto before = simulation.scene.bodies().velocity;
    simulation.step(h);
    if (std::string broken = look(simulation, before); !broken.empty())
      return broken + ", in step " + std::to_string(step);
  }
  return {};
}

template <class M>
std::string gives_up(const Recipe<M>& recipe, const VelocityStepping& method) {
  Simulation<M> simulation{scene_of(recipe), method};
  try {
    for (int step = 0; step < 120; ++step) simulation.step(h);
  } catch (const std::exception& error) {
    return error.what();
  }
  return {};
}

/// Whether the last step was taken in parts: of these only the λ of the last one is left.
template <class M>
bool in_parts(const Simulation<M>& simulation) {
  return simulation.work.h < h;
}

/// V = V₀ + h g + M⁻¹Jᵀλ, (20) of all rows.
template <class M>
std::string impulses_miss(const Recipe<M>& recipe, const VelocityStepping& choice) {
  VelocityStepping method = choice;
  method.gyroscopic = Gyroscopic::none;
  double begun_with = 0;  // what the warm start came from, and leaves rounding of
  return watch<M>(recipe, method, [&](const Simulation<M>& simulation, std::vector<Velocity<M>> V) -> std::string {
    if (in_parts(simulation)) return {};
    const System<M>& system = simulation.work.system;
    double size = 0;
    for (std::size_t i = 0; i < V.size(); ++i) {
      if (recipe.parts[i].mass > 0) V[i].template head<M::linear>() += h * recipe.gravity;
      size = std::max(size, V[i].norm());
    }
    for_each_block(system, [&]<int K, Bound B>(const Block<M, K, B>& block, const Run&) {
      for (int k = 0; k < K; ++k) {
        const auto way = (block.W.matrix.row(k) * system.lambda[block.row + k]).eval();
        if (block.moves1) V[block.body1] += way.template head<M::dof>().transpose();
        if (block.moves2) V[block.body2] += way.template tail<M::dof>().transpose();
        size = std::max(size, way.norm());
      }
    });
    double most = 0;
    for (std::size_t i = 0; i < V.size(); ++i)
      most = std::max(most, (V[i] - simulation.scene.bodies().velocity[i]).norm());
    const double rounding = 1e-9 * size + 1e-14 * begun_with;
    begun_with = size;
    return most <= rounding ? "" : text("velocity without a cause [m/s]", most, rounding);
  });
}

/// A step that says so leaves a residual within a share of the largest impulse. Sweeps look at each row at its
/// turn, with a tolerance of 1e-5; the rows after it change it once more.
template <class M>
std::string not_converged(const Recipe<M>& recipe, const VelocityStepping& choice) {
  VelocityStepping method = choice;
  method.gyroscopic = Gyroscopic::none;
  return watch<M>(recipe, method, [](const Simulation<M>& simulation, const auto&) -> std::string {
    if (!simulation.work.solution.converged) return "";
    const System<M>& system = simulation.work.system;
    const auto& V = simulation.scene.bodies().velocity;
    RowScales scales;
    find_scales(system, scales);
    double most = 1e-12 * fastest(system, V);
    for (int row = 0; row < system.rows(); ++row)
      most = std::max(most, 1e-4 * scales.speed[row] * std::abs(system.lambda[row]));
    const double left = residual(system, V);
    return left <= most ? "" : text("residual of a converged step [m/s]", left, most);
  });
}

/// The deepest overlap of two bodies that are not joined, as a share of the smaller one, and which.
struct Overlap {
  double share = 0;
  BodyPair bodies;
};
template <class M>
Overlap deepest(const Recipe<M>& recipe, const Bodies<M>& bodies) {
  Overlap result;
  const int count = static_cast<int>(recipe.parts.size());
  for (int j = 0; j < count; ++j)
    for (int i = 0; i < j; ++i) {
      const auto &a = recipe.parts[i], &b = recipe.parts[j];
      const bool joined = std::ranges::any_of(recipe.links, [&](const auto& link) {
        return std::minmax(link.first, link.second) == std::minmax(i, j);
      });
      if (joined || (a.mass == 0 && b.mass == 0)) continue;
      const double size = std::min(smallest_size<M>(a.shape), smallest_size<M>(b.shape));
      for (const auto& point : collide<M>(a.shape, bodies.pose[i], b.shape, bodies.pose[j], 0))
        if (-point.separation > result.share * size) result = {-point.separation / size, {i, j}};
    }
  return result;
}

/// Two bodies touch; neither goes through the other. A corner that turns fast may strike deep, but the correction
/// takes a fifth of that away with every step.
template <class M>
std::string sunken(const Recipe<M>& recipe, const VelocityStepping& method) {
  if (deepest(recipe, scene_of(recipe).bodies()).share > 0.02) return {};
  int steps = 0;
  return watch<M>(recipe, method, [&](const Simulation<M>& simulation, const auto&) -> std::string {
    const auto [share, bodies] = deepest(recipe, simulation.scene.bodies());
    steps = share > 0.1 ? steps + 1 : 0;
    if (steps < 30 || !simulation.work.solution.converged) return "";
    return "for half a second bodies " + std::to_string(bodies.first) + " and " + std::to_string(bodies.second) +
           text(" overlapped, at last by a share of the smaller of", share, 0.1);
  });
}

/// What the rows' correction gives is the most that a step may make, but for one that says it has not converged,
/// and one in parts, whose λ are not known.
template <class M>
std::string energy_made(const Recipe<M>& recipe, const VelocityStepping& method) {
  const Scene<M> start = scene_of(recipe);
  double before = energy(start), allowed = before, size = std::abs(before) + kinetic_energy(start.bodies());
  for (const auto& part : recipe.parts) size = std::max(size, part.mass * recipe.gravity.norm());
  return watch<M>(recipe, method, [&](const Simulation<M>& simulation, const auto&) -> std::string {
    const System<M>& system = simulation.work.system;
    for (int row = 0; row < system.rows(); ++row) allowed += std::abs(system.lambda[row] * system.bias[row]);
    const double now = energy(simulation.scene);
    if (!simulation.work.solution.converged || in_parts(simulation)) allowed += std::max(0.0, now - before);
    before = now;
    const double most = allowed + 1e-4 * size;
    return now <= most ? "" : text("energy [J]", now, most);
  });
}

// Of one step.

constexpr double to_the_end = 1e-12;  // the residual of what is compared, as a share of the largest λ

/// The recipe after one step, and the residual that is allowed where it is solved to the end [m/s].
template <class M>
struct Stepped {
  Recipe<M> then;
  double residual = 0;
};
template <class M>
Stepped<M> stepped(const Recipe<M>& recipe, const Simulation<M>& simulation) {
  RowScales scales;
  find_scales(simulation.work.system, scales);
  double fastest = 0;
  for (int row = 0; row < simulation.work.system.rows(); ++row)
    fastest = std::max(fastest, scales.speed[row] * std::abs(simulation.work.system.lambda[row]));
  return {recipe_of(recipe, simulation.scene), to_the_end * fastest};
}
/// Nothing where the step does not converge.
template <class M>
std::optional<Stepped<M>> stepped(const Recipe<M>& recipe, const VelocityStepping& method) {
  Simulation<M> simulation{scene_of(recipe), method};
  simulation.step(h);
  if (!simulation.work.solution.converged) return std::nullopt;
  return stepped(recipe, simulation);
}

/// The largest difference of velocities, as a share of the fastest. What is solved to a residual misses the answer
/// by a few times that, which is much where one body is a million times as heavy as another.
template <class M>
std::string differ(const Stepped<M>& a, const Stepped<M>& b, double speed) {
  double largest = 0;
  for (std::size_t i = 0; i < a.then.parts.size(); ++i) {
    const Velocity<M>& V = a.then.parts[i].velocity;
    speed = std::max(speed, V.norm());
    largest = std::max(largest, (V - b.then.parts[i].velocity).norm());
  }
  const double most = 1e-6 * speed + 10 * std::max(a.residual, b.residual);
  return largest <= most ? "" : text("velocities differ by [m/s]", largest, most);
}

/// Whether velocities have one solution. Where several points share a face their normals are not determined one by
/// one, and with friction neither is what it brakes.
template <class M>
bool determined(const Recipe<M>& recipe) {
  return std::ranges::all_of(recipe.parts, [](const auto& part) { return part.friction == 0; });
}

/// A step of what is looked at in another way is the step, looked at in that way.
template <class M, class View>
std::string seen(const Recipe<M>& recipe, const VelocityStepping& method, View&& view) {
  auto then = stepped(recipe, method);
  if (!then) return {};
  const Recipe<M> other = view(recipe);
  const auto other_then = stepped(other, method);
  if (!other_then) return {};
  // Rows are solved where bodies were: velocities are looked at there.
  for (std::size_t i = 0; i < recipe.parts.size(); ++i) then->then.parts[i].pose = recipe.parts[i].pose;
  then->then = view(then->then);
  return differ(*other_then, *then, h * other.gravity.norm());
}

template <class M>
std::string moved(const Recipe<M>& recipe, const VelocityStepping& method) {
  if (M::linear == 3 && !determined(recipe)) return {};  // rounding decides
  return seen(recipe, method, [](Recipe<M> view) {
    Linear<M> way;
    for (int k = 0; k < M::linear; ++k) way[k] = 100 - 37 * k;
    for (auto& part : view.parts) part.pose.position += way;
    for (auto& link : view.links) link.at += way;
    return view;
  });
}

template <class M>
std::string turned(const Recipe<M>& recipe, const VelocityStepping& method) {
  if (M::linear == 3 && !determined(recipe)) return {};  // the tangents of friction do not turn
  Rotation<M> turn;
  if constexpr (M::linear == 2)
    turn = plane_rotation(2.0);
  else
    turn = space_rotation<double>(Eigen::Vector3d(1, -0.7, 0.4));
  return seen(recipe, method, [&](Recipe<M> view) {
    const auto point = [&](const Linear<M>& p) { return rotate(turn, p); };
    view.gravity = point(view.gravity);
    for (auto& part : view.parts) {
      part.pose = {point(part.pose.position), turn * part.pose.rotation};
      part.velocity.template head<M::linear>() = point(part.velocity.template head<M::linear>());
      if constexpr (M::linear == 3) part.velocity.template tail<3>() = point(part.velocity.template tail<3>());
    }
    for (auto& link : view.links) link.at = point(link.at);
    return view;
  });
}

/// x becomes -x: so does what turns about any other axis.
template <class M>
std::string mirrored(const Recipe<M>& recipe, const VelocityStepping& method) {
  if (M::linear == 3 && !determined(recipe)) return {};  // corners come in another order
  return seen(recipe, method, [](Recipe<M> view) {
    view.gravity.x() *= -1;
    for (auto& part : view.parts) {
      part.pose.position.x() *= -1;
      part.velocity.x() *= -1;
      if constexpr (M::linear == 2) {
        part.pose.rotation.sin *= -1;
        part.velocity[2] *= -1;
      } else {
        part.pose.rotation.y() *= -1;
        part.pose.rotation.z() *= -1;
        part.velocity[4] *= -1;
        part.velocity[5] *= -1;
      }
      if (auto* half_space = std::get_if<HalfSpace<M>>(&part.shape)) half_space->normal.x() *= -1;
    }
    for (auto& link : view.links) link.at.x() *= -1;
    return view;
  });
}

/// The bodies are counted the other way.
template <class M>
std::string reordered(const Recipe<M>& recipe, const VelocityStepping& method) {
  if (!determined(recipe)) return {};
  return seen(recipe, method, [](Recipe<M> view) {
    std::reverse(view.parts.begin(), view.parts.end());
    std::reverse(view.links.begin(), view.links.end());
    const int last = static_cast<int>(view.parts.size()) - 1;
    for (auto& [joint, first, second, at] : view.links) {
      first = last - first;
      second = last - second;
    }
    return view;
  });
}

/// All masses are counted in another unit.
template <class M>
std::string weighed(const Recipe<M>& recipe, const VelocityStepping& method) {
  return seen(recipe, method, [](Recipe<M> view) {
    for (auto& part : view.parts) part.mass *= 1024;  // no rounding, or friction may take another way
    return view;
  });
}

/// All lengths are counted in another unit: gravity, speeds, margin and slop as well.
template <class M>
std::string measured(const Recipe<M>& recipe, const VelocityStepping& choice) {
  VelocityStepping method = choice;
  constexpr double unit = 8;
  const auto enlarged = [&](Recipe<M> view) {
    view.gravity *= unit;
    view.margin *= unit;
    for (auto& part : view.parts) {
      part.pose.position *= unit;
      part.velocity.template head<M::linear>() *= unit;
      if (auto* ball = std::get_if<Ball<M>>(&part.shape)) ball->radius *= unit;
      if (auto* box = std::get_if<Box<M>>(&part.shape)) box->sides *= unit;
    }
    for (auto& link : view.links) link.at *= unit;
    return view;
  };
  auto then = stepped(recipe, method);
  if (!then) return {};
  then->then = enlarged(then->then);
  if (auto* cure = std::get_if<Baumgarte>(&method.drift)) cure->slop *= unit;
  method.bounce_threshold *= unit;
  const auto other = stepped(enlarged(recipe), method);
  return other ? differ(*other, *then, h * unit * recipe.gravity.norm()) : "";
}

/// A box in halves that are welded together moves as the box. Where bodies touch one another the halves have other
/// corners: scenes on the ground alone, without friction, whose share of each point is not determined.
template <class M>
std::string split(const Recipe<M>& drawn, const VelocityStepping& choice) {
  Recipe<M> recipe = drawn;
  recipe.margin = 0.5;   // or corners in the middle are seen where those of the box are not
  recipe.lookahead = 0;  // what turns meets each half at another time
  VelocityStepping method = choice;
  method.gyroscopic = Gyroscopic::none;  // whose midpoint the halves have elsewhere
  const auto box = std::ranges::find_if(
      recipe.parts, [](const auto& part) { return part.mass > 0 && std::holds_alternative<Box<M>>(part.shape); });
  if (box == recipe.parts.end()) return {};
  if (!determined(recipe)) return {};
  Simulation<M> simulation{scene_of(recipe), method};
  simulation.step(h);
  for (const ContactPair<M>& pair : simulation.work.contacts.pairs())
    if (!std::holds_alternative<HalfSpace<M>>(recipe.parts[pair.bodies.first].shape)) return {};
  double deepest = 0, widest = 0;
  for (const double C : simulation.work.system.C) {
    deepest = std::min(deepest, C);
    widest = std::max(widest, C);
  }
  if (deepest < -1e-9 && widest > 0)
    return {};  // between what overlaps and what is open the middle has its own say
  const int whole = static_cast<int>(box - recipe.parts.begin());
  for (const auto& link : recipe.links)  // one half would touch what is joined to the other
    if (link.first == whole || link.second == whole) return {};
  return seen(recipe, method, [&](Recipe<M> view) {
    auto& left = view.parts[whole];
    auto& sides = std::get<Box<M>>(left.shape).sides;
    sides.x() *= 0.5;
    left.mass *= 0.5;
    const Linear<M> centre = left.pose.position;
    const Arm<M> aside = rotate(left.pose.rotation, Linear<M>(0.5 * sides.x() * Linear<M>::Unit(0)));
    auto right = left;
    const auto place = [&](auto& half, const Arm<M>& arm) {
      half.pose.position += arm;
      const Angular<M> spin = half.velocity.template tail<M::angular>();
      for (int k = 0; k < M::linear; ++k)  // e_k · (ω × r) = ω · (r × e_k)
        half.velocity[k] += spin.dot(Angular<M>(cross(arm, Linear<M>(Linear<M>::Unit(k)))));
    };
    place(left, -aside);
    place(right, aside);
    view.links.push_back({Recipe<M>::Joint::weld, whole, static_cast<int>(view.parts.size()), centre});
    view.parts.push_back(right);
    return view;
  });
}

/// λ of the step before is a beginning, not a part of the answer.
template <class M>
std::string begun(const Recipe<M>& recipe, const VelocityStepping& method) {
  if (!determined(recipe)) return {};
  Simulation<M> warm{scene_of(recipe), method};
  for (int i = 0; i < 10; ++i) warm.step(h);
  Simulation<M> cold = warm;
  std::ranges::fill(cold.work.system.lambda, 0.0);
  cold.work.contacts.read_impulses(cold.work.system);
  warm.step(h);
  cold.step(h);
  if (!warm.work.solution.converged || !cold.work.solution.converged) return {};
  return differ(stepped(recipe, warm), stepped(recipe, cold), h * recipe.gravity.norm());
}

/// Two points of one manifold press as two contacts do.
std::string counted(const Recipe<PlaneBody>& recipe, const VelocityStepping& method) {
  if (!determined(recipe)) return {};
  return seen(recipe, method, [](Recipe<PlaneBody> view) {
    view.rows = ContactRows::points;
    return view;
  });
}

/// Solved to the end, for what is compared.
VelocityStepping solved_to_the_end(VelocityStepping method) {
  if (auto* choice = std::get_if<ByGraph>(&method.solver)) {
    choice->loops = {.sweeps = 20000, .tolerance = to_the_end};
    choice->loopless.tolerance = choice->stalled.tolerance = to_the_end;
  }
  if (auto* sweeps = std::get_if<ConjugateSweeps>(&method.solver))
    *sweeps = {.sweeps = 100000, .tolerance = to_the_end};
  return method;
}
template <class M>
const std::vector<Law<M>>& all() {
  static const std::vector<Law<M>> laws = [] {
    std::vector<Law<M>> result = {{"every step ends in finite numbers", gives_up<M>},
                                  {"impulses give the velocities", impulses_miss<M>},
                                  {"a step converges that says so", not_converged<M>},
                                  {"bodies do not sink into each other", sunken<M>},
                                  {"no energy comes from nowhere", energy_made<M>},
                                  {"moved", moved<M>, true},
                                  {"turned", turned<M>, true},
                                  {"in a mirror", mirrored<M>, true},
                                  {"counted in another order", reordered<M>, true},
                                  {"in another unit of mass", weighed<M>, true},
                                  {"in another unit of length", measured<M>, true},
                                  {"a box split in two", split<M>, true},
                                  {"with another beginning", begun<M>, true}};
    if constexpr (M::linear == 2) result.push_back({"manifolds as points", counted, true});
    return result;
  }();
  return laws;
}

}  // namespace

template <class M>
std::span<const Law<M>> laws() {
  return all<M>();
}

template <class M>
std::string broken(const Law<M>& law, const Recipe<M>& recipe, const VelocityStepping& method) {
  try {
    return law.broken(recipe, law.to_the_end ? solved_to_the_end(method) : method);
  } catch (const std::exception&) {
    return {};
  }
}

template <class M>
Recipe<M> after(const Recipe<M>& recipe, const VelocityStepping& method, int steps) {
  Simulation<M> simulation{scene_of(recipe), method};
  for (int i = 0; i < steps; ++i) simulation.step(h);
  return recipe_of(recipe, simulation.scene);
}

#define BYHAND_INSTANTIATE(M)                                                            \
  template std::span<const Law<M>> laws<M>();                                            \
  template std::string broken(const Law<M>&, const Recipe<M>&, const VelocityStepping&); \
  template Recipe<M> after(const Recipe<M>&, const VelocityStepping&, int)
BYHAND_INSTANTIATE(PlaneBody);
BYHAND_INSTANTIATE(SpaceBody);
#undef BYHAND_INSTANTIATE

}  // namespace byhand::fuzz
