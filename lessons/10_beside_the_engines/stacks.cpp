// Step 4 and after it: stacks that have come to their own rest, then kicked, in the plane and in space.

#include "lessons/10_beside_the_engines/field.hpp"
#include "lessons/10_beside_the_engines/steps.hpp"
#include "lessons/scenes/boxes.hpp"

namespace byhand::beside {
namespace {

constexpr int stack_frames = 600;    // 10 s
constexpr double offset = 0.02;      // of a box, to either side in turns [m]
constexpr double stack_kick = 0.02;  // of the top [m/s]
constexpr int tallest = 30;          // boxes

template <class M>
Scene<M> shifted_stack(int boxes) {
  Scene<M> scene = stack<M>(boxes);
  for (int i = 1; i <= boxes; ++i)
    scene.set_position(
        i, Linear<M>(scene.bodies().pose[i].position + (i % 2 == 0 ? offset : -offset) * Linear<M>::Unit(0)));
  return scene;
}

struct Standing {
  double fell = INFINITY;    // when nothing below holds some boxes' centre; 0: before the engine's rest [s]
  double lean = 0, sag = 0;  // of the top from the engine's own rest, at most [m]; sag < 0: it has risen
  double earlier = 0;        // the lean, a second before the end [m]
  double sunk = 0;           // of the top at that rest, from where its boxes touch [m]
  double leant() const { return std::isfinite(fell) ? INFINITY : lean; }
  bool goes_on() const { return !std::isfinite(fell) && lean > engines::equal_errors * larger(earlier, margin); }
};

/// Whether the centre of all boxes above some box lies beside that box: then no contact forces hold them.
template <class M>
bool falls(const Scene<M>& seen) {
  Linear<M> sum = Linear<M>::Zero();
  for (int i = seen.bodies().size() - 1, above = 1; i > 1; --i, ++above) {
    sum += seen.bodies().pose[i].position;
    Linear<M> aside = sum / above - seen.bodies().pose[i - 1].position;
    aside[1] = 0;
    if (!(aside.template lpNorm<Eigen::Infinity>() < 0.5)) return true;
  }
  return false;
}

template <class M>
Standing stand(const Contestant<M>& contestant, const Scene<M>& scene, double speed) {
  Standing result;
  const int top = scene.bodies().size() - 1;
  Linear<M> rest;
  engines::Start<M> start = kicked_at_rest<M>(speed);
  start.begin = [&, kick_it = start.begin](Scene<M>& seen) {
    rest = seen.bodies().pose[top].position;
    result.sunk = scene.bodies().pose[top].position.y() - rest.y();
    if (falls(seen)) result.fell = 0;
    return kick_it(seen);
  };
  engines::run_from<M>(start, contestant, scene, stack_frames, [&](const Scene<M>& seen, double time) {
    Linear<M> moved = seen.bodies().pose[top].position - rest;
    if (std::abs(moved.y()) > std::abs(result.sag)) result.sag = -moved.y();
    moved[1] = 0;
    result.lean = larger(result.lean, moved.norm());
    if (time < stack_frames * frame - 1) result.earlier = result.lean;
    if (falls(seen)) result.fell = std::min(result.fell, time);
  });
  return result;
}

long fallen_of(const std::vector<Standing>& all) {
  return std::ranges::count_if(all, [](const Standing& s) { return std::isfinite(s.fell); });
}

/// Of the scene's own start, and how far the others lean where all stand.
std::string fate_of(const std::vector<Standing>& all) {
  const Standing& own = all.front();
  const long down = fallen_of(all);
  if (down > 0) {
    const std::string of_all = down < std::ssize(all) ? say(" (of @ starts @ fall)", all.size(), down) : "";
    if (own.fell == 0) return "fell before it came to rest" + of_all;
    return (std::isfinite(own.fell) ? say("fell after @ s", Value(own.fell, 2))
                                    : say("leans @", in_millimetres(own.lean))) +
           of_all;
  }
  const auto [least, most] = std::ranges::minmax(all, {}, &Standing::lean);
  const Standing& lowest = *std::ranges::max_element(all, {}, [](const Standing& s) { return std::abs(s.sag); });
  if (std::max(most.lean, std::abs(lowest.sag)) < margin) return "moves " + in_millimetres(0);
  return say("leans @, @ @", in_words(Spread{least.lean, most.lean}, Unit::metres),
             lowest.sag < 0 ? "rises" : "sags", in_millimetres(std::abs(lowest.sag)));
}

template <class M>
void stacks_of(int boxes, const std::string& figure, Page& page) {
  struct Try {
    std::string name;
    Scene<M> scene;
    double kick;
  };
  std::vector<Try> tries;
  for (const int height : boxes == tallest ? std::vector{tallest} : std::vector{boxes, tallest}) {
    tries.push_back({say("@, offset", height), shifted_stack<M>(height), 0});
    tries.push_back({say("@, kicked", height), stack<M>(height), stack_kick});
  }
  const Field<M> field = field_of(tries.back().scene, Kind::contacts, From::home, most_of_contacts);
  std::vector<std::vector<std::string>> rows;
  std::vector<Standing> ours;
  int fallen = 0, theirs = 0, undecided = 0;
  std::vector<std::string> going_on;
  for (const Entrant<M>& entrant : field.entrants)
    for (const std::size_t row : {0, 1}) {
      rows.push_back({say("@, @", entrant.name, row_names[row])});
      std::string sunk;
      for (const Try& one : tries) {
        const Standing standing = stand(entrant.settings[row], one.scene, one.kick);
        std::vector<Standing> all{standing};
        for (int way = 0; way < ways; ++way)
          all.push_back(stand(entrant.settings[row], nudged(one.scene, way), one.kick));
        rows.back().push_back(fate_of(all));
        undecided += fallen_of(all) > 0 && fallen_of(all) < std::ssize(all);
        sunk = standing.fell > 0 ? in_millimetres(std::max(standing.sunk, 0.0)) : "–";
        if (std::ranges::any_of(all, &Standing::goes_on))
          going_on.push_back(say("@ (@, @)", entrant.name, row_names[row], one.name));
        if (entrant.name == ours_name)
          ours.insert(ours.end(), all.begin(), all.end());
        else
          ++theirs, fallen += fallen_of(all) > 0;
      }
      rows.back().push_back(sunk);
    }
  std::vector<std::string> head{""};
  for (const Try& one : tries) head.push_back(one.name);
  head.push_back(say("sunk at rest, @", tallest));
  const long down = fallen_of(ours);
  // One after the other, so that each compiler lists them in this order.
  const std::string fate_of_ours =
      page.verdict({{.when = Quantity("fallen", static_cast<double>(down)) < 1,
                     .say = "All of this course's stacks stand, as shipped and as advised, from each start."},
                    {.when = Quantity("fallen", static_cast<double>(down)) >= 1,
                     .say = say("In this course @ of @ fall.", down, ours.size())}});
  const std::string fate_of_theirs =
      theirs == 0
          ? std::string()
          : " " + page.verdict(
                      {{.when = Quantity("fallen", fallen) >= 1,
                        .say =
                            say("Of the engines' @ stacks in this table @ fall within @ s from some start or all.",
                                theirs, fallen, stack_frames * frame)},
                       {.when = Quantity("fallen", fallen) < 1,
                        .say = say("Of the engines' @ stacks in this table none falls within @ s.", theirs,
                                   stack_frames * frame)}});
  const std::string hanging =
      undecided == 0 ? "" : say(" In @ of the table these starts decide.", several(undecided, "cell", "cells"));
  double most = 0;
  for (const Standing& one : ours) most = std::max({most, one.lean, std::abs(one.sag)});
  if (alone() && down == 0) {
    page.text("@ Their tops move by @.", fate_of_ours,
              most < margin ? "less than a micrometre" : say("@ at most", in_millimetres(most)));
  } else {
    page.table(head, rows);
    page.text("Each of these is run from @ more starts, with each box up to 1 µm aside. @@@@", ways, fate_of_ours,
              fate_of_theirs, hanging,
              going_on.empty()
                  ? ""
                  : say(" In the last second these still lean further than before, from some start: @.",
                        listed(going_on)));
  }

  const auto outcomes =
      outcomes_of(field, [&](const auto& who) { return stand(who, tries.back().scene, stack_kick); });
  auto leans = errors_of(outcomes, &Standing::leant);
  add_spreads(
      field, [&](int way) { return nudged(tries.back().scene, way); }, leans,
      [](const auto& who, const auto& start) { return stand(who, start, stack_kick).leant(); });
  if (!alone()) {
    page.text(
        R"(How far the kicked stack of 30 leans at most, with the settings of step 1 of up to @ iterations a frame. A rigid column
        would rock on its edge by v²H/3gw = @; what leans less has lost energy on its way. Both rows, and what is near the best, are run
        from @ more starts, with each box up to 1 µm aside.)",
        most_of_contacts, in_millimetres(stack_kick * stack_kick * tallest / (3 * gravity)), ways);
    page.table(head_of_three_rows, three_rows<M>(field, leans, Unit::metres));
    page.text("@", judged(page, field, leans, Unit::metres, "lean"));
    constexpr int soon = 120;  // frames
    const double mean = passes_a_frame(tries.back().scene, stack_kick, stack_frames);
    const Quantity at_first("passes a frame at first", passes_a_frame(tries.back().scene, stack_kick, soon)),
        later("1.1 × the mean", engines::equal_times * mean);
    page.text(
        "The chart has the mean of @ s. @", stack_frames * frame,
        page.verdict(
            {{.when = at_first > later,
              .say =
                  say("In the first @ s after the kick this course, as shipped and from one start, goes over its "
                      "contacts @ times as often.",
                      soon * frame, Value(at_first.value / mean, 2))},
             {.when = at_first <= later,
              .say = "This course, as shipped and from one start, goes over its contacts no more often soon after "
                     "the "
                     "kick."}}));
  }
  compare_by_time(page, figure,
                  "The kicked stack of 30: how far its top leans within 10 s, and the mean time of their frames.",
                  leans, [=, scene = tries.back().scene] {
                    const Timed<M> timed{scene, stack_frames, kicked_at_rest<M>(stack_kick), "from one start, "};
                    return against_time(field, leans, timed, "lean");
                  });
  double leant = 0;
  for (const Standing& one : ours) leant = larger(leant, one.leant());
  page.claim(say("this course: largest lean of @ runs of stacks within 10 s", ours.size()), leant, "m",
             is_at_most(0.5, "a top over its base: it stands"));
}

}  // namespace

