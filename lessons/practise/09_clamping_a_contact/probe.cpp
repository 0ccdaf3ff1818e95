#include "lessons/practise/judge/probe.hpp"
#include "lessons/practise/09_clamping_a_contact/signature.hpp"
#include "lessons/practise/judge/stage.hpp"

constexpr double width = 0.2, height = 1, mass = 1, inertia = mass * (width * width + height * height) / 12;

/// Twenty sweeps over the contacts of a thin box. A ball's single contact could not tell whether the increment or
/// the sum is clamped: here row 1 must take back what it gave too much.
template <class Clamp>
std::vector<double> solve(Body& box, const std::vector<GroundContact>& contacts, double h,
                          const Clamp& clamp_contact) {
  const InverseMasses masses{0, 0, 1 / mass, 1 / inertia};
  std::vector<double> accumulated(contacts.size(), 0.0);
  for (int pass = 0; pass < 20; ++pass)
    for (std::size_t i = 0; i < contacts.size(); ++i) {
      const GroundContact& at = contacts[i];
      const BodyRow J{{}, 0, {0, 1}, at.r.x};
      Velocities V{{}, 0, box.v, box.w};
      const double wanted = rate_that_keeps(at.C, at.C > 0 ? 0 : 0.8, h);
      V += clamp_contact(accumulated[i], solved(J, V, masses, wanted).lambda) * over_masses(J, masses);
      box.v = V.v2;
      box.w = V.w2;
    }
  return accumulated;
}

void probe(Probe& p, const Code& code) {
  const auto [clamp_contact] = Learners::of(code);
  const double given = p.number("accumulated", "N s", p.sized(0.1), p.sized(3));
  // It pushes more, takes some back, or would take back more than there is.
  const double least[] = {p.sized(0.2), -0.95 * given, -p.sized(5)},
               most[] = {p.sized(5), -0.05 * given, -1.1 * given};
  const double delta = p.number("delta", "N s", least[p.one_of(3)], most[p.one_of(3)]);
  double accumulated = given;
  const double applied = clamp_contact(accumulated, delta);
  p.answer("applied", "N s", applied);
  p.answer("accumulated", "N s", accumulated);
  p.law("accumulated changes by what is applied", "N s", accumulated, given + applied);
  p.law("accumulated is not negative", "N s", accumulated, std::abs(accumulated));

  Body box{.v = {0, -p.number("speed", "m/s", 0.2, 2)}, .w = p.number("turning", "rad/s", -2, 2)};
  const std::vector<GroundContact> contacts{{{-width / 2, -height / 2}, 0}, {{width / 2, -height / 2}, 0}};
  const std::vector<double> sum = solve(box, contacts, time_step, clamp_contact);
  p.answer("λ of a thin box", "N s", Vec2{sum[0], sum[1]});
  p.answer("its velocity", "m/s", box.v.y);
  p.answer("its turning", "rad/s", box.w);
}

void film(Film& film, const Code& code) {
  const auto clamp_contact = std::get<0>(Learners::of(code));
  film.title = "Thin box, dropped flat from 30 cm";
  film.quantity = "centre above the ground";
  film.unit = "mm";
  const Body box{.at = {0, 0.8}, .mass = mass, .inertia = inertia, .sides = {width, height}};
  box_on_ground(film, box, {0, -9.81}, 0, [&](Body& of, std::vector<GroundContact>& contacts, double h) {
    std::erase_if(contacts, [](const GroundContact& at) { return at.C > 0.1; });
    solve(of, contacts, h, clamp_contact);
  });
}
