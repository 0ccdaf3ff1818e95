// Deeper: a tolerance in place of a step.

#include "lessons/09_what_accuracy_costs/steps.hpp"
#include "lessons/09_what_accuracy_costs/survey.hpp"
#include "lessons/laws/closed_forms.hpp"
#include "lessons/laws/doubling.hpp"

namespace byhand::accuracy {
namespace {

constexpr double span = 2;  // that a scene is watched [s]
constexpr int looks = 4;

/// A scene, and where its bodies really are at each look.
struct Watched {
  Problem problem;
  std::vector<std::vector<Eigen::Vector3d>> places;

  explicit Watched(const Problem& watched) : problem(watched) {
    const auto exact = problem.scene().exact(problem);
    for (int i = 1; i <= looks; ++i) places.push_back(exact(i * span / looks).positions);
  }
};

struct Tried {
  double error = 0;               // largest distance of a centre from its place at any look [m]
  double substeps = 0, cost = 0;  // in instructions
};

/// A run in steps of at most `step` [s]; infinitely wrong where a step has no solution. Its cost by the prices of
/// that name, if it is given.
Tried tried(const Watched& watched, const Method& method, double step, std::string_view prices = "") {
  AnyScene scene = watched.problem.start();
  scene.use(method);
  const long steps = std::max(1L, std::lround(span / looks / step));
  Tried run;
  try {
    for (const auto& places : watched.places) {
      for (long i = 0; i < steps; ++i) scene.step(span / looks / static_cast<double>(steps));
      run.error = std::max(run.error, scene.farthest_from(places));
    }
  } catch (const std::runtime_error&) {
    return {INFINITY, 0, 0};
  }
  run.cost = cost_of(scene.effort(), prices_of(scene.row_kind(), prices));
  run.substeps = static_cast<double>(scene.effort().substeps);
  return run;
}

/// A method's errors over its tolerances.
struct Tolerances {
  std::string name;
  std::vector<double> tolerances, errors;

