// Part of step 1: a film of two rows that undo each other's work.

#include <utility>

#include "lessons/03_iterations/held_step.hpp"
#include "lessons/03_iterations/knobs.hpp"
#include "lessons/pictures/acts.hpp"

namespace byhand::iterations {
namespace {

/// Two links after a row was solved: in units of gh, and of m·gh for the row's impulse.
struct Moment {
  std::vector<double> speeds, errors;
  int row = -1;  // the one just solved
  double impulse = 0;
};

struct SweepFilm {
  pictures::Acts acts;
  pictures::Linkage linkage;
  std::vector<Moment> moments;
  double length;

  void draw(renderer::Canvas& canvas, double time) const {
    const auto [left, right] = canvas.page().inset(20).panels(0.54, 30, 0.8);
    const renderer::Camera camera =
        renderer::fit({-1.1 * length, -2.75 * length, 2.2 * length, 2.9 * length}, left, 10);
    canvas.look(camera);
    pictures::draw(canvas, linkage, {.bob = 24, .rod = 9});
    canvas.look_at_page();
    const std::size_t present = acts.now(time);
    const double share = acts.share(present, time), unit = 0.42 * length * camera.scale;
    const Moment still{{0, 0}, {0, 0}};
    const Moment &before = present == 0 ? still : moments[present - 1], &after = moments[present];
    for (std::size_t i = 0; i < 2; ++i) {
      const Point up = camera.to_page(linkage.rods[i].from), bob = camera.to_page(linkage.rods[i].to),
                  middle = (up + bob) / 2;
      if (after.row == static_cast<int>(i))
        canvas.rod(up - Point(0, 18), bob + Point(0, 26), {palette::highlight, {palette::ink, 1.6}}, 11);
      const double error = before.errors[i] + share * (after.errors[i] - before.errors[i]),
                   speed = before.speeds[i] + share * (after.speeds[i] - before.speeds[i]);
      // What a row's error is, as a bar beside its rod.
      const Point foot = middle + Point(-46, -0.5 * unit * error);
      canvas.line(foot, foot + Point(0, unit * error), {palette::error, 9});
      canvas.text(middle - Point(60, 0), say("@ gh", Value(std::round(100 * error) / 100, 3)),
                  {.size = 21, .colour = palette::error, .anchor = renderer::Anchor::right});
      canvas.vector(bob + Point(50, 0), {0, -speed}, {palette::velocity, unit});
    }
    if (after.row >= 0) {
      const auto row = static_cast<std::size_t>(after.row);
      const Point pull(0, unit * after.impulse);
      pictures::draw_growing(canvas, camera.to_page(linkage.rods[row].to) + Point(86, 0), pull, share,
                             {palette::force, 4.5});
      if (row > 0)
        pictures::draw_growing(canvas, camera.to_page(linkage.rods[row].from) + Point(86, 0), -1 * pull, share,
                               {palette::force, 4.5});
    }
    acts.draw(canvas, right, time);
  }
};

}  // namespace

void within_a_sweep(Page& page, const Knobs& knobs) {
  const double fall = knobs.fall(), unit = knobs.mass * fall / knobs.length;
  HeldStep step(knobs.chain(2), knobs.h);
  const auto moment = [&](int row, double impulse) {
    Moment now{step.speeds(), step.errors(), row, impulse};
    for (double& speed : now.speeds) speed /= fall;
    for (double& error : now.errors) error /= fall;
    return now;
  };
  const pictures::Linkage linkage = pictures::rods_and_bobs(step.scene());
  std::vector<Moment> moments{moment(-1, 0)};
  std::vector<pictures::Acts::Act> acts{
      {"V = gh", "Gravity makes both bobs fall. The upper rod is getting longer, the lower one is not.",
       palette::velocity}};
  for (int i = 0; i < 4; ++i) {
    const std::size_t row = static_cast<std::size_t>(i % 2), other = 1 - row;
    const double before = step.lambda()[row];
    const double undone = moments.back().errors[other];
    step.solve_row();
    moments.push_back(moment(static_cast<int>(row), -(step.lambda()[row] - before) / unit));
    acts.push_back(
        {say("Δλ_@ L = @ mgh@", row + 1, Value(-moments.back().impulse, 3), i == 0 ? " (λ < 0: it pulls)" : ""),
         say("Row @ pulls on its @. Its error is gone; row @'s goes from @ to @ gh.", row + 1,
             row == 0 ? "bob" : "two bobs", other + 1, Value(std::abs(undone) < 1e-12 ? 0 : undone, 3),
             Value(moments.back().errors[other], 3)),
         palette::force});
  }
  const pictures::Acts film(acts);
  page.sequence(
      "within_a_sweep",
      say(R"(Two sweeps over two rows, slowed to @ s. Orange: the impulse of the row being solved (yellow).)",
          film.seconds()),
      Seconds{film.seconds()},
      [shown = SweepFilm{film, linkage, moments, knobs.length}](renderer::Canvas& canvas, double time) {
        shown.draw(canvas, time);
      });
}

}  // namespace byhand::iterations
