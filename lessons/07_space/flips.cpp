// Step 6: the gyroscopic term left out, explicit and implicit, against the elliptic answer.

#include "lessons/07_space/steps.hpp"
#include "lessons/07_space/thrown.hpp"
#include "lessons/exact/free_top.hpp"
#include "lessons/pictures/space_scene.hpp"

namespace byhand::space {
namespace {

constexpr double flip_seconds = 5, flight_seconds = 20;
constexpr std::array choices{Gyroscopic::none, Gyroscopic::explicit_, Gyroscopic::implicit};
constexpr std::array choice_names{"left out", "explicit", "implicit"};

/// What the film shows.
struct FlipsFilm {
  std::array<Flight, 3> flights;
  Chart below;

  void draw(Canvas& canvas, double time) const {
    const auto [above, under] = canvas.page().inset(16).split_rows(0.55, 6);
    const auto frames = above.cells(1, 3, 8);
    for (std::size_t i = 0; i < 3; ++i) {
      const Rectangle frame{frames[i].x, frames[i].y, frames[i].width, frames[i].height - 34};
      const Instant& now = at(flights[i], time);
      Space space(pictures::from_aside({0, 0.1, 0}, 1.02, frame, 0.6, 0.3));
      space.ground({0, -0.85, 0}, 2, 0.4);
      pictures::add_book(space, now.pose, book_sides());
      const double size = now.momentum.norm() / flights[i][0].momentum.norm();
      const Point3 L = std::min(0.85 * size, 1.05) * now.momentum.normalized();
      space.arrow(0.1 * L, L, 0.024, palette::error);
      canvas.draw(space);
      const bool lost = flew_apart(flights[i], flip_seconds) && time > flights[i].back().time;
      canvas.text({frames[i].centre().x(), frames[i].top() - 14},
                  lost ? say("@: lost", choice_names[i]) : choice_names[i],
                  {.size = 22, .colour = palette::series(static_cast<int>(i)), .bold = true});
    }
    renderer::draw(canvas, pictures::grown_to(below, time), under);
  }
};

FlipsFilm film_of(const Setting& setting) {
  FlipsFilm film;
  film.below = {.x = {.label = "time (s)"}, .y = {.label = "spin about the book's own y (rad/s)"}};
  const FreeTop exact(moments_of(setting), first_spin(setting, setting.wobble));
  double fastest = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    film.flights[i] = thrown(setting, setting.wobble, choices[i], flip_seconds);
    Curve curve{.label = choice_names[i]};
    for (const Instant& now : film.flights[i]) {
      curve.x.push_back(now.time);
      curve.y.push_back(now.spin().y());
      fastest = std::max(fastest, std::abs(curve.y.back()));
    }
    film.below.curves.push_back(std::move(curve));
  }
  Curve theory{.label = "exact", .style = CurveStyle::theory};
  for (const Eigen::Vector3d& spin : exact.path(flip_seconds, 100)) {
    theory.x.push_back(static_cast<double>(theory.x.size()) * flip_seconds / 100);
    theory.y.push_back(spin.y());
  }
  film.below.curves.push_back(std::move(theory));
  const double shown = std::min(fastest, 3 * setting.spin());
  film.below.y.range = {{-1.15 * shown, 1.15 * shown}};
  return film;
}

/// Largest relative changes along a flight.
struct Kept {
  Curve energy, momentum;
  double worst_energy = 0, worst_momentum = 0;
};
Kept kept_in(const Flight& flight, const char* name) {
  Kept kept;
  kept.energy.label = kept.momentum.label = name;
  for (const Instant& now : flight) {
    const double energy = std::abs(now.energy / flight[0].energy - 1),
                 momentum = (now.momentum - flight[0].momentum).norm() / flight[0].momentum.norm();
    kept.worst_energy = std::max(kept.worst_energy, energy);
    kept.worst_momentum = std::max(kept.worst_momentum, momentum);
    kept.energy.x.push_back(now.time);
    kept.momentum.x.push_back(now.time);
    kept.energy.y.push_back(std::max(kept.worst_energy, 1e-17));
    kept.momentum.y.push_back(std::max(kept.worst_momentum, 1e-17));
  }
  if (flew_apart(flight, flight_seconds))
    for (Curve* curve : {&kept.energy, &kept.momentum}) {
      curve->x.push_back(flight.back().time);
      curve->y.push_back(INFINITY);
    }
  return kept;
}

//! [explicit]
/// One step of the explicit term: the spin about the body's own axes, from what it was at the start.
Eigen::Vector3d explicitly(const Eigen::Vector3d& I, const Eigen::Vector3d& spin, double h) {
  const Eigen::Vector3d momentum = I.cwiseProduct(spin);
  return spin + h * momentum.cross(spin).cwiseQuotient(I);
}
//! [explicit]

//! [implicit]
/// One step of the implicit term: the same with the mean of the spins before and after, found by fixed-point
/// iteration.
Eigen::Vector3d implicitly(const Eigen::Vector3d& I, const Eigen::Vector3d& spin, double h) {
  Eigen::Vector3d after = spin;
  for (int i = 0; i < 50; ++i) {
    const Eigen::Vector3d mean = 0.5 * (spin + after), momentum = I.cwiseProduct(mean);
    const double half = 0.5 * h * mean.norm();  // of the angle by which the book turns
    after = spin + h * std::tan(half) / half * momentum.cross(mean).cwiseQuotient(I);
  }
  return after;
}
//! [implicit]

/// The mean time from one flip to the next [s].
double between_flips(const Flight& flight) {
  const auto times = flips_of(flight);
  return times.size() < 2 ? NAN : (times.back() - times.front()) / (static_cast<double>(times.size()) - 1);
}

}  // namespace

