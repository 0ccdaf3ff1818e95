// Step 6 and after it: the pyramid, in the plane and in space, from rest and after a kick.

#include "lessons/10_beside_the_engines/field.hpp"
#include "lessons/10_beside_the_engines/steps.hpp"
#include "lessons/scenes/boxes.hpp"

namespace byhand::beside {
namespace {

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

/// The course's solver with at most 50, 20 and 10 sweeps a step, and the engines with their defaults; `twice`:
/// also with twice as many iterations or steps.
template <class M>
std::vector<Entrant<M>> walls_of(bool twice) {
  auto field = entrants<M>(1, twice ? 2 : 1, [](const Engine& engine) {
    return !engine.knob.empty() && (M::linear == 2 || engine.in_space != nullptr);
  });
  std::vector<Contestant<M>>& ours = field.front().settings;
  ours.clear();
  for (const int most_sweeps : {50, 20, 10}) {
    ours.push_back(engines::ours<M>(ours_name, best_method(1, most_sweeps)));
    ours.back().setting = say("@ sweeps", most_sweeps);
    ours.back().effort = most_sweeps;
  }
  return field;
}

/// What has come of a wall with every contestant.
struct Outcome {
  std::vector<Errors> moved;
  std::vector<Wall> usual;  // by default
};

template <class M>
Outcome outcome(const std::vector<Entrant<M>>& field, const Scene<M>& scene, int frames) {
  Outcome result;
  for (const Entrant<M>& entrant : field) {
    Errors errors{entrant.name, {}};
    for (const Contestant<M>& contestant : entrant.settings) {
      const Wall end = end_of(contestant, scene, frames);
      if (errors.by_setting.empty()) result.usual.push_back(end);
      errors.by_setting.push_back(end.moved);
    }
    result.moved.push_back(std::move(errors));
  }
  return result;
}

std::vector<std::vector<std::string>> table_of(const Outcome& rest, const Outcome& kicked) {
  std::vector<std::vector<std::string>> rows;
  for (std::size_t i = 0; i < rest.usual.size(); ++i)
    rows.push_back({rest.moved[i].name, in_millimetres(rest.usual[i].moved), in_millimetres(rest.usual[i].overlap),
                    in_millimetres(kicked.usual[i].moved), in_millimetres(kicked.usual[i].overlap)});
  return rows;
}

/// With how many sweeps this course has no more error than any engine has by default.
template <class M>
std::string enough(const std::vector<Entrant<M>>& field, const std::vector<Errors>& moved) {
  double least = INFINITY;
  for (std::size_t i = 1; i < moved.size(); ++i) least = std::min(least, moved[i].usual());
  return reached_with(field.front(), moved.front(), least);
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
  const auto field = walls_of<M>(true), kicked_field = walls_of<M>(false);
  const Outcome at_rest = outcome(field, wall<M>(base, false), frames),
                after_kick = outcome(kicked_field, wall<M>(base, true), frames);
  page.table(head, table_of(at_rest, after_kick));
  const auto sweeps = first_and_last_sweeps(wall<M>(base, false), frames);
  const Wall &rest = at_rest.usual.front(), &kicked = after_kick.usual.front();
  const std::string ahead = ahead_of_ours(at_rest.moved);
  page.text(
      R"(In this course the wall ends @ from where it stood, and @ after the kick, with overlaps of @. @ Its loops are
      solved by conjugate sweeps that stop when they have converged, or at 50: from rest the first step, which has no λ to
      begin with, takes @, the last @.)",
      in_millimetres(rest.moved), in_millimetres(kicked.moved), in_millimetres(rest.overlap),
      ahead.empty() ? field.size() > 1 ? std::string("No engine here moves less by default.") : std::string()
                    : say("Less by default: @.", ahead),
      sweeps.first, sweeps.second);
  if (field.size() > 1) {
    page.text(
        R"(How many sweeps a step does it take for no more error than any engine has by default? From rest @, after
        the kick @.)",
        enough(field, at_rest.moved), enough(kicked_field, after_kick.moved));
    page.figure("wall_moved", say("@ boxes from rest: how far a box has come after @ s.", boxes, frames * frame),
                compared(at_rest.moved, "moved (m)"));
  }
  page.clocked(
      "wall_clocked",
      R"(The wall from rest: how far a box has come, and the mean time of a frame, the first steps included; this course
      also with at most 20 and 10 sweeps, the engines also with twice as many iterations or steps. Times of this machine,
      at the moment of the run.)",
      [=, moved = at_rest.moved] {
        return against_time(field, moved, wall<M>(base, false), frames, "moved (m)");
      });
  page.clocked(
      "wall_kicked_clocked",
      R"(The wall after the kick, the engines by default. Times of this machine, at the moment of the run.)",
      [=, moved = after_kick.moved] {
        return against_time(kicked_field, moved, wall<M>(base, true), frames, "moved (m)");
      });
  for (const bool after_a_kick : {false, true}) {
    const Wall& end = after_a_kick ? kicked : rest;
    page.claim(after_a_kick ? "this course, the wall after a kick: moved" : "this course, the wall: moved",
               end.moved, "m", is_at_most(slop * base, "it stands: at most an overlap of 1 mm for each row"));
  }
}

void wall_in_space(const Setting& setting, Page& page) {
  using M = SpaceBody;
  constexpr int frames = 60;
  const int base = setting.base;
  const auto field = walls_of<M>(false);
  page.text(
      R"(The same @ boxes with a third axis: four contacts a face, two rows of friction for each, and nothing that keeps
      the wall in its plane. @ After @ s:)",
      base * (base + 1) / 2,
      field.size() > 1 ? "Engines that know the plane alone are left out." : "No engine is here that knows space.",
      frames * frame);
  const Outcome rest = outcome(field, wall<M>(base, false), frames),
                kicked = outcome(field, wall<M>(base, true), frames);
  page.table(head, table_of(rest, kicked));
  page.clocked(
      "space_wall_clocked",
      R"(The wall in space from rest; this course also with at most 20 and 10 sweeps. Times of this machine, at the
               moment of the run.)",
      [=, moved = rest.moved] { return against_time(field, moved, wall<M>(base, false), frames, "moved (m)"); });
  const std::string ahead = ahead_of_ours(rest.moved);
  const auto sweeps = first_and_last_sweeps(wall<M>(base, false), frames);
  const double moved = rest.usual.front().moved;
  page.text(
      R"(The course's solver leaves the wall @ from where it stood@. Four contacts on a face are one more than a plane
      needs, so that their rows depend on each other (lesson 8) and sweeps converge slowly: the first step takes @ of them
      and the last @, where 50 are allowed.@)",
      in_millimetres(moved), ahead.empty() ? "" : say("; less is left by @", ahead), sweeps.first, sweeps.second,
      field.size() > 1
          ? say(" For no more error than any engine has by default it takes @.", enough(field, rest.moved))
          : std::string());
  page.claim("this course, the wall in space: moved", moved, "m",
             is_at_most(slop * base, "it stands: at most an overlap of 1 mm for each row"));
}

}  // namespace byhand::beside
