// Step 6 and after it: the pyramid, in the plane and in space, from rest and after a kick.

#include "lessons/10_beside_the_engines/field.hpp"
#include "lessons/10_beside_the_engines/steps.hpp"
#include "lessons/scenes/boxes.hpp"

namespace byhand::beside {
namespace {

using namespace tutor;

constexpr double wall_kick = 0.02, slop = 0.001, slop_of_box2d = 0.005;  // [m/s], [m], [m]

template <class M>
Scene<M> wall(int base, bool kicked) {
  Scene<M> scene = pyramid<M>(base);
  if (kicked) kick(scene, wall_kick);
  return scene;
}

struct Wall {
  double moved = 0, overlap = 0;  // at the end [m]
};

template <class M>
Wall end_of(const Contestant<M>& contestant, const Scene<M>& scene, int frames) {
  Wall result;
  Scene<M> last = scene;
  engines::run<M>(contestant, scene, frames, [&](const Scene<M>& seen, double) { last.state() = seen.bodies(); });
  return {farthest(scene, last), deepest_overlap(last)};
}

/// The course's solver with at most 50, 20 and 10 sweeps a step, and the engines with their defaults.
template <class M>
std::vector<Entrant<M>> walls_of() {
  auto field = entrants<M>(1, 1, [](const Engine& engine) {
    return !engine.knob.empty() && (M::linear == 2 || engine.in_space != nullptr);
  });
  for (const int most_sweeps : {20, 10})
    field.front().settings.push_back(engines::ours<M>(ours_name, best_method(1, most_sweeps)));
  return field;
}

/// What has come of the wall with every contestant, from rest and kicked.
struct Outcome {
  std::vector<std::vector<std::string>> table;
  std::vector<Errors> moved[2];
  Wall ours[2];
};

template <class M>
Outcome outcome(const std::vector<Entrant<M>>& field, int base, int frames) {
  Outcome result;
  for (const Entrant<M>& entrant : field) {
    result.table.push_back({entrant.name});
    for (const bool kicked : {false, true}) {
      const Scene<M> scene = wall<M>(base, kicked);
      Errors errors{entrant.name, {}};
      for (const Contestant<M>& contestant : entrant.settings) {
        const Wall end = end_of(contestant, scene, frames);
        errors.by_setting.push_back(end.moved);
        if (errors.by_setting.size() > 1) continue;
        result.table.back().push_back(in_millimetres(end.moved));
        result.table.back().push_back(in_millimetres(end.overlap));
        if (entrant.name == ours_name) result.ours[kicked] = end;
      }
      result.moved[kicked].push_back(errors);
    }
  }
  return result;
}

const std::vector<std::string> head{"", "moved, from rest", "deepest overlap", "moved, kicked", "deepest overlap"};

}  // namespace

void wall_of_boxes(const Setting& setting, Page& page) {
  using M = PlaneBody;
  constexpr int frames = 300;  // 5 s
  const int base = setting.base, boxes = base * (base + 1) / 2;
  page.text(
      R"(A wall of @ boxes that narrows upwards, a tenth of a box apart in each row: from rest, where each box begins at
      its place but without a force that holds it, and with a kick of @ m/s at the top. The right motion is none. The
      error is how far the box has come after @ s that has come farthest.)",
      boxes, wall_kick, frames * frame);
  page.predict(
      {.ask = say(R"(Box2D leaves an overlap of up to 5 mm at each contact, this course 1 mm. By how many
                          millimetres may the top of a pyramid of @ rows sink in Box2D, for that alone?)",
                  base),
       .answer = 1000 * slop_of_box2d * base,
       .unit = "mm",
       .tolerance = 0.5,
       .wrong = {{1000 * slop * base, "That is this course's overlap."}},
       .hints = {"How many contacts are between the top and the ground?", "rows × overlap", say("@ × 5 mm", base)},
       .right = say("@ contacts lie below the top, each with up to 5 mm.", base)});
  const auto field = walls_of<M>();
  const Outcome all = outcome(field, base, frames);
  page.table(head, all.table);
  const auto sweeps = first_and_last_sweeps(wall<M>(base, false), frames);
  const Wall &rest = all.ours[0], &kicked = all.ours[1];
  const std::string ahead = ahead_of_ours(all.moved[0]);
  page.text(
      R"(In this course the wall ends @ from where it stood, and @ after the kick, with overlaps of @. @ Its loops are
      solved by conjugate sweeps that stop when they have converged, or at 50: from rest the first step, which has no λ to
      begin with, takes @, the last @.)",
      in_millimetres(rest.moved), in_millimetres(kicked.moved), in_millimetres(rest.overlap),
      ahead.empty() ? field.size() > 1 ? std::string("No engine here moves less by default.") : std::string()
                    : say("Less by default: @.", ahead),
      sweeps.first, sweeps.second);
  if (field.size() > 1) {
    page.figure("wall_moved", say("@ boxes from rest: how far a box has come after @ s.", boxes, frames * frame),
                compared(all.moved[0], "moved (m)"));
  }
  for (const bool after_a_kick : {false, true})
    page.clocked(
        after_a_kick ? "wall_kicked_clocked" : "wall_clocked",
        say(R"(The wall @: how far a box has come, and the mean time of a frame, the first steps included; this course
            also with at most 20 and 10 sweeps. Times of this machine, at the moment of the run.)",
            after_a_kick ? "after the kick" : "from rest"),
        [=, moved = all.moved[after_a_kick]] {
          return against_time(field, moved, wall<M>(base, after_a_kick), frames, "moved (m)");
        });
  for (const bool after_a_kick : {false, true}) {
    const Wall& end = after_a_kick ? kicked : rest;
    page.claim(
        {.quantity = after_a_kick ? "this course, the wall after a kick: moved" : "this course, the wall: moved",
         .unit = "m",
         .expected = slop * base,
         .source = "it stands: at most an overlap of 1 mm for each row",
         .measured = end.moved,
         .tolerance = at_most()});
  }
}