void flips(const Setting& setting, Page& page) {
  const double h = setting.h;
  const Eigen::Vector3d moments = moments_of(setting), spin = first_spin(setting, setting.wobble);
  const double half_period = FreeTop(moments, spin).period() / 2;
  std::array<Flight, 3> flights;
  std::array<Kept, 3> kept;
  for (std::size_t i = 0; i < 3; ++i) {
    flights[i] = thrown(setting, setting.wobble, choices[i], flight_seconds);
    kept[i] = kept_in(flights[i], choice_names[i]);
  }
  const Flight& implicit_flight = flights[2];
  const double measured = between_flips(implicit_flight);
  const auto turning = flips_of(implicit_flight);
  const double first_flip = turning.empty() ? INFINITY : turning.front();

  page.text(
      R"(A real book turns over, again and again; try it, with a rubber band round it. A spin about the intermediate
      axis is unstable (the *tennis-racket theorem*): the small part about the other axes grows until the book flips;
      then it spins steadily for a while, and flips back. By the exact solution of Euler's equations, in elliptic
      functions, this book flips every @ s, half a period.)",
      half_period);
  page.text(
      R"(So a step has to add the term. There are two ways. *Explicit*: from the spin at the start of the step. In the
      body's own axes, where I is three numbers:)");
  page.excerpt("lessons/07_space/flips.cpp", "explicit");
  page.text(
      R"(*Implicit*: from the mean of the spins before and after, about which the book turns in the step. These are
      three equations in three unknowns. With steps this short a fixed-point iteration solves them; the solver uses
      Newton's method. With φ = h|mean|, the angle of the step, the factor tan(½φ)/½φ makes Iω turn by exactly φ
      backwards in the body's axes, so that in the world it stays.)");
  page.excerpt("lessons/07_space/flips.cpp", "implicit");
  page.sequence(
      "three_books",
      say(R"(The book thrown without the term, with the explicit and with the implicit one. The yellow end shows which
            way up it is; the arrow, Iω, should not move. Below: the spin about the book's own y; dashed: exact.@)",
          first_flip < flip_seconds
              ? ""
              : " The film ends before the first flip: a faster spin or a larger wobble brings it sooner."),
      Seconds{flip_seconds}, [film = film_of(setting)](Canvas& canvas, double time) { film.draw(canvas, time); });

  const Eigen::Vector3d kick = moments.cwiseProduct(spin).cross(spin);
  const double gain = h * h / 2 * kick.dot(kick.cwiseQuotient(moments));
  page.choose(
      {.ask =
           R"(The explicit term adds hk to Iω, and k = Iω × ω is at right angles to ω, so it does no work at the start
              of the step. What does the energy do over many flips?)",
       .options =
           {{"it is conserved",
             R"(k is at right angles to ω only at the *start* of the step. The spins of equal energy form an ellipsoid,
             and a step along its tangent always ends outside.)"},
            {"it rises", "Each step adds ½h²k·I⁻¹k, which is never negative."},
            {"it falls", "The one term of E' − E that could be negative, h k·ω, is zero."}},
       .answer = flights[1].back().energy > flights[1][0].energy ? 1 : 2,
       .hints = {"To which side of a circle does a step along its tangent lead?",
                 "E = ½ω·Iω, and ω' = ω + h I⁻¹k with k·ω = 0", "E' − E = h k·ω + ½h² k·I⁻¹k"}});
  Chart energy{.x = {.label = "time (s)"}, .y = {.label = "largest |ΔE|/E", .scale = Scale::logarithmic}},
      momentum{.x = {.label = "time (s)"}, .y = {.label = "largest |Δ(Iω)|/|Iω|", .scale = Scale::logarithmic}};
  for (const Kept& each : kept) {
    energy.curves.push_back(each.energy);
    momentum.curves.push_back(each.momentum);
  }
  page.figure(
      "what_is_kept",
      say(R"(Energy (left) and angular momentum (right) over @ s, the largest relative change so far. Without the
                  term energy is conserved and angular momentum is not; the explicit term conserves neither@, the
                  implicit one both, to rounding.)",
          flight_seconds,
          flew_apart(flights[1], flight_seconds) ? " (×: stopped, at a hundred times the spin)" : ""),
      [=](Canvas& canvas) {
        const Rectangle paper = canvas.page();
        const auto [left, right] = paper.inset(20, paper.is_high() ? 20 : 60).panels(0.5, 24);
        renderer::draw(canvas, energy, left);
        renderer::draw(canvas, momentum, right);
      });
  if (flew_apart(flights[1], flight_seconds))
    page.text("With the explicit term the book spins a hundred times as fast after @ s as when it was thrown.",
              flights[1].back().time);
  else
    page.text("After @ s the explicit book has @ times the energy it was thrown with.", flight_seconds,
              flights[1].back().energy / flights[1][0].energy);
  const double turned = spin.norm() * h;
  const bool flips_twice = std::isfinite(measured);
  if (flips_twice) page.measure("from flip to flip, implicit", measured, "s");
  page.claim("implicit: from flip to flip", flips_twice ? measured : half_period, "s",
             is(half_period, "elliptic half period", relative(turned * turned / 2)),
             Condition{flips_twice, say("two flips within @ s", flight_seconds)});
  page.claim("implicit: largest |ΔE|/E", kept[2].worst_energy, "1", is_at_most(1e-12, "it is conserved"));
  page.claim("implicit: largest |Δ(Iω)|/|Iω|", kept[2].worst_momentum, "1", is_at_most(1e-12, "it is conserved"));
  page.claim("explicit: energy gained in the first step", flights[1][1].energy - flights[1][0].energy, "J",
             is(gain, "½h²k·I⁻¹k, k = Iω × ω", absolute(1e-13 * flights[1][0].energy)));
  page.claim("term left out: largest |ΔE|/E", kept[0].worst_energy, "1",
             is_at_most(1e-10, "ω stays, in world and body"));
  const double apart = std::acos(std::min(1.0, flights[0][0].momentum.normalized().dot(spin.normalized())));
  page.claim("term left out: largest |Δ(Iω)|/|Iω|", kept[0].worst_momentum, "1",
             is_at_least(1.9 * std::sin(apart), "Iω carried round ω"));
  const auto first_step = [&](int flight, const Eigen::Vector3d& plain) {
    return (flights[flight][1].spin() - plain).norm() / spin.norm();
  };
  page.claim("plain explicit step from the solver's", first_step(1, explicitly(moments, spin, h)), "1",
             is(0, "begin_turn, end_turn", absolute(1e-12)));
  page.claim("plain implicit step from the solver's", first_step(2, implicitly(moments, spin, h)), "1",
             is(0, "begin_turn, end_turn", absolute(1e-12)));
}

}  // namespace byhand::space
