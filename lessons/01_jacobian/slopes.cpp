#include <algorithm>
#include <cmath>

#include "lessons/01_jacobian/picture.hpp"

// What J leaves over is of second order, and a wrong sign is not.
namespace byhand::lesson01 {
namespace {

namespace palette = renderer::palette;

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

void slopes(tutor::Page& page, const Settings& set) {
  const double h = set.h;
  const Pair pair = pair_of(set), bob = bob_of(set);
  const Jacobian<PlaneBody, 1> J = pair.row();
  Jacobian<PlaneBody, 1> wrong = J;
  wrong.matrix(0, 5) = -J.matrix(0, 5);

  page.text(
      R"(J promises how C will change: ΔC ≈ h·JV over a small step h. Keep the promise honest by looking at what is
      left over, |ΔC − h·JV|. A derivative takes away all that is proportional to h. What remains must go like
      h².)");
  const double at_h = left_over(bob, bob.row(), h), at_half = left_over(bob, bob.row(), h / 2);
  const double factor = at_h / at_half, exact = 0.5 * set.speed * set.speed * h * h;
  page.predict(
      {.ask = tutor::say(R"(A bob flies past its anchor at @ m/s. You halve the step h. By what factor does |ΔC −
                         h·JV| shrink?)",
                         set.speed),
       .answer = factor,
       .unit = "1",
       .tolerance = 0.2,
       .wrong = {{2, "J already took the first-order part away; what is left is second order."},
                 {8, "That would be third order: C of (2) bends, and bending is second order."},
                 {1, "Then the rest would not depend on h at all."}},
       .hints = {"Expand ½(d + hv)² by hand."},
       .right = tutor::say("For (2) and a bob the rest is exactly ½h²v², here @ m².", exact)});
  const double first_order = 2 * J.matrix(0, 5) * pair.V2[2];
  page.text(
      R"(For the bob you can do it on paper: ½(d + hv)² − ½d² = h d·v + ½h²v². For two turning boxes the rest is
      ½h²C̈ and a little more. Now spoil the row: turn the sign of a₂ round, the mistake that d × r would have
      made. The rest gains 2h·a₂ω₂ = @·h, @.)",
      first_order, first_order != 0 ? "a term of *first* order" : "nothing, for ω₂ is 0 here");

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
    right.y.push_back(left_over(pair, J, step));
    simple.y.push_back(left_over(bob, bob.row(), step));
    spoilt.y.push_back(left_over(pair, wrong, step));
    first.y.push_back(3 * spoilt_there * step / large);
    second.y.push_back(right_there / 3 * step * step / (large * large));
  }
  page.figure("slopes",
              R"(What J leaves over of ΔC, for ever smaller steps: slope 2 for the right row, slope 1 for a row
              with one wrong sign.)",
              {.x = {.label = "step h (s)", .scale = renderer::Scale::logarithmic},
               .y = {.label = "|ΔC − h·JV| (m²)", .scale = renderer::Scale::logarithmic},
               .curves = {spoilt, right, simple, first, second}});
  page.text(
      R"(This chart is the cheapest test a constraint can have. It needs C and J and nothing else, and no wrong
      entry survives it, *if the motion uses that entry*: with ω₂ = 0 a wrong a₂ goes unnoticed, so test with every
      velocity at work. Set `spin` to 0 and see the two lines become one.)");

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

  page.measure("slope with (14)", measured_slope, "1");
  page.measure("slope with a₂ of the wrong sign", spoilt_slope, "1");
  page.claim({.quantity = "rest of the bob at h",
              .unit = "m²",
              .expected = exact,
              .source = "½h²v² on paper",
              .measured = at_h,
              .tolerance = tutor::absolute(1e-12 * exact + rounding(bob, h))});
  page.claim({.quantity = "rest of the boxes, over h²",
              .unit = "m²/s²",
              .expected = std::abs(curvature) / 2,
              .source = "½|C̈| from the accelerations of the arms",
              .measured = left_over(pair, J, small) / (small * small),
              .tolerance = tutor::absolute(third * small / 6 + noise / (small * small))});
  page.claim({.quantity = "slope with (14)",
              .unit = "1",
              .expected = 2,
              .source = "Taylor",
              .measured = measured_slope,
              .tolerance = tutor::absolute(slope_tolerance(share)),
              .claimed = share < 0.2,
              .range = "C̈ not close to 0"});
  page.claim({.quantity = "slope with a₂ of the wrong sign",
              .unit = "1",
              .expected = 1,
              .source = "2h|a₂ω₂| remains",
              .measured = spoilt_slope,
              .tolerance = tutor::absolute(slope_tolerance(spoilt_share)),
              .claimed = spoilt_share < 0.2,
              .range = "a₂ω₂ well above hC̈"});
}

}  // namespace byhand::lesson01
