// Step 6 and after it: the pyramid, in the plane and in space, from each engine's own rest and after a kick.

#include "lessons/10_beside_the_engines/field.hpp"
#include "lessons/10_beside_the_engines/steps.hpp"
#include "lessons/scenes/boxes.hpp"

namespace byhand::beside {
namespace {

constexpr int wall_frames = 300, soon = 40;  // 5 s, ⅔ s from rest on
constexpr double wall_kick = 0.02;           // [m/s]
constexpr double stands_within = 0.02;       // where a box stands: a fiftieth of it [m]

/// The largest sideways displacement of any box from its engine's rest, and down, at any time; how deep two
/// overlap at the end [m]; the speed of the fastest at that rest, before a kick [m/s].
struct Wall {
  double moved = 0, sagged = 0, overlap = 0, speed = 0;
};

template <class M>
Wall watched(const Contestant<M>& contestant, const Scene<M>& scene, double speed) {
  Wall result;
  Scene<M> rest = scene;
  engines::Start<M> start = kicked_at_rest<M>(speed);
  start.begin = [&, kick_it = start.begin](Scene<M>& seen) {
    rest.state() = seen.bodies();
    return kick_it(seen);
  };
  engines::run_from<M>(start, contestant, scene, wall_frames, [&](const Scene<M>& seen, double time) {
    for (int i = 0; i < scene.bodies().size(); ++i) {
      Linear<M> moved = seen.bodies().pose[i].position - rest.bodies().pose[i].position;
      result.sagged = larger(result.sagged, -moved[1]);
      moved[1] = 0;
      result.moved = larger(result.moved, moved.norm());
    }
    if (time < 1.5 * frame) result.speed = largest_displacement(rest, seen) / frame;
    if (time > (wall_frames - 0.5) * frame) result.overlap = deepest_overlap(seen);
  });
  return result;
}

/// Which engines have less than the course as advised, in each column of the table.
template <class M>
std::string least_as_advised(Page& page, const Field<M>& field,
                             const std::vector<std::pair<Wall, Wall>>& advised) {
  using Rows = std::pair<Wall, Wall>;
  const std::pair<const char*, std::function<double(const Rows&)>> columns[] = {
      {"moved sideways", [](const Rows& r) { return r.first.moved; }},
      {"sagged", [](const Rows& r) { return r.first.sagged; }},
      {"overlap at the end", [](const Rows& r) { return r.first.overlap; }},
      {"kicked, sideways", [](const Rows& r) { return r.second.moved; }},
      {"kicked, sagged", [](const Rows& r) { return r.second.sagged; }}};
  std::string words;
  int columns_with = 0;
  for (const auto& [name, column] : columns) {
    std::vector<std::string> ahead;
    for (std::size_t i = 1; i < advised.size(); ++i)
      if (engines::equal_errors * told(column(advised[i])) < told(column(advised[0])))
        ahead.push_back(field.entrants[i].name);
    if (ahead.empty()) continue;
    ++columns_with;
    words += say("@@ (@)", words.empty() ? "" : "; ", name, listed(ahead));
  }
  const Quantity columns_ahead("columns in which an engine has less", columns_with);
  return page.verdict(
      {{.when = columns_ahead < 1,
        .say =
            "In this table, which is of one start, no engine as advised has less than this course in any column."},
       {.when = columns_ahead >= 1,
        .say = say("In this table, which is of one start, less than this course as advised has: @.", words)}});
}

/// Who has a box that still moves after settling, and how fast it is.
template <class M>
std::string restless_in_words(const Field<M>& field, const std::vector<Outcomes<Wall>>& still) {
  constexpr double at_rest = 1e-4;  // [m/s]
  std::vector<std::string> names;
  for (std::size_t i = 0; i < still.size(); ++i)
    for (const std::size_t row : {0, 1})
      if (const double speed = still[i].by_setting[row].speed; speed > at_rest)
        names.push_back(say("@ (@, @ mm/s)", field.entrants[i].name, row_names[row], Value(1000 * speed, 2)));
  return names.empty() ? say("After these @ s no box is faster than @ mm/s.", settling * frame, 1000 * at_rest)
                       : say("After these @ s some box is still faster than @ mm/s: @.", settling * frame,
                             1000 * at_rest, listed(names));
}

/// The sideways displacements from rest, from the starts nearby, too.
template <class M>
std::vector<Errors> with_spreads(const Field<M>& field, const Scene<M>& scene,
                                 const std::vector<Outcomes<Wall>>& still) {
  auto moved = errors_of(still, &Wall::moved);
  add_spreads(
      field, [&](int way) { return nudged(scene, way); }, moved,
      [](const auto& who, const auto& start) { return watched(who, start, 0).moved; });
  return moved;
}

/// What is tried of piles in space is limited for time. This course and whoever errs least of the others within
/// the limit are compared beyond it.
template <class M>
void tell_beyond_the_limit(Page& page, const Field<M>& field, const Scene<M>& scene,
                           const std::vector<Errors>& within) {
  const auto next = std::min_element(within.begin() + 1, within.end(), [](const Errors& a, const Errors& b) {
    return a.spread(a.best_setting()).most < b.spread(b.best_setting()).most;
  });
  Field<M> beyond = field_of(scene, Kind::contacts, From::home, most_of_contacts);
  std::erase_if(beyond.entrants, [&](const Entrant<M>& entrant) {
    return entrant.name != ours_name && entrant.name != next->name;
  });
  const auto moved =
      with_spreads(beyond, scene, outcomes_of(beyond, [&](const auto& who) { return watched(who, scene, 0); }));
  page.text(
      R"(The limit of @ iterations is for the time that this page takes. This course and @, whose largest error
      from these starts is the least of the others within it, with up to @:)",
      field.most_work, next->name, beyond.most_work);
  page.table(head_of_three_rows, three_rows<M>(beyond, moved, Unit::metres));
  page.text("@", judged_at_best(page, beyond, moved, Unit::metres));
}

template <class M>
void walls_of(int base, const std::string& figure, double most, Page& page) {
  const Scene<M> scene = pyramid<M>(base);
  const Field<M> field = field_of(scene, Kind::contacts, From::home, most);
  const auto still = outcomes_of(field, [&](const auto& who) { return watched(who, scene, 0); });
  std::vector<std::vector<std::string>> rows;
  std::vector<Wall> ours;
  std::vector<std::pair<Wall, Wall>> advised;  // undisturbed, kicked
  for (std::size_t i = 0; i < field.entrants.size(); ++i)
    for (const std::size_t row : {0, 1}) {
      const Wall &rest = still[i].by_setting[row],
                 kicked = watched(field.entrants[i].settings[row], scene, wall_kick);
      if (i == 0) ours.insert(ours.end(), {rest, kicked});
      if (row == 1) advised.emplace_back(rest, kicked);
      rows.push_back({say("@, @", field.entrants[i].name, row_names[row]), in_millimetres(rest.moved),
                      in_millimetres(rest.sagged), in_millimetres(rest.overlap), in_millimetres(kicked.moved),
                      in_millimetres(kicked.sagged)});
    }
  page.table({"", "moved sideways", "sagged", "overlap at the end", "kicked: sideways", "sagged"}, rows);
  double most_moved = 0;
  for (const Wall& one : ours) most_moved = std::max(most_moved, one.moved);
  const Quantity farthest("moved at most [m]", most_moved);
  const std::string stands =
      page.verdict({{.when = farthest < stands_within,
                     .say = say("This course's pyramid stands; in this table its boxes move by @ at most.",
                                in_millimetres(most_moved))},
                    {.when = farthest >= stands_within,
                     .say = say("In this course some box moves by @.", in_millimetres(most_moved))}});
  page.text("@", restless_in_words(field, still));
  page.text("@@", stands, alone() ? "" : " " + least_as_advised(page, field, advised));
  const auto moved = with_spreads(field, scene, still);
  if (!alone()) {
    page.text(
        R"(Sideways from rest, with these settings and all others of up to @ iterations a frame. Errors of piles hang on
        the last digits of the start. So both rows, and what is near the best, are run from @ more starts, with each box up to 1 µm aside:)",
        most, ways);
    page.table(head_of_three_rows, three_rows<M>(field, moved, Unit::metres));
    page.text(
        "@ That is of @ s after @ s of settling, about x = 0; other times and places may rank them otherwise.",
        judged(page, field, moved, Unit::metres), wall_frames * frame, settling * frame);
    if (most < most_of_contacts && moved.size() > 1) tell_beyond_the_limit(page, field, scene, moved);
    const double passes = passes_a_frame(scene, 0, wall_frames);
    const Quantity kicked("passes after the kick", passes_a_frame(scene, wall_kick, wall_frames)),
        undisturbed("1.1 × undisturbed", engines::equal_times * passes);
    page.text(
        "The chart has the undisturbed pyramid. @",
        page.verdict(
            {{.when = kicked > undisturbed,
              .say =
                  say(R"(This course's sweeps end at a tolerance. Its passes over the contacts a frame, as shipped
                           and on the mean of @ s: @ there, and @ after the kick.)",
                      wall_frames * frame, Value(passes, 2), Value(kicked.value, 2))},
             {.when = kicked <= undisturbed,
              .say = say("This course's passes over the contacts a frame, as shipped: @ there, and no more after "
                         "the kick.",
                         Value(passes, 2))}}));
  }
  compare_by_time(page, figure,
                  "The pyramid: the largest sideways displacement of any box within 5 s from rest, and the mean "
                  "time of their frames.",
                  moved, [=] {
                    return against_time(field, moved,
                                        Timed<M>{scene, wall_frames, {settling}, "undisturbed, from one start, "},
                                        "moved sideways");
                  });
  page.claim("this course, the pyramid: most that a box moves sideways at any time of four runs", most_moved, "m",
             is_at_most(stands_within, "a fiftieth of a box: it stands"));
}

}  // namespace

