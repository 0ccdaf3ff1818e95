// Step 5: in space Iω stays, so ω must turn; and what happens if nobody turns it.

#include "lessons/07_space/steps.hpp"
#include "lessons/07_space/thrown.hpp"
#include "lessons/07_space/turning_with_the_body.hpp"
#include "lessons/exact/free_top.hpp"
#include "lessons/pictures/space_scene.hpp"
#include "renderer/labels.hpp"

namespace byhand::space {
namespace {

constexpr double term_seconds = 5, careless = 0.4;  // [s], share of the spin about the other axes

double angle_between(const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
  return std::atan2(a.cross(b).norm(), a.dot(b));
}

/// How far Iω has gone from where it was if it is fixed in a body that turns steadily about ω, α from it [rad].
double carried_round(double alpha, double turned) {
  return 2 * std::asin(std::min(1.0, std::abs(std::sin(alpha) * std::sin(turned / 2))));
}

Chart off_over_time(const Flight& flight) {
  const double alpha = angle_between(flight[0].omega, flight[0].momentum), rate = flight[0].omega.norm();
  const double turns = 3 * 2 * pi / rate;
  Chart chart{.x = {.label = "time (s)", .range = {{0, turns}}}, .y = {.label = "Iω from where it was (deg)"}};
  Curve run{.label = "run", .style = CurveStyle::markers, .colour = palette::error},
      theory{.label = "carried round ω", .style = CurveStyle::theory};
  for (const Instant& now : flight) {
    if (now.time > turns) break;
    run.x.push_back(now.time);
    run.y.push_back(degrees(angle_between(now.momentum, flight[0].momentum)));
  }
  for (int i = 0; i <= 240; ++i) {
    theory.x.push_back(i * turns / 240);
    theory.y.push_back(degrees(carried_round(alpha, rate * theory.x.back())));
  }
  chart.curves = {run, theory};
  return chart;
}

void draw_fan(Canvas& canvas, const Flight& flight, const Chart& chart) {
  const auto [left, right] = canvas.page().inset(20).panels(0.55, 16);
  Space space(pictures::from_aside({0, 0.42, 0}, 1.25, left, 0.6, 0.3));
  space.ground({0, -0.75, 0}, 2.4, 0.4);
  pictures::add_book(space, flight[0].pose, book_sides());
  const double L = flight[0].momentum.norm(), turn = 2 * pi / flight[0].omega.norm();
  const auto tip = [&](const Instant& now) { return Point3(1.45 / L * now.momentum); };
  for (int i = 7; i >= 0; --i)
    space.arrow({0, 0, 0}, tip(at(flight, i * turn / 8)), 0.014, mix(palette::error, palette::paper, 0.09 * i));
  const Point3 omega = 1.6 * flight[0].omega.normalized();
  space.arrow({0, 0, 0}, omega, 0.02, palette::velocity);
  canvas.draw(space);
  Labels labels(canvas, left);
  labels.avoid(Rectangle{space.project(omega).x() - 30, space.project(omega).y() - 50, 60, 60});
  labels.place(space.project(omega), "ω stays", {.size = 20, .colour = palette::velocity, .halo = 3}, 12);
  labels.place(space.project(tip(at(flight, turn / 2))), "Iω goes round",
               {.size = 20, .colour = palette::error, .halo = 3}, 24);
  renderer::draw(canvas, chart, right.lowered(70));
}

}  // namespace

void left_out(const Setting& setting, Page& page) {
  const Flight flight = thrown(setting, careless, Gyroscopic::none, term_seconds);
  const Eigen::Vector3d moments = moments_of(setting), spin = first_spin(setting, careless);
  const double alpha = angle_between(moments.cwiseProduct(spin), spin);
  double turned = 0, energy = 0, off_law = 0, lengthened = 0;
  for (const Instant& now : flight) {
    const double off = angle_between(now.momentum, flight[0].momentum);
    turned = std::max(turned, off);
    off_law = std::max(off_law, std::abs(off - carried_round(alpha, spin.norm() * now.time)));
    energy = std::max(energy, std::abs(now.energy / flight[0].energy - 1));
    lengthened = std::max(lengthened, std::abs(now.momentum.norm() / flight[0].momentum.norm() - 1));
  }

  page.text(
      R"(Throw the book, spinning at @ rad/s about y, the axis of its intermediate moment, and, carelessly, at @ of
      that about each of the others.
      There is no gravity, no constraint and no row, so V stays as it is. Or does it? The angular momentum Iω has to
      stay. In the plane that is the same thing. In space I turns:)",
      setting.spin, careless);
  page.formula("d(Iω)/dt = 0   ⟹   Iω̇ = −ω × Iω",
               R"(\frac{d}{dt}(I\omega) = 0 \quad\Rightarrow\quad I\dot\omega = -\,\omega\times I\omega)");
  page.derivation(
      "Why Iω̇ = −ω × Iω",
      {{"no torque acts", "d(Iω)/dt = 0", R"(\frac{d}{dt}(I\omega) = 0)"},
       {"I turns with the body: dI/dt = [ω]I − I[ω], [ω]v = ω × v", "d(Iω)/dt = ω × Iω − I(ω × ω) + Iω̇",
        R"(\frac{d}{dt}(I\omega) = \omega\times I\omega - I(\omega\times\omega) + I\dot\omega)"},
       {"ω × ω = 0", "Iω̇ = −ω × Iω", R"(I\dot\omega = -\,\omega\times I\omega)"}});
  page.text(
      R"(So ω turns without any force, unless Iω and ω have the same direction. That is the *gyroscopic term*. It is not a
      constraint and has no row; a step must add it, as it adds gravity. The article's step does not.)");
  turning_with_the_body(setting, careless, page);
  const auto flipped = flips_of(flight).size();
  const double answer = degrees(turned);
  page.predict(
      {.ask =
           say(R"(The solver steps the book for @ s without the term, so ω stays. How far does Iω get from where it
                  was, if it begins at @° from ω?)",
               term_seconds, Value(degrees(alpha), 3)),
       .answer = answer,
       .unit = "deg",
       .tolerance = 0.05 * answer,
       .wrong = {{0, "Iω keeps its direction only if ω turns."},
                 {degrees(alpha), "That is its angle from ω. Where is it after half a turn about ω?"},
                 {360, "It goes all the way round ω, but stays near it."}},
       .hints = {"Which line of the step could change ω? None: ω stays, in the world and in the book.",
                 "In the book's axes ω and I both stay, and so does Iω there. And in the world?",
                 say("Iω is carried round ω on a cone. Its other side is 2 · @° away.", Value(degrees(alpha), 3))},
       .hinted = 2 * degrees(alpha),
       .right = "The book turns about ω and carries Iω with it, to the other side of a cone about ω."});
  page.figure(
      "left_out",
      say(R"(Without the gyroscopic term ω stays where it is, at @° from Iω, and Iω is carried round with the book:
                  arrows an eighth of a turn apart. Right: the angle between Iω and where it was.)",
          Value(degrees(alpha), 3)),
      [=, chart = off_over_time(flight)](Canvas& canvas) { draw_fan(canvas, flight, chart); });
  page.text(
      R"(It looks harmless: energy, ω and the length of Iω are all kept. But the *direction* of Iω is wrong by up to @°,
      and a real book thrown like this moves quite differently: it turns over every @ s. The next step shows how, with
      another throw.)",
      Value(degrees(turned), 3), Value(FreeTop(moments, spin).period() / 2, 3));
  page.measure("Iω off by up to", degrees(turned), "deg");

  const double step = spin.norm() * setting.h;  // how near to half a turn some step comes
  page.claim("flips in the run", static_cast<double>(flipped), "1", is(0, "nothing turns ω", absolute(0)));
  page.claim("Iω off by up to", turned, "rad",
             is(2 * alpha, "twice the angle from ω to Iω", relative(step * step / 8)));
  page.claim("all angles from those of the law, at most", off_law, "rad",
             is(0, "Iω carried round ω", absolute(1e-7)));
  page.claim("energy, largest relative change", energy, "1", is(0, "ω fixed in world and body", absolute(1e-11)));
  page.claim("length of Iω, largest relative change", lengthened, "1",
             is(0, "Iω carried round ω", absolute(1e-11)));
}

}  // namespace byhand::space
