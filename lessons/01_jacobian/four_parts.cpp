#include <fmt/format.h>

#include <span>

#include "lessons/01_jacobian/pair.hpp"
#include "lessons/01_jacobian/picture.hpp"
#include "lessons/01_jacobian/steps.hpp"
#include "lessons/pictures/acts.hpp"

// The film of the product rule: from the rate of C to the four parts of J.
namespace byhand::lesson01 {
namespace {

/// Terms and their sum with the same number of decimals: four digits of the largest, or as many more as it takes
/// for what is printed to add up.
struct PrintedSum {
  std::vector<std::string> terms;
  std::string sum;
};

PrintedSum printed_sum(const std::array<double, 4>& terms) {
  double largest = 1e-12, sum = 0;
  for (const double term : terms) largest = std::max(largest, std::abs(term)), sum += term;
  int decimals = std::clamp(3 - static_cast<int>(std::floor(std::log10(largest))), 0, 9);
  const auto rounded = [&](double value) { return std::llround(value * std::pow(10, decimals)); };
  const auto adds_up = [&] {
    long long all = 0;
    for (const double term : terms) all += rounded(term);
    return all == rounded(sum);
  };
  while (decimals < 9 && !adds_up()) ++decimals;
  const auto fixed = [&](double value) {
    const std::string digits = fmt::format("{:.{}f}", std::abs(value), decimals);
    return rounded(value) < 0 ? "−" + digits : digits;
  };
  PrintedSum printed{{}, fixed(sum)};
  for (const double term : terms) printed.terms.push_back(fixed(term));
  return printed;
}

/// "−1.386 + 0.203 − 1.100": a minus stands for "+ −".
std::string joined(const std::vector<std::string>& terms) {
  std::string all = terms[0];
  for (const std::string& term : std::span(terms).subspan(1))
    all += term.starts_with("−") ? " − " + term.substr(std::string_view("−").size()) : " + " + term;
  return all;
}

struct PartsFilm {
  pictures::Acts acts;
  Pair pair;
  Linear<PlaneBody> sides;
  double length, stretch, per_speed;  // [m], [m], [s]

  void draw(renderer::Canvas& canvas, double time) const {
    const auto [left, right] = canvas.page().inset(20).panels(0.58, 24, 0.8);
    canvas.look(renderer::fit({-0.75 * length, -0.75 * length, 3.3 * length + stretch, 2 * length}, left, 4));
    const double ends = acts.share(0, time), split = acts.share(1, time), l = acts.share(2, time),
                 a = acts.share(3, time);
    // The bows take the place of the arms' names.
    byhand::lesson01::draw(canvas, pair, sides, {.arms_named = a == 0, .pale_rod = true});
    struct Side {
      Point centre, arm, v, turning, l;
      double a;
    };
    const Jacobian<PlaneBody, 1> J = pair.row();
    const auto side = [](const Pose<PlaneBody>& pose, const Linear<PlaneBody>& arm, const Velocity<PlaneBody>& V,
                         const Linear<PlaneBody>& along, double moment) {
      return Side{pose.position, arm, V.head<2>(), V[2] * Point(-arm.y(), arm.x()), along, moment};
    };
    const double largest = std::max({std::abs(J.a1()(0, 0)), std::abs(J.a2()(0, 0)), 1e-12});
    for (const Side& of : {side(pair.pose1, pair.r1(), pair.V1, J.l1().transpose(), J.a1()(0, 0)),
                           side(pair.pose2, pair.r2(), pair.V2, J.l2().transpose(), J.a2()(0, 0))}) {
      const Point end = of.centre + of.arm;
      const double solid = split > 0 ? 2.5 : 4;
      pictures::draw_growing(canvas, end, per_speed * (of.v + of.turning), ends, {palette::velocity, solid});
      pictures::draw_growing(canvas, of.centre, per_speed * of.v, split, {palette::velocity, 4});
      pictures::draw_growing(canvas, end, per_speed * of.turning, split,
                             {palette::velocity, 2.5, renderer::Dash::dashed});
      pictures::draw_growing(canvas, of.centre, 0.45 * of.l, l, {palette::constraint, 4.5});
      const Point ahead = of.l.normalized();
      const double back = std::atan2(-ahead.y(), -ahead.x()), turn = 4 * of.a / largest;
      if (a > 0) draw_bow(canvas, of.centre, 0.16 * length, back - turn / 2, a * turn, {palette::constraint, 3.4});
    }
    acts.draw(canvas, right, time);
  }
};

}  // namespace

void four_parts(course::Page& page, const Settings& set) {
  const Pair pair = pair_of(set);
  const Jacobian<PlaneBody, 1> J = pair.row();
  const double a1 = J.a1()(0, 0), a2 = J.a2()(0, 0);
  const auto shown = [](double value) { return course::Value(std::abs(value) < 1e-12 ? 0 : value, 3); };
  const PrintedSum rate = printed_sum({J.l1().transpose().dot(pair.V1.head<2>()), a1 * pair.V1[2],
                                       J.l2().transpose().dot(pair.V2.head<2>()), a2 * pair.V2[2]});
  const pictures::Acts acts(
      {{course::say("Ċ = d·(Ṗ_2 − Ṗ_1) = @ m²/s", rate.sum),
        "The product rule on ½(d·d − L²): only motion of the ends along d counts.", palette::velocity},
       {"Ṗ = v + ω × r",
        set.spin() == 0 ? "Each end moves with its centre; here the bodies do not turn."
                        : "Each end moves with its centre and turns about it (dashed).",
        palette::velocity},
       {"l_1 = −d,  l_2 = d", "The coefficients of v₁ and v₂: d itself.", palette::constraint},
       {course::say("a_1 = −r_1 × d = @,  a_2 = r_2 × d = @ m²", shown(a1), shown(a2)),
        "The coefficients of ω₁ and ω₂: the moments of d about the centres.", palette::constraint},
       {"Ċ = l_1·v_1 + a_1ω_1 + l_2·v_2 + a_2ω_2 = JV", course::say("= @ = @ m²/s", joined(rate.terms), rate.sum),
        palette::ink}});
  page.sequence(
      "four_parts",
      course::say(R"(From the rate of C to the four parts of J, in @ s. Green: velocities, of the ends and of the
                           centres; blue: the parts of J, l as straight arrows (drawn shorter) and a as curved ones.)",
                  acts.seconds()),
      course::Seconds{acts.seconds()},
      [film =
           PartsFilm{acts, pair, box_sides(set), set.length(), set.stretch(), 0.6 * set.length() / fastest(set)}](
          renderer::Canvas& canvas, double time) { film.draw(canvas, time); });
}

}  // namespace byhand::lesson01
