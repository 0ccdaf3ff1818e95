// Step 3: a level chain with a load at its end, and a tree.

#include <cmath>

#include "lessons/10_beside_the_engines/field.hpp"
#include "lessons/10_beside_the_engines/steps.hpp"
#include "lessons/scenes/branches.hpp"
#include "lessons/scenes/chain.hpp"

namespace byhand::beside {
namespace {

using namespace tutor;
using namespace renderer;
using M = PlaneBody;

constexpr int chain_frames = 60, most_at_once = 60;
constexpr int substeps = 4, most_substeps = 16;
constexpr double level = 1.57079632679489661923;

/// The largest gap of a pin in a second; infinite once the chain has flown apart by more than its link [m].
double gap(const Contestant<M>& contestant, const Scene<M>& scene) {
  double most = 0;
  engines::run<M>(contestant, scene, chain_frames,
                  [&](const Scene<M>& seen, double) { most = larger(most, position_error(seen).max); });
  return most < 1 ? most : INFINITY;
}

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
    page.choose(
        {.ask = "Those that iterate, with their defaults: what is the least gap that any of them leaves?",
         .options = {{"less than 1 mm", reply}, {"1 mm to 10 cm", reply}, {"more than 10 cm", reply}},
         .answer = iterative < 1e-3   ? 0
                   : iterative <= 0.1 ? 1
                                      : 2,
         .hints = {"How far does news of the load come up the chain in one frame?",
                   "One sweep moves it by a link or two; a warm start goes on in the next frame.",
                   say("@ links, and the heaviest weighs @ times the others.", links, Value(end_mass, 3))}});
  }
  page.figure("chain_gap",
              say("The chain of @ with @ kg at its end: largest gap of a pin in @ s.", links, end_mass,
                  chain_frames * frame),
              compared(errors, "largest gap (m)"));
  page.clocked("chain_clocked",
               R"(Gap and time of the same chain. Times of this machine, at the moment of the run.)",
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

  std::vector<std::vector<std::string>> rows;
  const std::vector<std::pair<std::string, Scene<M>>> others{{"chain of 10", chain_of(10, end_mass)},
                                                             {"chain of 200", chain_of(200, end_mass)},
                                                             {"tree of 255", tree(8)}};
  for (const Entrant<M>& entrant : field(most_at_once + 1, 1)) {
    std::vector<std::string> row{entrant.name};
    for (const auto& [name, other] : others) row.push_back(in_millimetres(gap(entrant.settings.front(), other)));
    rows.push_back(row);
  }
  page.text(
      "By default, in two more chains with that end and in a tree of 255 links of 1 kg (ODE's direct mode would "
      "take "
      "a second a frame for 200 links, and is left out):");
  page.table({"largest gap", others[0].first, others[1].first, others[2].first}, rows);

  const double ours = errors.front().usual();
  const std::string ahead = ahead_of_ours(errors);
  page.text(
      R"(This course's pins open by @@. It solves the @ pins at once, in a time proportional to their number (lesson 3),
      so that what is left is the error of the step: @ substeps instead of @ leave @.)",
      in_millimetres(ours), ahead.empty() ? ", less than anyone else's" : say("; less is left by @", ahead), links,
      most_substeps, substeps, in_millimetres(errors.front().by_setting.back()));
  page.claim({.quantity = "the chain, this course with four substeps: largest gap",
              .unit = "m",
              .expected = 0.01,
              .source = "a hundredth of a link: a direct solve leaves the drift of the step alone",
              .measured = ours,
              .tolerance = at_most(),
              .claimed = links >= 10 && links <= 200,
              .range = "10 to 200 links"});
}

}  // namespace byhand::beside
