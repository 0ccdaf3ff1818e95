#include "lessons/06_joints/samples.hpp"

#include "lessons/06_joints/mechanism.hpp"
#include "lessons/06_joints/runs.hpp"
#include "lessons/scenes/rod.hpp"

namespace byhand::joints {

namespace {

constexpr double rail = 0.35;  // slope of the slider's rail [rad]

enum Sample { pinned, welded, sliding, stopped, driven, roped };

struct Words {
  const char *name, *rows;
};
constexpr Words words[] = {{"pin", "2 rows"},
                           {"weld", "3 rows"},
                           {"slider", "2 rows"},
                           {"pin and stop", "2 rows + 1 with λ ≥ 0"},
                           {"pin and motor", "2 rows + 1 with |λ| ≤ τh"},
                           {"rope", "1 row, λ ≥ 0"}};

/// What is seen of each, in lengths of a bar.
constexpr Rectangle swinging{-1.1, -1.1, 2.2, 1.6}, turning{-1.1, -1.1, 2.2, 2.2};
constexpr Rectangle views[] = {swinging, swinging, {-0.7, -0.6, 2.8, 1.9},
                               swinging, turning,  {-1.6, -1.6, 3.2, 2.1}};

}  // namespace

Samples::Samples(const Setting& setting)
    : length_(setting.length),
      weight_(setting.mass * gravity),
      h_(setting.h),
      simulation_{{}, VelocityStepping{.solver = Direct{}, .drift = Baumgarte{}}} {
  auto& scene = simulation_.scene;
  const double seconds = sample_pace(length_) * sample_seconds;
  const Linear<PlaneBody> origin(0, 0), along(std::cos(rail), std::sin(rail));
  const int ground = scene.add_body(origin, fixed<PlaneBody>());
  for (int i = pinned; i <= roped; ++i) {
    const PlaneRod bar(origin, {length_, 0}, setting.mass);
    scene.add_body(bar.pose, bar.mass);
  }
  const auto body = [](Sample sample) { return 1 + sample; };
  for (const Sample sample : {pinned, stopped, driven})
    scene.add(pin<PlaneBody>(scene.bodies(), ground, body(sample), origin));
  scene.add(weld<PlaneBody>(scene.bodies(), ground, body(welded), origin));
  scene.add(slider<PlaneBody>(scene.bodies(), ground, body(sliding), origin, along));
  scene.add(at_least<PlaneBody>(sample_stop, turn<PlaneBody>(scene.bodies(), ground, body(stopped))));
  scene.add(motor<PlaneBody>(turn<PlaneBody>(scene.bodies(), ground, body(driven)), 2 * pi / seconds, 1e9));
  scene.add(Rope<PlaneBody>{
      between<PlaneBody>(scene.bodies(), ground, Linear<PlaneBody>(0, 0), body(roped), origin), 0.5 * length_});
  const double up = gravity * std::sin(rail) * seconds / 2;  // it comes back in that time
  scene.state().velocity[body(sliding)].head<2>() = std::min(up, 2.5 * length_ / seconds) * along;
}

std::array<Samples::Given, 6> Samples::given() const {
  std::array<Given, 6> all;
  if (simulation_.time == 0) return all;
  for (const auto& joint : simulation_.scene.entries()) {
    const auto reaction = simulation_.reaction(joint.id);
    const auto& pose = simulation_.scene.bodies().pose[joint.body2];
    const Point force = Point(reaction.force), arm = bar_of(pose, length_).from - Point(pose.position);
    all[joint.body2 - 1].force += force;
    // What is left of the torque about the centre when the force acts at the hinge.
    all[joint.body2 - 1].couple += reaction.torque2[0] - (arm.x() * force.y() - arm.y() * force.x());
  }
  // The rope has turned with the step since it pulled; its arrow is drawn along it.
  const Point end = bar_of(simulation_.scene.bodies().pose[1 + roped], length_).from;
  all[roped].force = -all[roped].force.norm() * end.normalized();
  return all;
}

void Samples::draw(Canvas& canvas, double time) {
  advance_to(simulation_, sample_pace(length_) * time, h_);
  const std::array<Given, 6> reactions = given();
  const auto cells = canvas.page().inset(12).grid(2, 3, 8);
  for (int i = pinned; i <= roped; ++i) {
    const Rectangle& cell = cells[i];
    canvas.look_at_page();
    canvas.text({cell.x + 14, cell.top() - 18}, words[i].name, {.size = 24, .anchor = Anchor::left, .bold = true});
    canvas.text({cell.x + 14, cell.top() - 46}, words[i].rows,
                {.size = 18, .colour = palette::muted, .anchor = Anchor::left});
    const Rectangle below{cell.x, cell.y, cell.width, cell.height - 62};
    const auto& seen = views[i];
    canvas.look(fit({seen.x * length_, seen.y * length_, seen.width * length_, seen.height * length_}, below, 0));
    canvas.clip(below);
    const Bar bar = bar_of(simulation_.scene.bodies().pose[1 + i], length_);
    if (i == sliding)
      draw_rail(canvas, {0, 0}, rail, 3 * length_);
    else
      canvas.anchor({0, 0});
    if (i == stopped) draw_stop(canvas, {0, 0}, sample_stop, length_);
    if (i == roped) {
      const bool slack = bar.from.norm() < 0.499 * length_;
      canvas.line({0, 0}, bar.from, {palette::constraint, 3, slack ? Dash::dotted : Dash::solid});
    }
    draw_bar(canvas, bar);
    if (i == welded)
      draw_weld(canvas, {0, 0});
    else if (i == sliding)
      draw_sleeve(canvas, bar.from, rail);
    else
      canvas.hinge(bar.from);
    canvas.clip({});  // arrows may reach beyond
    const Given& of = reactions[i];
    // The rope is seen beside its pull.
    const Point beside =
        i == roped ? bar.from + 0.06 * length_ * Point(bar.from.y(), -bar.from.x()).normalized() : bar.from;
    if (of.force.norm() > 1e-3 * weight_)
      canvas.vector(beside, of.force, {palette::force, 0.3 * length_ / weight_});
    // A couple of the weight's torque about the hinge is a bow over two radians. Rope and pin have none.
    const double couple = of.couple / (0.5 * weight_ * length_);
    if (i != roped && i != pinned && std::abs(couple) > 0.02)
      draw_turn(canvas, bar.from, -pi / 2, -pi / 2 + std::clamp(2 * couple, -2.6, 2.6), 0.3 * length_,
                {palette::force, 4});
  }
  canvas.look_at_page();
}

}  // namespace byhand::joints
