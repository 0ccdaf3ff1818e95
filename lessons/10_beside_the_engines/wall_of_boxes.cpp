// Step 6 and after it: the pyramid, in the plane and in space, from each engine's own rest and after a kick.

#include "lessons/10_beside_the_engines/field.hpp"
#include "lessons/10_beside_the_engines/steps.hpp"
#include "lessons/scenes/boxes.hpp"

namespace byhand::beside {
namespace {

constexpr int wall_frames = 300, timed_wall_frames = 120;                // 5 s, 2 s
constexpr double wall_kick = 0.02, slop = 0.001, slop_of_box2d = 0.005;  // [m/s], [m]
constexpr double most_work_of_walls = 80;                                // iterations a frame that are tried

/// How far a box has come sideways from its engine's rest, at most, and down; how deep two overlap [m].
struct Wall {
  double moved = 0, sagged = 0, overlap = 0;
};

template <class M>
Wall end_of(const Contestant<M>& contestant, const Scene<M>& scene, double speed) {
  Wall result;
  Scene<M> rest = scene;
  engines::run_from_rest<M>(
      contestant, scene, settling, wall_frames,
      [&](Scene<M>& seen) {
        rest.state() = seen.bodies();
        if (speed > 0) kick(seen, speed);
        return speed > 0;
      },
      [&](const Scene<M>& seen, double time) {
        if (time < (wall_frames - 0.5) * frame) return;
        for (int i = 0; i < scene.bodies().size(); ++i) {
          Linear<M> moved = seen.bodies().pose[i].position - rest.bodies().pose[i].position;
          result.sagged = larger(result.sagged, -moved[1]);
          moved[1] = 0;
          result.moved = larger(result.moved, moved.norm());
        }
        result.overlap = deepest_overlap(seen);
      });
  return result;
}

template <class M>
void walls_of(int base, const std::string& figure, double most, Page& page) {
  const Scene<M> scene = pyramid<M>(base);
  const Field<M> field = field_of(scene, Kind::contacts, false, most);
  const auto still = outcomes_of(field, [&](const auto& who) { return end_of(who, scene, 0); });
  std::vector<std::vector<std::string>> rows;
  std::vector<Wall> ours;
  for (std::size_t i = 0; i < field.entrants.size(); ++i)
    for (const std::size_t row : {0, 1}) {
      const Wall &rest = still[i].by_setting[row],
                 kicked = end_of(field.entrants[i].settings[row], scene, wall_kick);
      if (i == 0) ours.insert(ours.end(), {rest, kicked});
      rows.push_back({say("@, @", field.entrants[i].name, row == 0 ? "as shipped" : "as advised"),
                      in_millimetres(rest.moved), in_millimetres(rest.sagged), in_millimetres(rest.overlap),
                      in_millimetres(kicked.moved), in_millimetres(kicked.sagged)});
    }
  page.table({"", "moved sideways", "sagged", "overlap", "kicked: sideways", "sagged"}, rows);
  const auto moved = errors_of(still, &Wall::moved);
  page.text("Left out: @. Sideways from rest, with all settings of up to @ iterations a frame:",
            field.left_out.empty() ? "nobody" : field.left_out, most);
  page.table(head_of_three_rows, three_rows<M>(field, moved, in_millimetres));
  page.text("@", judged(page, moved));
  page.clocked(
      figure,
      say(R"(The pyramid: how far a box has come sideways after 5 s, and the mean time of a frame in the first two
               seconds, on this machine at the moment of the run. @)",
          settings_folder),
      [=] { return against_time(field, moved, scene, timed_wall_frames, "moved sideways (m)"); });
  for (std::size_t i = 0; i < ours.size(); ++i)
    page.claim(say("this course @, the pyramid@: moved sideways", i < 2 ? "as shipped" : "as advised",
                   i % 2 == 0 ? "" : " after a kick"),
               ours[i].moved, "m", is_at_most(slop * base, "it stands: at most an overlap of 1 mm for each row"));
}

}  // namespace

void wall_of_boxes(const Setting& setting, Page& page) {
  const int base = setting.base, boxes = base * (base + 1) / 2;
  page.text(
      R"(A pyramid of @ boxes, a tenth of a box apart in each row. Each engine has a second to come to its own rest.
      From there the pyramid is watched for @ s, once undisturbed and once after a kick of @ m/s at the top. The right
      motion is none. Motion sideways tears a pyramid apart; motion down is what its contacts yield.)",
      boxes, wall_frames * frame, wall_kick);
  const auto& all = engines::all_engines();
  const bool box2d =
      std::any_of(all.begin(), all.end(), [](const Engine& e) { return e.name.starts_with("Box2D"); });
  const double kept = box2d ? slop_of_box2d : slop;
  const std::string who = box2d ? "Box2D" : "this course";
  page.predict(
      {.ask =
           say(R"(@ keeps an overlap of up to @ mm at each contact. By how many millimetres may that alone let the
                top of a pyramid of @ rows sink?)",
               box2d ? "Box2D" : "This course", 1000 * kept, base),
       .answer = 1000 * kept * base,
       .unit = "mm",
       .tolerance = 0.1 * 1000 * kept,
       .wrong = {{1000 * kept * boxes, "Only the contacts one above the other add up."}},
       .hints = {"How many contacts are between the top and the ground?", "rows × overlap",
                 say("@ × @ mm = …", base, 1000 * kept)},
       .right = say("@ contacts lie below the top, each with up to @ mm in @.", base, 1000 * kept, who)});
  walls_of<PlaneBody>(base, "wall_clocked", most_work_of_walls, page);
}

void wall_in_space(const Setting& setting, Page& page) {
  page.text(
      R"(The same boxes with a third axis: four contacts a face, two rows of friction for each, and nothing that keeps
      the pyramid in a plane. Four contacts on a face are one more than a plane needs, so their rows depend on each
      other (lesson 6).)");
  walls_of<SpaceBody>(setting.base, "space_wall_clocked", 40, page);
}

}  // namespace byhand::beside
