#include "lessons/01_jacobian/picture.hpp"

// The error of ΔC ≈ h JV is of second order in h; with a wrong sign in J it is of first order.
namespace byhand::lesson01 {
namespace {

/// |ΔC − h JV| for one step h, with a row that may be wrong.
double left_over(const Pair& pair, const Jacobian<PlaneBody, 1>& J, double h) {
  return std::abs(pair.after(h).value() - pair.value() - h * dot(J, pair.V1, pair.V2)[0]);
}

/// The same for a bob that moves past a resting anchor: `pair` without its arms and turns.
Pair bob_of(const Settings& set) {
  Pair pair = pair_of(set);
  pair.rod.at.arms = {};
  pair.pose2.position = pair.pose1.position + pair.d();
  pair.V1.setZero();
  pair.V2 = {set.speed, 0, 0};
  return pair;
}

}  // namespace

void slopes(course::Page& page, const Settings& set) {
  const double h = set.h;
  const Pair pair = pair_of(set), bob = bob_of(set);
  const Jacobian<PlaneBody, 1> J = pair.row();
  Jacobian<PlaneBody, 1> wrong = J;
  wrong.matrix(0, 5) = -J.matrix(0, 5);

  page.text(
      R"(J predicts how C changes over a small step h: ΔC ≈ h·JV. To test a row, look at what the prediction
      misses, |ΔC − h·JV|. The part proportional to h is gone.)");
  const double at_h = left_over(bob, bob.row(), h), at_half = left_over(bob, bob.row(), h / 2);
  const double factor = at_h / at_half, exact = 0.5 * set.speed * set.speed * h * h;
  page.predict(
      {.ask = course::say(
           R"(A bob flies past the fixed point at @ m/s. You halve the step h. By what factor does |ΔC −
                         h·JV| shrink?)",
           set.speed),
       .answer = factor,
       .unit = "1",
       .tolerance = 0.2,
       .wrong = {{2, "J already takes away the first-order part; the remainder is of second order."},
                 {8, "That would be third order: C of (2) is a square, its second derivative is not zero."},
                 {1, "Then the remainder would not depend on h at all."}},
       .hints = {"The first power of h is gone. Which is the lowest one left?",
                 "C of (2) after the step: ½(d + hv)² − ½L².",
                 "½(d + hv)² − ½d² = h d·v + ½h²v²; the first term is h·JV."},
       .hinted = 4,
       .right = course::say("The remainder is exactly ½h²v², here @ m²: half the step, a quarter of it.", exact)});
  const double first_order = 2 * J.matrix(0, 5) * pair.V2[2];
  page.text(
      R"(For two boxes the remainder is ½h²C̈ plus terms of higher order. Now spoil the row: change the sign of a₂, the
      mistake that d × r would make. @)",
      first_order != 0 ? course::say("The remainder gains 2h·a₂ω₂ = @·h, a term of *first* order.", first_order)
                       : "The remainder would gain 2h·a₂ω₂, but ω₂ = 0 here and it gains nothing.");

  renderer::Curve right{
      .label = "(14), two boxes", .style = renderer::CurveStyle::line_and_markers, .colour = palette::constraint};
  renderer::Curve simple{
      .label = "(14), a bob", .style = renderer::CurveStyle::line_and_markers, .colour = palette::velocity};
  renderer::Curve spoilt{.label = "a₂ with the wrong sign",
                         .style = renderer::CurveStyle::line_and_markers,
                         .colour = palette::force};
  renderer::Curve first{.label = "slope 1", .style = renderer::CurveStyle::theory};
  renderer::Curve second{.label = "slope 2", .style = renderer::CurveStyle::theory};
  const double large = 4 * h, spoilt_there = left_over(pair, wrong, large),
               right_there = left_over(pair, J, large);
  for (int halvings = 0; halvings <= 9; ++halvings) {
    const double step = std::ldexp(large, -halvings);
    for (renderer::Curve* curve : {&right, &simple, &spoilt, &first, &second}) curve->x.push_back(step);
    const auto drawn = [step](const Pair& moving, double rest) {
      return rest > rounding(moving, step) ? rest : NAN;
    };
    right.y.push_back(drawn(pair, left_over(pair, J, step)));
    simple.y.push_back(drawn(bob, left_over(bob, bob.row(), step)));
    spoilt.y.push_back(drawn(pair, left_over(pair, wrong, step)));
    first.y.push_back(3 * spoilt_there * step / large);
    second.y.push_back(right_there / 3 * step * step / (large * large));
  }
  const double small = h / 16, half = small / 2;
  const double curvature = pair.second_rate(), third = pair.third_rate_bound(small);
  const double measured_slope = std::log2(left_over(pair, J, small) / left_over(pair, J, half));
  const double spoilt_slope = std::log2(left_over(pair, wrong, small) / left_over(pair, wrong, half));
  // The rest is ½h²C̈ + r with |r| ≤ h³/6 · third and rounding: relative to the first term that is `share`.
  const double noise = rounding(pair, small);
  const double share = (third * small * small * small / 6 + noise) / (0.5 * std::abs(curvature) * half * half);
  const double error = 2 * std::abs(J.matrix(0, 5) * pair.V2[2]);
  const double spoilt_share =
      (0.5 * std::abs(curvature) * small * small + third * small * small * small / 6 + noise) / (error * half);
  const auto slope_tolerance = [](double part) { return part < 0.5 ? std::log2((1 + part) / (1 - part)) : 1.0; };

  const bool second_order = share < 0.2, first_order_seen = spoilt_share < 0.2;
  const std::string of_right = second_order ? "slope 2 for the right row"
                                            : "no single slope for the right row over this range of h",
                    of_spoilt = first_order == 0 ? "and the same for the spoilt row, as ω₂ = 0"
                                : first_order_seen
                                    ? "slope 1 for the row with one wrong sign"
                                    : course::say(
                                          "and slope 1 for the spoilt row only below h ≈ @ s, where "
                                          "2h|a₂ω₂| exceeds ½h²|C̈|",
                                          course::Value(2 * error / std::abs(curvature), 1));
  page.figure(
      "slopes",
      course::say("What J misses of ΔC, for smaller and smaller steps: @, @. Points below rounding are left out.",
                  of_right, of_spoilt),
      {.x = {.label = "step h (s)", .scale = renderer::Scale::logarithmic},
       .y = {.label = "|ΔC − h·JV| (m²)", .scale = renderer::Scale::logarithmic},
       .curves = {spoilt, right, simple, first, second}});
  page.text(
      R"(This is the cheapest test of a constraint: it needs C and J and nothing else. It finds every wrong entry *that
      the motion uses*. With ω₂ = 0 a wrong a₂ goes unnoticed@, so test with a V that has no zero component.)",
      first_order == 0 ? ", as in this run" : " (set `spin` to 0 and the two lines coincide)");

  if (second_order) page.measure("slope with (14)", measured_slope, "1");
  if (first_order_seen) page.measure("slope with a₂ of the wrong sign", spoilt_slope, "1");
  page.claim("remainder of the bob at h", at_h, "m²",
             is(exact, "½h²v² on paper", course::absolute(1e-12 * exact + rounding(bob, h))));
  page.claim("remainder of the boxes, over h²", left_over(pair, J, small) / (small * small), "m²/s²",
             is(std::abs(curvature) / 2, "½|C̈| from the accelerations of the arms",
                course::absolute(third * small / 6 + noise / (small * small))));
  page.claim("slope with (14)", measured_slope, "1", is(2, "Taylor", course::absolute(slope_tolerance(share))),
             course::Condition{share < 0.2, "C̈ not close to 0"});
  page.claim("slope with a₂ of the wrong sign", spoilt_slope, "1",
             is(1, "2h|a₂ω₂| remains", course::absolute(slope_tolerance(spoilt_share))),
             course::Condition{spoilt_share < 0.2, "a₂ω₂ well above hC̈"});
}

}  // namespace byhand::lesson01
