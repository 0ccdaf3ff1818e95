#include "lessons/04_baumgarte/pendulums.hpp"

#include "lessons/scenes/pendulum.hpp"

namespace byhand::baumgarte {

PendulumFilm::PendulumFilm(const Setting& setting)
    : betas_(film_betas(setting)),
      exact_(radians(setting.release()), setting.length, gravity),
      length_(setting.length) {
  below_ = {.x = {.label = "time (s)"},
            .y = {.label = "|C|/L", .scale = Scale::logarithmic, .range = {{1e-6, 2}}}};
  const double h = setting.h();
  for (std::size_t i = 0; i < 3; ++i) {
    const DriftCure cure = betas_[i] == 0 ? DriftCure(NoDriftCure{}) : DriftCure(Baumgarte{betas_[i]});
    runs_[i] = swinging(setting, cure, h, static_cast<int>(std::lround(film_seconds / h)));
    below_.curves.push_back(
        {.label = say("β = @", betas_[i]),
         .x = each(runs_[i], &Sample::time),
         .y = each(runs_[i], [&](const Sample& s) { return std::abs(s.position.norm() / length_ - 1); })});
  }
}

void PendulumFilm::draw(Canvas& canvas, double time) const {
  const auto [above, under] = canvas.page().inset(20).split_rows(0.58, 10);
  const auto frames = above.cells(1, 3, 12);
  double reach = length_;
  for (const Sample& sample : runs_[0]) reach = std::max(reach, sample.position.norm());
  const Point ghost = length_ * from_straight_down<PlaneParticle>(exact_.angle(time));
  const double top = 0.15 * length_ + std::max(0.0, runs_[0].front().position.y());
  for (std::size_t i = 0; i < 3; ++i) {
    canvas.look(fit({-reach, -reach, 2 * reach, reach + top}, frames[i], 18));
    std::vector<Point> trail;
    for (const Sample& sample : runs_[i])
      if (sample.time <= time + 1e-9 && sample.time > time - 0.7) trail.emplace_back(sample.position);
    const Point now = at(runs_[i], time).position;
    canvas.line({0, 0}, ghost, {palette::theory, 2, Dash::dashed});
    canvas.disc(ghost, 13 / canvas.camera().scale, {palette::paper, {palette::theory, 2}});
    canvas.trail(trail, {palette::series(static_cast<int>(i)), 3});
    pictures::draw(canvas, {.bobs = {{now, 1}}, .rods = {{{0, 0}, now}}, .anchors = {{0, 0}}},
                   {.bob = 13, .bodies = pictures::look_of_run(static_cast<int>(i))});
    canvas.look_at_page();
    canvas.text({frames[i].centre().x(), frames[i].top() - 8}, say("β = @", betas_[i]),
                {.size = 22, .colour = palette::series(static_cast<int>(i)), .bold = true});
  }
  renderer::draw(canvas, pictures::grown_to(below_, time), under);
}

}  // namespace byhand::baumgarte