void wall_in_space(const Setting& setting, Page& page) {
  using M = SpaceBody;
  constexpr int frames = 60;
  const int base = setting.base;
  const auto field = walls_of<M>();
  page.text(
      R"(The same @ boxes with a third axis: four contacts a face, two rows of friction for each, and nothing that keeps
      the wall in its plane. @ After @ s:)",
      base * (base + 1) / 2,
      field.size() > 1 ? "Engines that know the plane alone are left out." : "No engine is here that knows space.",
      frames * frame);
  const Outcome all = outcome(field, base, frames);
  page.table(head, all.table);
  page.clocked(
      "space_wall_clocked",
      R"(The wall in space from rest; this course also with at most 20 and 10 sweeps. Times of this machine, at the
               moment of the run.)",
      [=, moved = all.moved[0]] { return against_time(field, moved, wall<M>(base, false), frames, "moved (m)"); });
  const std::string ahead = ahead_of_ours(all.moved[0]);
  const auto sweeps = first_and_last_sweeps(wall<M>(base, false), frames);
  page.text(
      R"(The course's solver leaves the wall @ from where it stood@. Four contacts on a face are one more than a plane
      needs, so that their rows depend on each other (lesson 8) and sweeps converge slowly: the first step takes @ of them,
      the last @, of at most 50.)",
      in_millimetres(all.ours[0].moved), ahead.empty() ? "" : say("; less is left by @", ahead), sweeps.first,
      sweeps.second);
  page.claim({.quantity = "this course, the wall in space: moved",
              .unit = "m",
              .expected = slop * base,
              .source = "it stands: at most an overlap of 1 mm for each row",
              .measured = all.ours[0].moved,
              .tolerance = at_most()});
}

}  // namespace byhand::beside
