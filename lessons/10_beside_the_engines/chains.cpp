// Step 3: a level chain with a load at its end, and a tree.

#include "lessons/10_beside_the_engines/field.hpp"
#include "lessons/10_beside_the_engines/steps.hpp"
#include "lessons/scenes/branches.hpp"
#include "lessons/scenes/chain.hpp"

namespace byhand::beside {
namespace {

using M = PlaneBody;

constexpr int chain_frames = 60, most_at_once = 60;
constexpr int substeps = 4, most_substeps = 16;
constexpr double level = 1.57079632679489661923;

/// What a second has done to a chain; both are infinite once it has flown apart by more than its link.
struct Hung {
  double gap = 0;     // the largest of a pin [m]
  double gained = 0;  // energy at the end less that at first, over what gravity could do over its reach
};

Hung hang(const Contestant<M>& contestant, const Scene<M>& scene) {
  double scale = 0;
  for (int i = 0; i < scene.bodies().size(); ++i)
    if (moves(scene.bodies().inverse_mass[i]))
      scale += gravity * scene.bodies().pose[i].position.norm() / scene.bodies().inverse_mass[i].linear;
  Hung hung;
  engines::run<M>(contestant, scene, chain_frames, [&](const Scene<M>& seen, double) {
    hung.gap = larger(hung.gap, position_error(seen).max);
    hung.gained = (energy(seen) - energy(scene)) / scale;
  });
  return hung.gap < 1 ? hung : Hung{INFINITY, INFINITY};
}

double gap(const Contestant<M>& contestant, const Scene<M>& scene) { return hang(contestant, scene).gap; }

/// ODE solves all rows at once on a dense matrix, which takes the cube of their number.
bool may(const Engine& engine, int links) { return !engine.knob.empty() || links <= most_at_once; }

/// pinned_tree with the inertia of thin rods: links of 1 kg and about 1 m.
Scene<M> tree(int levels) {
  Scene<M> scene = pinned_tree<M>(levels);
  for (int i = 1; i < scene.bodies().size(); ++i) scene.set_mass(i, with_mass<M>(1, Angular<M>(1.0 / 12)));
  return scene;
}

Scene<M> chain_of(int links, double end_mass) {
  return pinned_chain<M>({.links = links, .end_mass = end_mass, .angle = level});
}

}  // namespace

void chains(const Setting& setting, Page& page) {
  const int links = setting.links;
  const double end_mass = setting.end_mass;
  const auto field = [](int count, int most) {
    return entrants<M>(substeps, most, [=](const Engine& engine) { return may(engine, count); });
  };
  page.text(
      R"(A chain of @ pinned links of 1 m and 1 kg, the last of @ kg, is held level and let go. What holds a chain is a
      force that every link has to pass on, so that an iteration per link is the least it takes, and a heavy end makes
      it worse (lesson 3). The error is the largest gap of a pin within @ s.)",
      links, end_mass, chain_frames * frame);

