// Step 1: who takes part, and how an adapter is kept from slandering an engine.

#include "lessons/10_beside_the_engines/field.hpp"
#include "lessons/10_beside_the_engines/steps.hpp"
#include "lessons/exact/compound_pendulum.hpp"
#include "lessons/scenes/boxes.hpp"
#include "lessons/scenes/chain.hpp"
#include "lessons/scenes/pendulum.hpp"

namespace byhand::beside {
namespace {

using M = PlaneBody;

/// How far a box that is let go has fallen in a second [m].
double fallen(const Contestant<M>& contestant) {
  Scene<M> scene;
  scene.add_body(Linear<M>(0, 10), box<M>(2, {1, 0.5}));
  double height = 10;
  engines::run<M>(contestant, scene, 60,
                  [&](const Scene<M>& seen, double) { height = seen.bodies().pose[0].position.y(); });
  return 10 - height;
}

/// The angle of a hinged rod after a second of 64 steps a frame, less the exact one [rad].
double angle_error(const Engine& engine) {
  const double angle = 1, rod_length = 1.5, rod_mass = 2;
  double turned = 0;
  engines::run<M>(engines::contestant<M>(engine, {.steps = 64}), hinged_rod(angle, rod_length, rod_mass), 60,
                  [&](const Scene<M>& seen, double) {
                    const auto& rotation = seen.bodies().pose[1].rotation;
                    turned = std::atan2(rotation.sin, rotation.cos);
                  });
  return turned - CompoundPendulum(angle, rod_length, rod_mass, gravity).angle(1);
}

/// Which error of a scheme is nearest to this one: ½gt·h of 1, 2, 4 or 8 steps a frame, too far or short, or none
/// [m].
double of_the_step(double error) {
  double nearest = 0;
  for (const int steps : {1, 2, 4, 8})
    for (const double sign : {1, -1})
      if (const double own = sign * 0.5 * gravity * frame / steps;
          std::abs(error - own) < std::abs(error - nearest))
        nearest = own;
  return nearest;
}

const char* home_of(const Engine& engine) {
  switch (engine.home) {
    case engines::Home::plane: return "plane";
    case engines::Home::space: return "space";
    case engines::Home::both: return "plane and space";
  }
  return "";
}

template <std::size_t n>
std::string numbers(const std::array<int, n>& all) {
  std::vector<std::string> words;
  for (const int number : all) words.push_back(std::to_string(number));
  return listed(words);
}

}  // namespace

std::vector<std::vector<std::string>> left_out(const Setting& setting, Party party) {
  struct Out {
    std::string engine, scenes, why;
  };
  std::vector<Out> all;
  const auto ask = [&](const std::string& name, const auto& scene, From from = From::home) {
    for (const Engine& engine : members(party)) {
      const std::string why = why_not(engine, scene, from);
      if (why.empty()) continue;
      const auto same = std::find_if(all.begin(), all.end(),
                                     [&](const Out& out) { return out.engine == engine.name && out.why == why; });
      if (same == all.end())
        all.push_back({engine.name, name, why});
      else
        same->scenes += ", " + name;
    }
  };
  using S = SpaceBody;
  const ChainOptions chain{.links = setting.links, .end_mass = setting.end_mass};
  const bool native = party == Party::native;
  if (native) ask("bob on a rod", pendulum<M>(1, 1.5, 2), From::everywhere);
  ask("chain", pinned_chain<M>(chain));
  if (native) ask("stacks", stack<M>(30));
  ask("pyramid", pyramid<M>(setting.base));
  ask("chain in space", pinned_chain<S>(chain));
  if (native) ask("stacks in space", stack<S>(30));
  ask("pyramid in space", pyramid<S>(setting.base));
  std::vector<std::vector<std::string>> rows;
  for (const Out& out : all) {
    const auto same = std::find_if(rows.begin(), rows.end(),
                                   [&](const auto& row) { return row[1] == out.scenes && row[2] == out.why; });
    if (same == rows.end())
      rows.push_back({out.engine, out.scenes, out.why});
    else
      same->front() += ", " + out.engine;
  }
  return rows;
}

void the_engines(const Setting& setting, Page& page) {
  const auto& all = engines::all_engines();
  page.text(
      R"(How does what you have learnt compare with the engines that people use? This lesson puts the course's scenes
      into @. Each gets the same bodies, shapes and joints, and its motion is read back and measured by the functions
      that measure ours. Sleeping is switched off, and building a world is not timed.)",
      all.empty()
          ? "other engines"
          : several(static_cast<long>(all.size()), "engine or mode of an engine", "engines or modes of engines"));
  if (!engines::missing().empty()) {
    std::string names;
    for (const std::string& name : engines::missing()) names += (names.empty() ? "" : ", ") + name;
    page.text(
        R"(@Not here: @. `./lessons/run 10` installs those that Debian has and builds with them; CMake fetches Box2D 3
        and Box3D if you configure with `-DBYHAND_BOX2D_3=ON` and `-DBYHAND_BOX3D=ON`.)",
        alone() ? "This build has no other engine, so the tables hold this course alone, and nothing is drawn. "
                : "",
        names);
  }
  std::vector<const Engine*> everybody{&engines::this_course()};
  for (const Engine& engine : all) everybody.push_back(&engine);
  std::vector<std::vector<std::string>> rows;
  for (const Engine* engine : everybody)
    rows.push_back({engine->name, engine->version.empty() ? "this build" : engine->version, home_of(*engine),
                    engine->single ? "single" : "double", with_build(*engine),
                    engine->file.substr(engine->file.rfind('/') + 1)});
  page.table({"engine", "version", "dimensions", "precision", "how it solves", "its settings"}, rows);
  page.text(
      R"(Semismooth Newton solves for all impulses at once, and again with other bounds active until none changes.
      *As shipped*: only what must be set is set, and switched off is what would take energy that the scenes do not lose:
      damping, friction of joints and, where an engine lets it, limits of linear speed (those of turning stay). *As its manual advises*: the knob that a source of its makers names is
      turned the way it says, to its number or, where it gives none, to one of our choice: twice the iterations, substeps
      or, of ODE's chain, steps, ten times MuJoCo's impratio, which its manual advises against slip, four times this course's
      substeps and 128 of its sweeps. For PhysX's articulations it is an example that its makers give. Both stand in `lessons/engines/settings/` (for this
      course the sources are lesson 8 and its solver's reference).)");
  if (!alone())
    page.text(
        R"(*Best of the settings tried*: besides these two each engine, this course too, is tried with @ steps a frame, with contacts @. An
        iterative one shares out up to @ iterations a frame among them (a pendulum @, in space @; contacts @, the
        pyramid in space @), and one that takes a sweep a substep (Box2D 3, Box3D) as many substeps in one step. Not counted are the rounds of this
        course's Newton's method, position sweeps and relaxing sweeps, though their time is. For joints this course also tries lesson 9's RK4 and RATTLE, which
        know no contacts, and Bullet its direct solver. Each point of a chart is one setting, named in its data, timed on
        this machine; a table names the first of equals. A float has 24 bits; at 50 m the last of them is 4 µm, which is
        about as far as an engine in single precision can close a gap there. So the comparison of chains with one ends at 4 µm,
        all others at 1 µm, and at 10⁻⁶ rad. Above that, errors within a hundredth count as equal. Times do within a tenth, and
        an engine counts as ahead only if it still is with a tenth more time than its quickest round, and as level without.)",
        numbers(engines::joint_steps), numbers(engines::contact_steps), engines::joint_iterations.back(),
        most_of_a_pendulum, most_in_space, most_of_contacts, most_of_a_wall_in_space);
  if (const auto out = left_out(setting, Party::native); !out.empty()) page.table(head_of_left_out, out);
  page.text(
      R"(An adapter that gave an engine the wrong inertia would make the engine look wrong. So each that this program holds is first tested on
      what every engine must get right: free fall, and a rod on a pin that turns in the plane, whose angle is an elliptic
      integral; an inertia about this axis that is off by one in a hundred would show.)");

  const double step_error = 0.5 * gravity * frame;
  page.predict(
      {.ask =
           R"(A box falls from rest under symplectic Euler (velocities first, then positions), with one step of 1/60 s per
              frame. How many metres too far has it fallen after one second?)",
       .answer = step_error,
       .unit = "m",
       .tolerance = 0.02 * step_error,
       .wrong = {{gravity * frame,
                  "Not gh² a step: the position should move with the mean of the old and the new speed."}},
       .hints = {"Compare the velocity that a step uses with the mean velocity in that step.",
                 "Each step overshoots by ½gh².", "60 steps: 60 · ½ · 9.81 · (1/60)² = …"},
       .right = say("½gh² a step makes ½gt·h = @ m in t = 1 s.", Value(step_error, 3))});
  std::vector<std::pair<std::string, double>> falls{
      {ours_name, fallen(engines::contestant<M>(engines::this_course(), {}))}};
  for (const Engine& engine : all)
    falls.emplace_back(engine.name, fallen(engines::contestant<M>(engine, engine.settings.joints.front())));
  const double exact = 0.5 * gravity;
  page.text("Fallen in one second of 60 frames, where ½gt² is @ m:", Value(exact, 4));
  std::vector<std::vector<std::string>> table;
  for (const auto& [name, fall] : falls) {
    const double steps = step_error / (fall - exact);
    table.push_back({name, say("@ m", Value(fall, 4)),
                     std::abs(fall - exact) < 1e-4 ? "none"
                     : std::abs(steps - std::round(steps)) < 0.02 * std::abs(steps)
                         ? say("@½gt·h with h = 1/@ s", fall > exact ? "" : "−", std::lround(60 * std::abs(steps)))
                         : say("@ m", Value(fall - exact, 2))});
  }
  page.table({"engine", "fallen", "too far by"}, table);
  if (std::any_of(all.begin(), all.end(), [](const Engine& engine) { return engine.name == "Chipmunk"; }))
    page.text(
        "Chipmunk moves the bodies first and lets gravity act afterwards, so its box falls short by as much.");
  for (const auto& [name, fall] : falls)
    page.claim("free fall in a second, " + name, fall, "m",
               is(exact + of_the_step(fall - exact), "½gt², and none or ±½gt·h of 1, 2, 4 or 8 steps a frame",
                  absolute(1e-3)));
  for (const Engine& engine : all)
    page.claim("rod on a pin after 1 s, 64 steps a frame, " + engine.name, std::abs(angle_error(engine)), "rad",
               is_at_most(3.5e-4, "elliptic integral: half of what 1 % of inertia does"));
}

}  // namespace byhand::beside
