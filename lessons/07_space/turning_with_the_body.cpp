// Part of step 5: a film of ω, Iω and the inertia that turns with the body.

#include "lessons/07_space/turning_with_the_body.hpp"

#include "lessons/07_space/thrown.hpp"
#include "lessons/exact/free_top.hpp"
#include "lessons/pictures/acts.hpp"
#include "lessons/pictures/space_scene.hpp"
#include "renderer/labels.hpp"

namespace byhand::space {
namespace {

constexpr int stretches = 3, slow_steps = 120;  // of the motion, and the steps of each
constexpr double stretch = 0.3, drawn = 0.55;   // in turns at the first spin; of the book's size

double between(const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
  return std::atan2(a.cross(b).norm(), a.dot(b));
}

struct TurningFilm {
  pictures::Acts acts;
  Flight flight;  // slow_steps to each hold
  Eigen::Vector3d moments;

  void draw(Canvas& canvas, double time) const {
    const auto [left, right] = canvas.page().inset(20).panels(0.54, 30, 0.8);
    const std::size_t present = acts.now(time);
    const double share = acts.share(present, time);
    const double passed = present < 2 ? 0 : (static_cast<double>(present) - 2 + share) * slow_steps;
    const auto last = static_cast<std::size_t>(std::lround(passed));
    const Instant& now = flight[last];
    const double in_space = 1.5 / flight[0].momentum.norm(), spun = 1.35 / flight[0].omega.norm();

    Space space(pictures::from_aside({0, 0.35, 0}, 1.35, left, 0.6, 0.3));
    space.ground({0, -0.75, 0}, 2.4, 0.4);
    pictures::add_book(space, now.pose, drawn * book_sides());
    const double spins = present == 0 ? share : 1, adds = present == 0 ? 0 : present == 1 ? share : 1;
    const Point3 omega = spins * spun * now.omega;
    if (omega.norm() > 0.1) space.arrow({0, 0, 0}, omega, 0.022, palette::velocity);
    std::vector<Point3> trail;
    for (std::size_t i = 0; i <= last; i += 2) trail.push_back(spun * flight[i].omega);
    pictures::add_trail(space, trail, 0.02, palette::velocity);
    // Iω as the sum of its parts along the book's own axes, the middle one first; each comes in its third.
    Point3 tip(0, 0, 0);
    const Eigen::Matrix3d R = now.pose.rotation.toRotationMatrix();
    const std::array axes{1, 0, 2};
    for (std::size_t k = 0; k < axes.size(); ++k) {
      const int i = axes[k];
      const double grown = std::clamp(3 * adds - static_cast<double>(k), 0.0, 1.0);
      const Point3 part = grown * in_space * moments[i] * now.spin()[i] * R.col(i);
      if (part.norm() > 0.01) space.arrow(tip, tip + part, 0.016, palette::constraint);
      tip += part;
    }
    const Point3 whole = in_space * now.momentum;
    if (adds == 1) space.arrow({0, 0, 0}, whole, 0.022, palette::error);
    canvas.draw(space);
    Labels labels(canvas, left);
    for (int i = 0; i <= 20; ++i) {  // the shaft of ω
      const Point on = space.project(0.05 * i * omega);
      labels.avoid(Rectangle{on.x() - 8, on.y() - 8, 16, 16});
    }
    const auto name = [&](const Point3& at, const char* text, Colour colour) {
      labels.place(space.project(at), text, {.size = 22, .colour = colour, .halo = 3}, 14);
    };
    if (spins == 1) name(1.07 * omega, "ω", palette::velocity);
    if (adds == 1) name(1.07 * whole, "Iω", palette::error);
    acts.draw(canvas, right, time);
  }
};

}  // namespace

void turning_with_the_body(const Setting& setting, double careless, Page& page) {
  const Eigen::Vector3d moments = moments_of(setting), spin = first_spin(setting, careless);
  const double turn = 2 * pi / spin.norm(), h = stretch * turn / slow_steps;
  const Flight flight = thrown(setting, careless, Gyroscopic::implicit, stretches * stretch * turn, h);
  const Instant& first = flight[0];
  std::vector<pictures::Acts::Act> acts{
      {say("|ω| = @ rad/s", Value(first.omega.norm(), 3)), "The book spins about ω.", palette::velocity},
      {say("|Iω| = @ kg m²/s", Value(first.momentum.norm(), 3)),
       "Iω = ΣI_i ω_i e_i: each part lies along an axis e_i of the book.", palette::error}};
  for (std::size_t k = 0; k < stretches; ++k) {
    const Instant& now = flight[(k + 1) * slow_steps];
    acts.push_back(
        {say("ω is @° from its start, Iω @°", Value(degrees(between(now.omega, first.omega)), 3),
             Value(std::round(1e6 * degrees(between(now.momentum, first.momentum))) / 1e6, 2)),
         k == 0
             ? "The axes have turned with the book, and I with them; the parts still add up to the same Iω. So ω "
               "must turn."
         : k == 1 ? "Each part of Iω changes, their sum does not."
                  : "ω goes round, Iω stays."});
  }
  double largest = 0;
  for (const Instant& now : flight)
    largest = std::max(largest, (now.momentum - first.momentum).norm() / first.momentum.norm());
  const pictures::Acts film(acts);
  page.sequence(
      "turning_with_the_body",
      say(R"(The book with the term, as it really moves: @ s slowed to @ s, in steps of @ ms. Green: ω and the path of
                    its tip. Blue: the components of Iω along the book's own axes. Purple: their sum, Iω, which stays
                    put.)",
          Value(stretches * stretch * turn, 2), film.seconds(), Value(1000 * h, 2)),
      Seconds{film.seconds()},
      [shown = TurningFilm{film, flight, moments}](Canvas& canvas, double time) { shown.draw(canvas, time); });
  page.claim("film of Iω: its largest relative change", largest, "1", is(0, "no torque acts", absolute(1e-11)));
  const Instant& last = flight.back();
  page.claim("film of Iω: the spin at its end, from Euler's equations",
             (last.spin() - FreeTop(moments, spin).at(last.time).value).norm(), "rad/s",
             is(0, "elliptic functions", absolute(std::pow(h * spin.norm(), 2) * spin.norm())));
}

}  // namespace byhand::space