void wall_of_boxes(const Setting& setting, Page& page) {
  const int base = setting.base, boxes = base * (base + 1) / 2;
  page.text(
      R"(A pyramid of @ boxes, a tenth of a box apart in each row. Each engine has @ s to settle, and what still moves then counts.
      From there the pyramid is watched for @ s, once undisturbed and once after a kick of @ m/s at the top.)",
      boxes, settling * frame, wall_frames * frame, wall_kick);
  const double friction = Surface{}.friction,
               way = 1000 * wall_kick * wall_kick / (2 * friction * gravity);  // [mm]
  page.predict(
      {.ask = say(R"(The kick is @ m/s at the top. How far does that box slide before friction, μ = @, stops it?)",
                  wall_kick, friction),
       .answer = way,
       .unit = "mm",
       .tolerance = 0.05 * way,
       .wrong = {{2 * way, "That is v²/μg. Its mean speed is half of what it starts with."}},
       .hints = {"How large is the deceleration by friction?", "a = μg, and the stopping distance is v²/2a.",
                 say("0.02²/(2 · @ · 9.81) m = …", friction)},
       .right =
           say(R"(v²/2μg, if friction acts continuously. In one step of 1/60 s it can take μgh = @ m/s, more than
                    the kick, so a solver may stop the box at once.)",
               Value(friction * gravity * frame, 2))});
  page.text(
      R"(A pyramid should not move at all. Sideways motion tears it apart; downward motion shows how far its contacts give
      way.)");
  walls_of<PlaneBody>(base, "wall_clocked", most_of_contacts, page);
}