void stacks(const Setting& setting, Page& page) {
  const int boxes = setting.boxes;
  page.text(
      R"(A stack stands only if its contacts carry its weight *and* its bending, which takes more warm sweeps the
      higher it is (lesson 5). Here @ unit boxes at x = 0: one with each box @ cm off to alternate sides, one
      straight. Each engine has @ s to settle, with whatever overlap it keeps. From there the
      straight ones are kicked, by @ m/s at the top and in proportion to the height below, and all are watched for @ s. *Lean* is how far the
      top moves sideways from that rest position at most; *sag*, how far down. A stack
      has fallen when the common centre of the boxes above some box is no longer over that box.)",
      boxes == tallest ? say("are two stacks of @", tallest)
                       : say("are two stacks of @ and two of @", boxes, tallest),
      100 * offset, settling * frame, stack_kick, stack_frames * frame);
  const double needed = 0.75 * gravity * frame * frame * 30 * 30 * 30;
  const double needed_by_ten = needed / 27, whole = std::ceil(needed);
  page.predict(
      {.ask = say(R"(In steps of 1/60 s a stack of 10 needs @ warm sweeps a step, by lesson 5's estimate. How many
                does a stack of 30 need?)",
                  Value(needed_by_ten, 3)),
       .answer = whole,
       .unit = "1",
       .tolerance = 0.03 * whole,
       .wrong = {{3 * needed_by_ten,
                  "A stack three times as high tips more slowly, but a sweep removes far less of its bending."},
                 {9 * needed_by_ten, "N² is the law of chains, which are stretched. A stack bends."}},
       .hints = {"How do the sweeps that a stack needs grow with its height?", "They grow as N³: ¾ g h² N³.",
                 say("3³ · @ = …", Value(needed_by_ten, 4))},
       .right =
           say("The estimate grows as N³, 27 times: ¾ · 9.81/3600 · 27000 = @, rounded up.", Value(needed, 3))});
  stacks_of<PlaneBody>(boxes, "stack_clocked", page);
}

void stacks_in_space(const Setting& setting, Page& page) {
  page.text(
      R"(The same stacks in space, for the engines that know it: four contacts a face, friction in its plane,
      and nothing that keeps a box in a plane.)");
  stacks_of<SpaceBody>(setting.boxes, "space_stack_clocked", page);
}

}  // namespace byhand::beside
