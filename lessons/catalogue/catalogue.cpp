#include "lessons/catalogue/catalogue.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "lessons/exact/compound_pendulum.hpp"
#include "lessons/exact/conical_pendulum.hpp"
#include "lessons/exact/simple_pendulum.hpp"
#include "lessons/exact/spherical_pendulum.hpp"
#include "lessons/exact/swinging_chain.hpp"
#include "lessons/scenes/chain.hpp"
#include "lessons/scenes/conical_pendulum.hpp"
#include "lessons/scenes/four_bar.hpp"
#include "lessons/scenes/incline.hpp"
#include "lessons/scenes/spherical_pendulum.hpp"
#include "lessons/scenes/top.hpp"

namespace byhand {
namespace {

using Exact = std::function<ExactState(double)>;
using Eigen::Vector3d;

constexpr double radians(double degrees) { return degrees * (std::numbers::pi / 180); }

// What a chain or pendulum can be made of.
const std::string bobs = "bobs in the plane", balls = "balls in the plane", space_bobs = "bobs in space",
                  space_balls = "balls in space", links = "links in the plane", space_links = "links in space",
                  touching_links = "links in the plane that could touch";

const SceneParameter gravity{"gravity", "m/s²", "pull of the earth", 9.81, 0.01, 1e6};
const SceneParameter mass{"mass", "kg", "mass of the body", 1, 1e-6, 1e6};
SceneParameter angle_of(double initial, const char* meaning = "from straight down, at first") {
  return {"angle", "°", meaning, initial, -179, 179};
}
SceneParameter length_of(const char* meaning) { return {"length", "m", meaning, 1, 1e-3, 1e3}; }

template <class M>
AnyScene pulled(Scene<M> scene, const Problem& problem) {
  scene.gravity = -problem["gravity"] * Linear<M>::Unit(1);
  return scene;
}

/// Something that turns about z at the origin, its centre `arm` [m] from there.
ExactState on_a_circle(double angle, double rate, double arm, double kilograms) {
  const Vector3d e(std::sin(angle), -std::cos(angle), 0), n(std::cos(angle), std::sin(angle), 0);
  return {{arm * e}, kilograms * arm * rate * n, 1e-14 * arm};
}

AnyScene make_pendulum(const Problem& p) {
  const double angle = radians(p["angle"]), length = p["length"], kilograms = p["mass"];
  if (p.model() == balls) return pulled(pendulum<PlaneBody, NormalisedDistance>(angle, length, kilograms), p);
  if (p.model() == space_bobs)
    return pulled(pendulum<SpaceParticle, NormalisedDistance>(angle, length, kilograms), p);
  if (p.model() == space_balls)
    return pulled(pendulum<SpaceBody, NormalisedDistance>(angle, length, kilograms), p);
  return pulled(pendulum<PlaneParticle, NormalisedDistance>(angle, length, kilograms), p);
}
Exact exact_pendulum(const Problem& p) {
  const SimplePendulum exact(radians(p["angle"]), p["length"], p["gravity"]);
  return [exact, length = p["length"], kilograms = p["mass"]](double time) {
    return on_a_circle(exact.angle(time), exact.angular_velocity(time), length, kilograms);
  };
}

AnyScene make_compound_pendulum(const Problem& p) {
  const double angle = radians(p["angle"]), length = p["length"], kilograms = p["mass"];
  if (p.model() == space_links) return pulled(hinged_rod<SpaceBody>(angle, length, kilograms), p);
  return pulled(hinged_rod<PlaneBody>(angle, length, kilograms), p);
}
Exact exact_compound_pendulum(const Problem& p) {
  const CompoundPendulum exact(radians(p["angle"]), p["length"], p["mass"], p["gravity"]);
  return [exact, length = p["length"], kilograms = p["mass"]](double time) {
    return on_a_circle(exact.angle(time), exact.angular_velocity(time), length / 2, kilograms);
  };
}

ChainOptions chain_of(const Problem& p, int count) {
  return {count, p["length"], p["mass"], p["end_mass"], radians(p["angle"])};
}
/// The same links, of which the last has a shape: contacts are looked for in every step, and none is ever found.
Scene<PlaneBody> that_could_touch(Scene<PlaneBody> chain, double length) {
  chain.set_shape(chain.bodies().size() - 1, Box<PlaneBody>{{length / 10, length}});
  return chain;
}
AnyScene make_chain(const Problem& p, const ChainOptions& chain) {
  if (p.model() == bobs) return pulled(rod_chain<PlaneParticle, NormalisedDistance>(chain), p);
  if (p.model() == balls) return pulled(rod_chain<PlaneBody, NormalisedDistance>(chain), p);
  if (p.model() == space_bobs) return pulled(rod_chain<SpaceParticle, NormalisedDistance>(chain), p);
  if (p.model() == space_balls) return pulled(rod_chain<SpaceBody, NormalisedDistance>(chain), p);
  if (p.model() == space_links) return pulled(pinned_chain<SpaceBody>(chain), p);
  if (p.model() == touching_links)
    return pulled(that_could_touch(pinned_chain<PlaneBody>(chain), chain.length), p);
  return pulled(pinned_chain<PlaneBody>(chain), p);
}
Exact exact_chain(const Problem& p, const ChainOptions& chain) {
  const bool stiff = p.model() == links || p.model() == space_links || p.model() == touching_links;
  std::vector<SwingingChain::Link> all;
  for (int i = 1; i <= chain.links; ++i) {
    const double kilograms = i == chain.links ? chain.end_mass : chain.mass;
    const double inertia =
        1.01 / 12 * kilograms * chain.length * chain.length;  // of a box a tenth as thick as long
    all.push_back(stiff ? SwingingChain::Link{chain.length, chain.length / 2, kilograms, inertia}
                        : SwingingChain::Link{chain.length, chain.length, kilograms, 0});
  }
  return [exact = SwingingChain(all, chain.angle, p["gravity"]), all](double time) {
    const SwingingChain::State end = exact.at(time);
    ExactState state;
    double reach = 0;
    for (std::size_t i = 0; i < all.size(); ++i) {
      state.positions.emplace_back(end.positions[i].x(), end.positions[i].y(), 0);
      state.momentum.head<2>() += all[i].mass * end.velocities[i];
      reach += all[i].length;
    }
    state.uncertainty = reach * end.uncertainty;
    return state;
  };
}
AnyScene make_long_chain(const Problem& p) { return make_chain(p, chain_of(p, static_cast<int>(p["links"]))); }
Exact exact_long_chain(const Problem& p) { return exact_chain(p, chain_of(p, static_cast<int>(p["links"]))); }
AnyScene make_double_pendulum(const Problem& p) { return make_chain(p, chain_of(p, 2)); }
Exact exact_double_pendulum(const Problem& p) { return exact_chain(p, chain_of(p, 2)); }

FourBarOptions bars_of(const Problem& p) {
  return {p["length"], p["coupler"], p["mass"], p["coupler_mass"], radians(p["angle"])};
}
AnyScene make_four_bar(const Problem& p) { return pulled(four_bar(bars_of(p)), p); }
Exact exact_four_bar(const Problem& p) {
  const FourBarOptions bars = bars_of(p);
  return [exact = SimplePendulum(bars.angle, pendulum_length(bars), p["gravity"]), bars](double time) {
    const double angle = exact.angle(time), rate = exact.angular_velocity(time);
    const ExactState arm = on_a_circle(angle, rate, bars.arm / 2, bars.arm_mass),
                     tip = on_a_circle(angle, rate, bars.arm, bars.coupler_mass);
    const Vector3d across(bars.coupler, 0, 0);
    return ExactState{{arm.positions[0], across + arm.positions[0], tip.positions[0] + across / 2},
                      2 * arm.momentum + tip.momentum,
                      tip.uncertainty};
  };
}

AnyScene make_spherical_pendulum(const Problem& p) {
  return pulled(spherical_pendulum<SpaceParticle>(radians(p["angle"]), p["azimuth_rate"], p["length"], p["mass"]),
                p);
}
Exact exact_spherical_pendulum(const Problem& p) {
  const SphericalPendulum exact(radians(p["angle"]), p["azimuth_rate"], p["length"], p["gravity"]);
  return [exact, length = p["length"], kilograms = p["mass"]](double time) {
    const auto s = exact.at(time);
    const double sine = std::sin(s.angle), cosine = std::cos(s.angle);
    const Vector3d out(std::cos(s.azimuth), 0, -std::sin(s.azimuth)),
        round(-std::sin(s.azimuth), 0, -std::cos(s.azimuth)), down(0, -1, 0);
    const Vector3d velocity =
        s.angle_rate * (cosine * out - sine * down) + s.azimuth_rate * sine * round;  // over the length
    return ExactState{
        {length * (sine * out + cosine * down)}, kilograms * length * velocity, 2 * length * s.uncertainty};
  };
}

AnyScene make_conical_pendulum(const Problem& p) {
  const ConicalPendulum exact(radians(p["angle"]), p["length"], p["gravity"]);
  return pulled(
      spherical_pendulum<SpaceParticle>(radians(p["angle"]), exact.angular_velocity(), p["length"], p["mass"]), p);
}
/// Something that goes round the vertical, with its centre at `at` first.
ExactState round_the_vertical(const Vector3d& at, double rate, double kilograms, double time) {
  const double sine = std::sin(rate * time), cosine = std::cos(rate * time);
  const Vector3d now(cosine * at.x(), at.y(), -sine * at.x());
  return {{now}, kilograms * rate * Vector3d(now.z(), 0, -now.x()), 1e-15 * (1 + rate * time) * at.norm()};
}
Exact exact_conical_pendulum(const Problem& p) {
  const double angle = radians(p["angle"]), length = p["length"];
  const ConicalPendulum exact(angle, length, p["gravity"]);
  return [=, kilograms = p["mass"]](double time) {
    return round_the_vertical(length * Vector3d(std::sin(angle), -std::cos(angle), 0), exact.angular_velocity(),
                              kilograms, time);
  };
}

HeavyTop top_of(const Problem& p) {
  HeavyTop top;  // a disc on a stick: its moments across are those of a disc about the tip
  top.mass = p["mass"];
  top.arm = p["arm"];
  const double radius = p["radius"];
  top.moment_along = top.mass * radius * radius / 2;
  top.moment_across = top.mass * (radius * radius / 4 + top.arm * top.arm);
  top.spin = p["spin"];
  top.gravity = p["gravity"];
  return top;
}
AnyScene make_top(const Problem& p) {
  const HeavyTop top = top_of(p);
  const double angle = radians(p["angle"]);
  return spinning_top(top, angle, top.precession(angle)[0]);
}
Exact exact_top(const Problem& p) {
  const HeavyTop top = top_of(p);
  const double angle = radians(p["angle"]), rate = top.precession(angle)[0];
  return [=](double time) {
    return round_the_vertical(top.arm * Vector3d(std::sin(angle), std::cos(angle), 0), rate, top.mass, time);
  };
}

Surface surface_of(const Problem& p) { return {p["friction"]}; }
AnyScene make_stack(const Problem& p) {
  Scene<PlaneBody> scene = stack(static_cast<int>(p["boxes"]), p["top_mass"], surface_of(p));
  kick(scene, p["kick"]);
  return pulled(std::move(scene), p);
}
AnyScene make_pyramid(const Problem& p) {
  Scene<PlaneBody> scene = pyramid(static_cast<int>(p["base"]), surface_of(p));
  kick(scene, p["kick"]);
  return pulled(std::move(scene), p);
}
/// What stands goes on standing.
Exact stands(const Problem& p) {
  ExactState state;
  for (const Placement& body : p.start().placements())
    if (body.moves) state.positions.push_back(body.position);
  return [state](double) { return state; };
}

AnyScene make_incline(const Problem& p) {
  return pulled(box_on_incline(radians(p["angle"]), p["friction"], p["speed"], {1, p["height"]}, p["mass"]), p);
}
Exact exact_incline(const Problem& p) {
  const double slope = radians(p["angle"]), speed = p["speed"], kilograms = p["mass"], height = p["height"];
  const Vector3d down(std::cos(slope), -std::sin(slope), 0), up(std::sin(slope), std::cos(slope), 0);
  const double drive = p["gravity"] * std::sin(slope), drag = p["friction"] * p["gravity"] * std::cos(slope);
  const double braking = drive - drag, stops = speed > 0 && braking < 0 ? speed / -braking : 0;
  const double released = std::abs(drive) <= drag ? 0 : drive - std::copysign(drag, drive);
  return [=](double time) {
    // Friction turns round where the block does: it slides on as it began, sticks, or slides back.
    const bool begun = speed > 0 && (braking >= 0 || time < stops);
    const double v = begun ? speed : 0, a = begun ? braking : released, t = begun ? time : time - stops;
    const double way = (begun ? 0 : speed * stops / 2) + v * t + a * t * t / 2;
    return ExactState{{0.5 * height * up + way * down}, kilograms * (v + a * t) * down, 1e-15};
  };
}

std::vector<NamedScene> make_catalogue() {
  const std::vector<std::string> any_bobs{bobs, balls, space_bobs, space_balls};
  const std::vector<std::string> any_chain{links,      touching_links, bobs,       balls,
                                           space_bobs, space_balls,    space_links};
  const std::vector<std::string> any_two{bobs, balls, space_bobs, space_balls, links, space_links};
  const SceneParameter friction{"friction", "1", "μ of all surfaces", 0.6, 0, 1e6},
      kick{"kick", "m/s", "sideways speed of the topmost box at first", 0, -10, 10},
      end_mass{"end_mass", "kg", "mass of the last link", 1, 1e-6, 1e6},
      link_mass{"mass", "kg", "mass of each other link", 1, 1e-6, 1e6};
  const std::string elliptic = "closed form (elliptic functions)",
                    angles = "two unrelated high-order integrations in the links' angles";
  return {
      {.name = "pendulum",
       .title = "simple pendulum",
       .parameters = {angle_of(90), length_of("of the rod"), mass, gravity},
       .models = any_bobs,
       .stress = "gravity",
       .duration = 10,
       .size = "length",
       .varied = {"angle"},
       .reference = elliptic,
       .make = make_pendulum,
       .exact = exact_pendulum},
      {.name = "compound_pendulum",
       .title = "compound pendulum",
       .parameters = {angle_of(90), length_of("of the rod"), mass, gravity},
       .models = {links, space_links},
       .stress = "gravity",
       .duration = 10,
       .size = "length",
       .varied = {"angle"},
       .reference = elliptic,
       .make = make_compound_pendulum,
       .exact = exact_compound_pendulum},
      {.name = "double_pendulum",
       .title = "double pendulum",
       .parameters = {angle_of(90), length_of("of each rod"), link_mass, end_mass, gravity},
       .models = any_two,
       .stress = "end_mass",
       .size = "length",
       .varied = {"angle"},
       .chaotic = true,
       .reference = angles,
       .make = make_double_pendulum,
       .exact = exact_double_pendulum},
      {.name = "chain",
       .title = "chain",
       .parameters = {{"links", "1", "number of links", 50, 1, 2000, true},
                      end_mass,
                      link_mass,
                      length_of("of each link"),
                      angle_of(90),
                      gravity},
       .models = any_chain,
       .stress = "end_mass",
       .size = "length",
       .varied = {"angle"},
       .chaotic = true,
       .reference = angles,
       .make = make_long_chain,
       .exact = exact_long_chain},
      {.name = "four_bar",
       .title = "four-bar linkage",
       .parameters = {angle_of(60),
                      length_of("of the arms"),
                      {"coupler", "m", "length of the coupler", 2, 1e-3, 1e3},
                      mass,
                      {"coupler_mass", "kg", "mass of the coupler", 1, 1e-6, 1e6},
                      gravity},
       .models = {links},
       .stress = "coupler_mass",
       .size = "length",
       .varied = {"angle"},
       .reference = elliptic,
       .make = make_four_bar,
       .exact = exact_four_bar},
      {.name = "spherical_pendulum",
       .title = "spherical pendulum",
       .parameters = {{"angle", "°", "from straight down, at first", 60, 1, 179},
                      {"azimuth_rate", "rad/s", "about the vertical, at first", 2, 0.01, 1e3},
                      length_of("of the rod"),
                      mass,
                      gravity},
       .models = {space_bobs},
       .stress = "azimuth_rate",
       .keeps_spin = true,
       .size = "length",
       .varied = {"angle"},
       .reference = elliptic,
       .make = make_spherical_pendulum,
       .exact = exact_spherical_pendulum},
      {.name = "conical_pendulum",
       .title = "conical pendulum",
       .parameters = {{"angle", "°", "from straight down", 60, 1, 89}, length_of("of the rod"), mass, gravity},
       .models = {space_bobs},
       .stress = "gravity",
       .keeps_spin = true,
       .size = "length",
       .varied = {"angle"},
       .reference = "closed form",
       .make = make_conical_pendulum,
       .exact = exact_conical_pendulum},
      {.name = "top",
       .title = "spinning top",
       .parameters = {{"angle", "°", "from straight up", 30, 1, 90},
                      {"spin", "rad/s", "about its own axis", 30, 1, 1e4},
                      {"arm", "m", "from the tip to the centre", 0.2, 1e-3, 1e3},
                      {"radius", "m", "radius of its disc", 0.25, 1e-3, 1e3},
                      mass,
                      gravity},
       .models = {space_links},
       .stress = "spin",
       .keeps_spin = true,
       .size = "arm",
       .varied = {"spin"},
       .reference = "closed form (steady precession)",
       .make = make_top,
       .exact = exact_top},
      {.name = "stack",
       .title = "stack of boxes",
       .parameters = {{"boxes", "1", "number of boxes", 10, 1, 1000, true},
                      {"top_mass", "kg", "mass of the topmost box", 1, 1e-6, 1e6},
                      kick,
                      friction,
                      gravity},
       .models = {"boxes in the plane"},
       .stress = "top_mass",
       .time = 5,
       .duration = 30,
       .duty = Duty::stand,
       .varied = {"kick"},
       .reference = "it stands",
       .make = make_stack,
       .exact = stands},
      {.name = "pyramid",
       .title = "pyramid of boxes",
       .parameters =
           {{"base", "1", "number of boxes in the lowest row", 10, 1, 100, true}, kick, friction, gravity},
       .models = {"boxes in the plane"},
       .stress = "gravity",
       .time = 5,
       .duration = 30,
       .duty = Duty::stand,
       .varied = {"kick"},
       .reference = "it stands",
       .make = make_pyramid,
       .exact = stands},
      {.name = "incline",
       .title = "block on an incline",
       .parameters = {{"angle", "°", "of the slope", 20, -80, 80},
                      {"friction", "1", "μ", 0.5, 0, 1e6},
                      {"speed", "m/s", "down the slope at first", 2, 0, 100},
                      {"height", "m", "of the block, which is 1 m long", 0.2, 1e-3, 10},
                      mass,
                      gravity},
       .models = {"boxes in the plane"},
       .stress = "speed",
       .duration = 2,
       .duty = Duty::slide,
       .keeps_energy = false,
       .varied = {"speed"},
       .reference = "closed form",
       .make = make_incline,
       .exact = exact_incline},
  };
}

template <class All, class Name>
std::string listed(const All& all, Name&& name) {
  std::string text;
  for (const auto& one : all) text += (text.empty() ? "" : ", ") + name(one);
  return text;
}

}  // namespace

void require(bool holds, std::string_view what, std::string_view name, std::string_view allowed) {
  if (!holds) throw std::invalid_argument(fmt::format("{} is {}, but it must be {}", what, name, allowed));
}

const std::vector<NamedScene>& catalogue() {
  static const std::vector<NamedScene> all = make_catalogue();
  return all;
}

const NamedScene& named_scene(std::string_view name) {
  for (const NamedScene& scene : catalogue())
    if (scene.name == name) return scene;
  require(false, "scene", name, "one of " + listed(catalogue(), [](const auto& s) { return s.name; }));
  return catalogue().front();
}

Problem::Problem(std::string_view scene, const Values& values, std::string_view model)
    : Problem(std::shared_ptr<const NamedScene>(std::shared_ptr<void>(), &named_scene(scene)), values, model) {}

Problem::Problem(std::shared_ptr<const NamedScene> scene, const Values& values, std::string_view model)
    : scene_(std::move(scene)), model_(model.empty() ? scene_->models.front() : model) {
  const auto& models = scene_->models;
  require(std::find(models.begin(), models.end(), model_) != models.end(), "model", model_,
          "one of " + listed(models, [](const auto& m) { return m; }));
  for (const SceneParameter& parameter : scene_->parameters) {
    const auto given = values.find(parameter.name);
    const double value = given == values.end() ? parameter.initial : given->second;
    require_in(parameter.name, value, parameter.low, parameter.high, parameter.unit);
    require(!parameter.whole || value == std::round(value), parameter.name, value, "a whole number");
    values_.emplace(parameter.name, value);
  }
  for (const auto& [name, value] : values)
    require(values_.count(name) > 0, "parameter of the scene " + scene_->name, name,
            "one of " + listed(scene_->parameters, [](const auto& p) { return p.name; }));
}

Problem Problem::with(std::string_view parameter, double value) const {
  Values values = values_;
  values[std::string(parameter)] = value;
  return Problem(scene_, values, model_);
}

Problem Problem::variation(int i, int seed) const {
  if (i == 0) return *this;
  Problem varied = *this;
  double rate = 0.6180339887498949;  // of each parameter another irrational one
  for (const std::string& name : scene_->varied) {
    const double place = rate * i + 0.7548776662466927 * seed, share = place - std::floor(place),
                 value = (*this)[name], push = value == 0 ? 0.02 : std::abs(value);
    varied = varied.with(
        name, name == "kick" ? (i % 2 == 0 ? 1 : -1) * push * (0.5 + 0.5 * share) : value * (0.95 + 0.1 * share));
    rate = std::sqrt(1 + rate) - 1;
  }
  return varied;
}

const Reference& Problem::reference() const {
  std::call_once(known_->once, [&] {
    Reference& known = known_->reference;
    known.time = scene_->time;
    if (scene_->chaotic) {
      known.lyapunov_time = lyapunov_time(*this);
      known.time = std::max(2 * frame, std::min(known.time, std::floor(known.lyapunov_time / frame) * frame));
    }
    const auto exact = scene_->exact(*this);
    const ExactState before = exact(known.time - frame), end = exact(known.time);
    known.positions = end.positions;
    known.uncertainty = std::max(before.uncertainty, end.uncertainty);
    known.reaction = (end.momentum - before.momentum) / frame - start().weight();
  });
  return known_->reference;
}

}  // namespace byhand