  const auto all = field(links, 4);
  const Scene<M> scene = chain_of(links, end_mass);
  const auto errors = errors_of(all, [&](const auto& who) { return gap(who, scene); });
  double iterative = INFINITY;
  for (const Errors& other : errors)
    if (other.name != ours_name && other.name != "ODE direct") iterative = std::min(iterative, other.usual());
  if (std::any_of(errors.begin(), errors.end(),
                  [](const Errors& e) { return e.name != ours_name && e.name != "ODE direct"; })) {
    const std::string reply = say("The best of them leaves a gap of @.", in_millimetres(iterative));
    page.choose({.ask = "Those that iterate, with their defaults: what is the least gap that any of them leaves?",
                 .options = {{"less than 1 mm", reply}, {"1 mm to 10 cm", reply}, {"more than 10 cm", reply}},
                 .answer = iterative < 1e-3   ? 0
                           : iterative <= 0.1 ? 1
                                              : 2,
                 .hints = {"How far does news of the load come up the chain in one frame?",
                           "One sweep moves it by a link or two; a warm start goes on in the next frame.",
                           say("@ links of 1 kg, and @ kg at the end.", links, end_mass)}});
  }
  page.figure("chain_gap",
              say("The chain of @ with @ kg at its end: largest gap of a pin in @ s.", links, end_mass,
                  chain_frames * frame),
              compared(errors, "largest gap (m)"));
  const Errors& ours = errors.front();
  std::vector<std::vector<std::string>> equal;
  for (std::size_t i = 1; i < errors.size(); ++i)
    equal.push_back(
        {errors[i].name, in_millimetres(errors[i].usual()), reached_with(all.front(), ours, errors[i].usual())});
  if (!equal.empty()) {
    page.text("How many substeps does this course need to be as exact as each engine is by default?");
    page.table({"engine", "its gap by default", "this course leaves no more with"}, equal);
  }
  page.clocked(
      "chain_clocked",
      R"(Gap and time of the same chain. The title compares this course with the fastest engine: what error it
               has in that engine's time, and in what time it has that engine's error. Times of this machine, at the
               moment of the run.)",
      [=] { return against_time(all, errors, scene, chain_frames, "largest gap (m)"); });

  const std::vector<double> loads{1, 10, 100, 1000};
  Chart by_load{.x = {.label = "mass of the end (kg)", .scale = Scale::logarithmic},
                .y = {.label = "largest gap (m)", .scale = Scale::logarithmic}};
  for (const Entrant<M>& entrant : field(links, 1)) {
    Curve curve{.label = entrant.name, .style = CurveStyle::line_and_markers};
    for (const double load : loads) {
      curve.x.push_back(load);
      curve.y.push_back(std::max(gap(entrant.settings.front(), chain_of(links, load)), 1e-9));
    }
    by_load.curves.push_back(std::move(curve));
  }
  page.figure("chain_load",
              say("The same against the mass of the end, by default. A cross: a gap of more than @ m.", 1),
              by_load);

  const std::vector<std::pair<std::string, Scene<M>>> others{{"chain of 10", chain_of(10, end_mass)},
                                                             {say("chain of @", links), scene},
                                                             {"chain of 200", chain_of(200, end_mass)},
                                                             {"tree of 255", tree(8)}};
  std::vector<std::string> gap_head{"largest gap"}, energy_head{"energy"};
  for (const auto& [name, other] : others) gap_head.push_back(name), energy_head.push_back(name);
  std::vector<std::vector<std::string>> gaps, energies;
  double ours_most = 0, theirs_most = 0;  // of energy that was gained or lost
  for (const Entrant<M>& entrant : field(most_at_once + 1, 1)) {
    gaps.push_back({entrant.name});
    energies.push_back({entrant.name});
    for (const auto& [name, other] : others) {
      const Hung hung = hang(entrant.settings.front(), other);
      double& most = entrant.name == ours_name ? ours_most : theirs_most;
      most = std::max(most, std::abs(hung.gained));
      gaps.back().push_back(in_millimetres(hung.gap));
      energies.back().push_back(std::isfinite(hung.gained) ? say("@ %", Value(100 * hung.gained, 2)) : "failed");
    }
  }
  page.text(
      R"(By default, in chains of three lengths with that end and in a tree of 255 links of 1 kg (ODE's direct mode
      would take a second a frame for 200 links, and is left out):)");
  page.table(gap_head, gaps);
  if (gaps.size() > 1) {
    std::vector<Contest<M>> contests;
    for (const auto& [name, other] : others) {
      contests.push_back({name, other, field(most_at_once + 1, 4), {}});
      contests.back().errors = errors_of(
          contests.back().entrants, [&scene = contests.back().scene](const auto& who) { return gap(who, scene); });
    }
    page.clocked(
        "chains_clocked",
        R"(This course beside the engine that is fastest in each of them: the time of its cheapest setting that
                 leaves no larger gap, over that engine's, and its least gap in no more than that engine's time, over
                 that engine's. Times of this machine, at the moment of the run.)",
        [=] { return at_equal_error(contests, chain_frames); });
  }
  page.text(
      R"(And what the energy of each has changed by after @ s, over what gravity could do over its reach: above zero
      an engine adds energy, below zero it takes it.)",
      chain_frames * frame);
  page.table(energy_head, energies);
  if (gaps.size() > 1)
    page.text("The largest change is @ % in this course and @ among the engines.", Value(100 * ours_most, 2),
              std::isfinite(theirs_most) ? say("@ %", Value(100 * theirs_most, 2)) : std::string("a failure"));

  const std::string ahead = ahead_of_ours(errors);
  page.text(
      R"(This course's pins open by @@. It solves the @ pins at once, in a time proportional to their number (lesson 3),
      so that what is left is the error of the step: @ substeps instead of @ leave @.)",
      in_millimetres(ours.usual()),
      ahead.empty() ? ", less than anyone else's" : say("; less is left by @", ahead), links, most_substeps,
      substeps, in_millimetres(ours.by_setting.back()));
  page.claim("the chain, this course with four substeps: largest gap", ours.usual(), "m",
             is_at_most(0.01, "a hundredth of a link: a direct solve leaves the drift of the step alone"),
             within(10, Quantity("links", links), 200));
}

}  // namespace byhand::beside