  /// The power of the tolerance to which the error is proportional.
  Order slope() const { return fitted_power(tolerances, errors).value_or(Order{NAN, NAN}); }
};
template <class Base>
Tolerances asked(const Page& page, const Watched& watched, std::string name) {
  const std::vector<double> tolerances{1e-3, 1e-4, 1e-5, 1e-6, 1e-7};
  return {std::move(name), tolerances, page.side_by_side(static_cast<int>(tolerances.size()), [&](int i) {
            const Controlled<Base> method{tolerances[static_cast<std::size_t>(i)]};
            return tried(watched, method, span).error;
          })};
}

}  // namespace

void accuracy_as_the_input(Page& page) {
  const Problem problem("double_pendulum", {{"length", 2}, {"mass", 3}, {"end_mass", 3}});
  const Watched watched(problem);
  page.text(
      R"(So far you gave a step and got an error, and you know that error only where you know the true motion. Turn it
      round, as a driver does who slows down for bends: give the error, and let the method find its steps. The
      *tolerance* is an error for each second of motion. With 0.001 m/s a body may be a millimetre further off after
      each second.)");
  page.text(
      R"(Each substep h is made, and its error e is estimated. If e is larger than the tolerance times h, the substep is
      taken back and a shorter one is tried. Otherwise the next one may be longer. RATTLE needs no further solve for e:
      the substep moved the body by h times the mid-step velocity; e is the distance from there to where the mean of
      the velocities at both ends would have put it. Generalised coordinates use a pair of rules by Fehlberg. Five slopes give a rule of order
      4, a sixth slope gives one of order 5, and e is the difference. A rotation is measured by the arc at the radius of
      gyration, so e is in metres for every body.)");
  const Tolerances rattle = asked<Rattle>(page, watched, "RATTLE"),
                   joints = asked<Generalised>(page, watched, "generalised coordinates");
  const Tried fixed = tried(watched, Rattle{}, frame);
  renderer::Chart chart{
      .title = title_of(problem),
      .x = {.label = "tolerance (m/s)", .scale = renderer::Scale::logarithmic},
      .y = {.label = say("largest error in @ s (m)", span), .scale = renderer::Scale::logarithmic}};
  std::string slopes;
  for (const Tolerances& method : {rattle, joints}) {
    chart.curves.push_back(
        {.label = method.name,
         .x = method.tolerances,
         .y = method.errors,
         .style = renderer::CurveStyle::line_and_markers,
         .place = pictures::place_of(method.name == rattle.name ? "RATTLE" : "generalised RK4")});
    const Order fit = method.slope();
    slopes +=
        say("\n- @: tolerance to the power @ ± @. The error @ the tolerance.", method.name, Value(fit.slope, 3),
            Value(fit.uncertainty, 1), std::abs(fit.slope - 1) < 0.1 ? "follows" : "does not follow");
  }
  chart.curves.push_back(
      {.label = "tolerance × time", .x = rattle.tolerances, .y = {}, .style = renderer::CurveStyle::theory});
  for (const double tolerance : rattle.tolerances) chart.curves.back().y.push_back(tolerance * span);
  chart.references = {
      {.axis = renderer::Reference::Across::y, .value = fixed.error, .label = "RATTLE, one step a frame"}};
  page.figure("tolerance", R"(Error over tolerance. A fixed step has no tolerance, so its line is level.)", chart);
  page.text("Over these five tolerances the error goes as:\n" + slopes);
  for (const Tolerances& method : {rattle, joints}) {
    page.claim("error over tolerance, " + method.name + ": slope", method.slope().slope, "1",
               is(1, "controlled per second", absolute(0.1)));
    double most = 0;
    for (std::size_t i = 0; i < method.errors.size(); ++i)
      most = std::max(most, method.errors[i] / (method.tolerances[i] * span));
    page.claim("largest error over tolerance × time, " + method.name, most, "1",
               is_at_most(10, "the scene's own amplification of a disturbance is extra"));
  }

  const double tolerance = 1e-3;
  const Tried own = tried(watched, Controlled<Rattle>{tolerance}, span, "RATTLE to a tolerance");
  const auto with_substeps = [&](int count) { return tried(watched, Rattle{.substeps = count}, span, "RATTLE"); };
  int enough = 1, few = 0;  // substeps between two looks that are as good, and that are not
  while (enough < 100'000 && with_substeps(enough).error > own.error) few = enough, enough *= 2;
  while (enough - few > 1) {
    const int middle = (few + enough) / 2;
    (with_substeps(middle).error > own.error ? few : enough) = middle;
  }
  const Tried best = with_substeps(enough);
  const double ratio = own.cost / best.cost;
  page.text(
      R"(Does that cost more? At @ m/s RATTLE is @ m off at most, for @ instructions, rejected substeps included. The fewest fixed substeps that are as good are @ a second, for @ instructions. @)",
      course::typed(tolerance), Value(own.error, 2), Value(own.cost, 3), enough / (span / looks),
      Value(best.cost, 3),
      ratio < 0.9   ? say("So the tolerance costs @ % less.", Value(100 * (1 - ratio), 2))
      : ratio > 1.3 ? say("So the tolerance costs @ times as much, if you know that number.", Value(ratio, 2))
                    : std::string("So the tolerance costs about as much."));
  page.claim("cost of the tolerance over that of the best fixed step", ratio, "1",
             is_at_most(1.3, "the estimate costs no solve"));

  const Watched heavy(Problem("chain", {{"links", 10}, {"end_mass", 1000}}));
  std::string refused;
  int refusals = 0;
  for (int count = 1; count <= 16; count *= 2)
    if (!std::isfinite(tried(heavy, Rattle{.substeps = count}, frame).error))
      refused += (refusals++ ? " or " : "") + std::to_string(count);
  const Tried controlled = tried(heavy, Controlled<Rattle>{tolerance}, span);
  page.text(
      R"(Its real advantage is robustness. Hang @ kg on a chain of @ links. With @ fixed substeps a frame, Newton's method
      finds no solution for RATTLE at some point. With a tolerance of @ m/s it makes @ substeps in @ s and is @ m off at
      most: a substep that has no solution is retried with a shorter one. The same number serves both scenes.)",
      heavy.problem["end_mass"], heavy.problem["links"], refused, course::typed(tolerance), controlled.substeps,
      span, Value(controlled.error, 2));
  page.claim("heavy chain: fixed numbers of substeps without a solution", refusals, "1",
             is_at_least(1, "Newton's method does not converge"));
  page.claim("heavy chain with a tolerance: error over tolerance × time", controlled.error / (tolerance * span),
             "1", is_at_most(10, "the tolerance"));

  const double beta = 0.2, gap = 0.1, coarse = laws::doubling_difference(beta, 1e-2, gap),
               fine = laws::doubling_difference(beta, 1e-5, gap);
  page.text(
      R"(Could Baumgarte's method have a tolerance, too? Make a step once, and again as two of half its length, and
      compare. Of a gap C the one step leaves (1 − β)C and the two leave (1 − β)²C. They differ by β(1 − β)C, and there
      is no h in it. For β = @ and C = @ m the difference is @ m at h = 0.01 s and @ m at h = 0.00001 s. So no step is
      short enough for a smaller tolerance: a fixed β per step does not converge as h goes to 0; RATTLE does.)",
      beta, gap, Value(coarse, 3), Value(fine, 3));
  page.claim("Baumgarte: a step against its two halves, h = 0.01 s", coarse, "m",
             is(laws::difference_of_a_doubled_step(beta, gap), "β(1 − β)C", relative(1e-6)));
  page.claim("the same, h = 0.00001 s", fine, "m",
             is(laws::difference_of_a_doubled_step(beta, gap), "β(1 − β)C", relative(1e-6)));
}

}  // namespace byhand::accuracy
