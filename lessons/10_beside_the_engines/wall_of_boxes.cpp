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

/// Errors of one contestant, by its default.
template <class M>
std::vector<std::string> row_of(const Entrant<M>& entrant, int base, int frames, std::vector<Wall>& walls) {
  std::vector<std::string> row{entrant.name};
  for (const bool kicked : {false, true}) {
    const Wall end = end_of(entrant.settings.front(), wall<M>(base, kicked), frames);
    row.push_back(in_millimetres(end.moved));
    row.push_back(in_millimetres(end.overlap));
    walls.push_back(end);
  }
  return row;
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
  const auto field = entrants<M>(1, 1, [](const Engine& engine) { return !engine.knob.empty(); });
  std::vector<std::vector<std::string>> rows;
  std::vector<Wall> walls;
  std::vector<Errors> errors, kicks;
  for (const Entrant<M>& entrant : field) {
    rows.push_back(row_of(entrant, base, frames, walls));
    errors.push_back({entrant.name, {walls[walls.size() - 2].moved}});
    kicks.push_back({entrant.name, {walls.back().moved}});
  }
  page.table(head, rows);
  const Wall &rest = walls[0], &kicked = walls[1];
  const std::string ahead = ahead_of_ours(errors);
  page.text(
      R"(In this course the wall ends @ from where it stood, and @ after the kick, with overlaps of @. @ Its loops are
      solved by conjugate sweeps that stop when they have converged: many in the first steps, which have no λ to begin
      with, one in a step that finds it right.)",
      in_millimetres(rest.moved), in_millimetres(kicked.moved), in_millimetres(rest.overlap),
      ahead.empty() ? field.size() > 1 ? std::string("No engine here moves less by default.") : std::string()
                    : say("Less by default: @.", ahead));
  if (field.size() > 1) {
    page.figure("wall_moved", say("@ boxes from rest: how far a box has come after @ s.", boxes, frames * frame),
                compared(errors, "moved (m)"));
  }
  for (const bool after_a_kick : {false, true})
    page.clocked(
        after_a_kick ? "wall_kicked_clocked" : "wall_clocked",
        say(R"(The wall @, by default: how far a box has come, and the mean time of a frame, the first steps
                 included. Times of this machine, at the moment of the run.)",
            after_a_kick ? "after the kick" : "from rest"),
        [=, moved = after_a_kick ? kicks : errors] {
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
  const auto field =
      entrants<M>(1, 1, [](const Engine& engine) { return engine.in_space && !engine.knob.empty(); });
  page.text(
      R"(The same @ boxes with a third axis: four contacts a face, two rows of friction for each, and nothing that keeps
      the wall in its plane. @ After @ s:)",
      base * (base + 1) / 2,
      field.size() > 1 ? "Engines that know the plane alone are left out." : "No engine is here that knows space.",
      frames * frame);
  std::vector<std::vector<std::string>> rows;
  std::vector<Wall> walls;
  std::vector<Errors> errors;
  for (const Entrant<M>& entrant : field) {
    rows.push_back(row_of(entrant, base, frames, walls));
    errors.push_back({entrant.name, {walls[walls.size() - 2].moved}});
  }
  page.table(head, rows);
  page.clocked("space_wall_clocked",
               R"(The wall in space from rest, by default. Times of this machine, at the moment of the run.)",
               [=] { return against_time(field, errors, wall<M>(base, false), frames, "moved (m)"); });
  const std::string ahead = ahead_of_ours(errors);
  page.text(
      R"(The course's solver leaves the wall @ from where it stood@. It pays for it in sweeps: four contacts on a face
      are one more than a plane needs (lesson 8), so that rows depend on each other and sweeps converge slowly. An engine
      that stops after ten iterations has its error instead.)",
      in_millimetres(walls[0].moved), ahead.empty() ? "" : say("; less is left by @", ahead));
  page.claim({.quantity = "this course, the wall in space: moved",
              .unit = "m",
              .expected = slop * base,
              .source = "it stands: at most an overlap of 1 mm for each row",
              .measured = walls[0].moved,
              .tolerance = at_most()});
}

}  // namespace byhand::beside
