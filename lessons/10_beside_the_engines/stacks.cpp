// Step 4: stacks with offsets, from rest and after a kick: until when they stand.

#include "lessons/10_beside_the_engines/field.hpp"
#include "lessons/10_beside_the_engines/steps.hpp"
#include "lessons/scenes/boxes.hpp"

namespace byhand::beside {
namespace {

using M = PlaneBody;

constexpr int stack_frames = 600;    // 10 s
constexpr double offset = 0.02;      // of a box, to either side in turns [m]
constexpr double stack_kick = 0.02;  // of the top [m/s]

Scene<M> shifted_stack(int boxes) {
  Scene<M> scene = stack(boxes);
  for (int i = 1; i <= boxes; ++i)
    scene.set_position(i, scene.bodies().pose[i].position + Linear<M>(i % 2 == 0 ? offset : -offset, 0));
  return scene;
}
Scene<M> kicked_stack(int boxes) {
  Scene<M> scene = stack(boxes);
  kick(scene, stack_kick);
  return scene;
}

struct Standing {
  double fell = INFINITY;  // when the top is off by half a box [s]
  double shift = 0;        // of the top at the end [m]
};

Standing stand(const Contestant<M>& contestant, const Scene<M>& scene) {
  Standing result;
  const int top = scene.bodies().size() - 1;
  engines::run<M>(contestant, scene, stack_frames, [&](const Scene<M>& seen, double time) {
    result.shift = (seen.bodies().pose[top].position - scene.bodies().pose[top].position).norm();
    if (!(result.shift < 0.5)) result.fell = std::min(result.fell, time);
  });
  return result;
}

std::string told(const Standing& standing) {
  return std::isfinite(standing.fell) ? say("fell at @ s", Value(standing.fell, 2))
                                      : say("stands, off by @", in_millimetres(standing.shift));
}

}  // namespace

void stacks(const Setting& setting, Page& page) {
  const int boxes = setting.boxes;
  page.text(
      R"(A stack stands only if its contacts carry its weight *and* its bending, which takes ¾gh²N³ warm sweeps a step
      (lesson 5). Stacks of @ and of 30 unit boxes: each box @ cm off to either side in turns, and straight with a kick of
      @ m/s at the top. A stack has fallen when its top is off by half a box; the others are watched for @ s.)",
      boxes, 100 * offset, stack_kick, stack_frames * frame);
  const double needed = 0.75 * gravity * frame * frame * 30 * 30 * 30;
  page.predict({.ask = "A stack of 30, steps of 1/60 s: how many warm sweeps does lesson 5's law ask for?",
                .answer = needed,
                .unit = "1",
                .tolerance = 0.03 * needed,
                .hints = {"The law is in the text above.", "¾ g h² N³", "¾ · 9.81 · (1/60)² · 30³"},
                .right = say("¾ · 9.81/3600 · 27000 = @.", Value(needed, 3))});

  const auto field = entrants<M>(1, 1, [](const Engine& engine) { return !engine.knob.empty(); });
  const std::vector<std::pair<std::string, Scene<M>>> scenes{{say("@, offset", boxes), shifted_stack(boxes)},
                                                             {say("@, kicked", boxes), kicked_stack(boxes)},
                                                             {"30, offset", shifted_stack(30)},
                                                             {"30, kicked", kicked_stack(30)}};
  std::vector<std::vector<std::string>> rows;
  std::vector<Standing> ours;
  int fallen = 0, theirs = 0, stand_too = 0;
  for (const Entrant<M>& entrant : field) {
    std::vector<std::string> row{entrant.name};
    bool all_stand = true;
    for (const auto& [name, scene] : scenes) {
      const Standing standing = stand(entrant.settings.front(), scene);
      row.push_back(told(standing));
      if (entrant.name == ours_name) {
        ours.push_back(standing);
      } else {
        ++theirs;
        fallen += std::isfinite(standing.fell);
        all_stand = all_stand && !std::isfinite(standing.fell);
      }
    }
    if (entrant.name != ours_name && all_stand) ++stand_too;
    rows.push_back(row);
  }
  page.table({"", scenes[0].first, scenes[1].first, scenes[2].first, scenes[3].first}, rows);
  const bool all_ours =
      std::all_of(ours.begin(), ours.end(), [](const Standing& s) { return std::isinf(s.fell); });
  page.text(R"(@ this course@: a column has no loops, so that it is solved directly, bending included.@)",
            all_ours ? "All four stand in" : "Not all four stand in", all_ours ? "" : ", although",
            theirs == 0
                ? std::string()
                : say(R"( Of the @ runs of the engines by default @ ended in a fall. Engines put a resting stack to
                        sleep after half a second, which hides this in a game and not here.)",
                      theirs, fallen));

  const auto more = entrants<M>(1, 8, [](const Engine& engine) { return !engine.knob.empty(); });
  const Scene<M> tall = kicked_stack(30);
  const std::vector<Errors> shifts = errors_of(more, [&](const auto& who) {
    const Standing standing = stand(who, tall);
    return std::isfinite(standing.fell) ? INFINITY : standing.shift;
  });
  std::vector<std::vector<std::string>> efforts;
  for (std::size_t i = 1; i < more.size(); ++i) {
    std::string first = "none of them";
    for (std::size_t j = more[i].settings.size(); j-- > 0;)
      if (std::isfinite(shifts[i].by_setting[j])) first = more[i].settings[j].setting;
    efforts.push_back({more[i].name, first, in_millimetres(shifts[i].least())});
  }
  if (!efforts.empty()) {
    page.text(
        R"(The kicked stack of 30 once more, with 2, 4 and 8 times as many iterations or steps: the first setting with
        which it stands, and how far off its top is with the best.)");
    page.table({"engine", "stands with", "top off by, at best"}, efforts);
  }
  page.clocked(
      "stack_clocked",
      R"(The kicked stack of 30: how far its top is off after 10 s, and the processor time of a frame; an engine takes
      more iterations or steps along its curve. Times of this machine, at the moment of the run.)",
      [=] { return against_time(more, shifts, tall, 60, "top off by (m)"); });
  for (std::size_t i = 0; i < scenes.size(); ++i)
    page.claim("this course, stack of " + scenes[i].first + ": top is off after 10 s", ours[i].shift, "m",
               is_at_most(0.5, "its middle is over its base, so it stands"));
}

}  // namespace byhand::beside