void wall_in_space(const Setting& setting, Page& page) {
  page.text("The same boxes with a third axis.@",
            alone() ? "" : R"( Most of this course's time goes into conjugate sweeps here, in double
      precision and one contact at a time. Box3D sweeps twice a substep over soft contacts, in single precision and
      several at a time.)");
  walls_of<SpaceBody>(setting.base, "space_wall_clocked", most_of_a_wall_in_space, page);
}

namespace {

template <class M>
void wall_in_webassembly_of(int base, const std::string& where, Page& page) {
  const Scene<M> scene = pyramid<M>(base);
  const Field<M> field =
      field_of(scene, Kind::contacts, From::home, most_of_contacts_in_webassembly, Party::webassembly);
  const auto still = outcomes_of(field, [&](const auto& who) { return watched(who, scene, 0); });
  const auto moved = with_spreads(field, scene, still), overlap = errors_of(still, &Wall::overlap);
  page.text(
      R"(A pyramid as in step 6, of @ boxes, @: the largest sideways displacement of a box from rest within @ s, from
      several starts and about x = 0 as there. Of more boxes MuJoCo takes minutes. Its advice is against slip, and PhysX's for joints;
      for piles they give none.)",
      base * (base + 1) / 2, where, wall_frames * frame);
  tell_three<M>(page, field, moved, Unit::metres);
  compare_by_time(page, say("webassembly_wall_@", M::linear),
                  say("Displacement of the pyramid @ within @ s, and the mean time of its first @ frames.", where,
                      wall_frames * frame, soon),
                  moved, [=] {
                    return against_time(
                        field, moved,
                        Timed<M>{scene,
                                 soon,
                                 {settling},
                                 say("undisturbed, from one start, by the time of @ s, ", Value(soon * frame, 2))},
                        "moved sideways");
                  });
  page.text("How deep two boxes overlap at the end, which is partly each engine's intention:");
  tell_three<M>(page, field, overlap, Unit::metres);
}

}  // namespace

void wall_in_webassembly(const Setting& setting, Page& page) {
  const int base = std::min<int>(setting.base, 8);  // beyond that MuJoCo takes minutes
  wall_in_webassembly_of<PlaneBody>(base, "in the plane", page);
  wall_in_webassembly_of<SpaceBody>(base, "in space", page);
}

}  // namespace byhand::beside
