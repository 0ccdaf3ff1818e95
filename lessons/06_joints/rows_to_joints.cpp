// Step 1: a joint is a system of constraints, and what else it does is a bound.

#include "lessons/06_joints/mechanism.hpp"
#include "lessons/06_joints/number_grid.hpp"
#include "lessons/06_joints/rows_adding_up.hpp"
#include "lessons/06_joints/samples.hpp"
#include "lessons/06_joints/steps.hpp"
#include "lessons/scenes/rod.hpp"
#include "solver/constraints/motor.hpp"
#include "solver/constraints/slider.hpp"
#include "solver/constraints/weld.hpp"

namespace byhand::joints {
namespace {

constexpr double first_angle = 0.35, second_angle = -0.9;  // of the two bars [rad]

/// Two equal bars that meet at the origin.
Bodies<PlaneBody> two_bars(const Setting& setting) {
  Scene<PlaneBody> scene;
  const auto add = [&](const Point& from, const Point& to) {
    const PlaneRod bar(from, to, setting.mass);
    scene.add_body(bar.pose, bar.mass);
  };
  const double L = setting.length;
  add(-L * Point(std::cos(first_angle), std::sin(first_angle)), {0, 0});
  add({0, 0}, L * Point(std::cos(second_angle), std::sin(second_angle)));
  return scene.bodies();
}

/// A joint's matrices between the two bars, and how far JV is from the slope of C.
struct Matrices {
  Eigen::MatrixXd J, A;
  double slope_error;
};

template <class Kind>
Matrices matrices_of(const Bodies<PlaneBody>& bodies, const Kind& joint) {
  const Pose<PlaneBody>&pose1 = bodies.pose[0], &pose2 = bodies.pose[1];
  const auto J = joint.jacobian(pose1, pose2);
  const auto W = times_inverse_mass(J, bodies.inverse_mass[0], pose1, bodies.inverse_mass[1], pose2);
  const Velocity<PlaneBody> V1(0.3, -0.7, 0.9), V2(-0.5, 0.2, -1.1);
  const double t = 1e-5;
  const auto C = [&](double time) {
    return joint.template value<double>(moved<PlaneBody, double>(pose1, V1, time),
                                        moved<PlaneBody, double>(pose2, V2, time));
  };
  return {J.matrix, inverse_effective_mass(J, W),
          ((C(t) - C(-t)) / (2 * t) - dot(J, V1, V2)).cwiseAbs().maxCoeff()};
}

/// A of a weld by its closed form: the masses on the diagonal, and every arm once with each axis.
Eigen::Matrix3d weld_by_hand(const Bodies<PlaneBody>& bodies) {
  Eigen::Matrix3d A = Eigen::Matrix3d::Zero();
  for (int i = 0; i < 2; ++i) {
    const Point r = -bodies.pose[i].position;
    const Eigen::Vector3d turn(-r.y(), r.x(), 1);  // r × e_x, r × e_y, and the turn itself
    A += bodies.inverse_mass[i].angular[0] * turn * turn.transpose();
    A.diagonal().head<2>().array() += bodies.inverse_mass[i].linear;
  }
  return A;
}

struct Column {
  std::string name, bound;
  Matrices matrices;
  std::vector<std::string> rows;
};

void draw_column(Canvas& canvas, const Column& column, const Bodies<PlaneBody>& bodies, double length,
                 const Rectangle& frame) {
  const bool slides = column.name == "slider", turns = column.name == "stop, motor";
  canvas.text({frame.centre().x(), frame.top() - 14}, column.name, {.size = 24, .bold = true});
  canvas.text({frame.centre().x(), frame.top() - 44}, column.bound, {.size = 17, .colour = palette::muted});
  const auto [picture, numbers] = Rectangle{frame.x, frame.y, frame.width, frame.height - 60}.split_rows(0.40, 0);
  canvas.look(fit({-length, -0.8 * length, 1.7 * length, 1.0 * length}, picture, 12));
  const Bar first = bar_of(bodies.pose[0], length), second = bar_of(bodies.pose[1], length);
  if (slides) draw_rail(canvas, {0, 0}, first_angle, 0.45 * length);
  draw_bar(canvas, first);
  draw_bar(canvas, second);
  if (column.name == "weld")
    draw_weld(canvas, {0, 0});
  else if (slides)
    draw_sleeve(canvas, {0, 0}, first_angle);
  else
    canvas.hinge({0, 0});
  if (turns) draw_turn(canvas, {0, 0}, first_angle, second_angle, 0.45 * length, {palette::force, 3});
  canvas.look_at_page();
  const Point cell((frame.width - 26) / 6, 38);
  const Point at(frame.x + 26, numbers.top() - 20);
  draw_grid(canvas, column.matrices.J, at, cell, {{"ẋ₁", "ẏ₁", "ω₁", "ẋ₂", "ẏ₂", "ω₂"}, column.rows});
  canvas.text({frame.x, at.y() + 12}, "J", {.size = 20, .anchor = Anchor::left, .bold = true});
  const Point below(at.x() + 1.5 * cell.x(), at.y() - 3 * cell.y() - 50);
  canvas.text({below.x() - 26, below.y() + 12}, "A", {.size = 20, .anchor = Anchor::left, .bold = true});
  draw_grid(canvas, column.matrices.A, below, cell, {column.rows, column.rows});
}

}  // namespace

void rows_to_joints(const Setting& setting, Page& page) {
  const Bodies<PlaneBody> bodies = two_bars(setting);
  const Linear<PlaneBody> here(0, 0), along(std::cos(first_angle), std::sin(first_angle));
  const std::vector<Column> columns{
      {"pin", "two rows", matrices_of(bodies, pin<PlaneBody>(bodies, 0, 1, here)), {"x", "y"}},
      {"weld", "three rows", matrices_of(bodies, weld<PlaneBody>(bodies, 0, 1, here)), {"x", "y", "φ"}},
      {"slider", "two rows", matrices_of(bodies, slider<PlaneBody>(bodies, 0, 1, here, along)), {"n", "φ"}},
      {"stop, motor",
       "one row, beside a pin's two",
       matrices_of(bodies, motor<PlaneBody>(turn<PlaneBody>(bodies, 0, 1), 0, 0)),
       {"φ"}}};
  const Eigen::MatrixXd &pin_A = columns[0].matrices.A, &weld_A = columns[1].matrices.A;
  const double length = setting.length;

  page.text(
      R"(The article says it in one sentence: a system of constraints can form a joint. Put two bars of @ m and @ kg end
      to end and ask that the two ends, P₁ and P₂, stay together. That is C = P₂ − P₁ = 0, a *vector*: one row for each
      axis of the world. Differentiate and isolate V, and each row has the form of (14), (15) and (16), along e_x or
      e_y:)",
      setting.length, setting.mass);
  page.excerpt("solver/constraints/pin.hpp", "jacobian");
  page.text(
      R"(That is a **pin**. Add φ̇ = ω₂ − ω₁ = 0, the row [0 −1 0 1], so that the bars do not turn relative to each other,
      and you have a **weld**. Keep that row and one across a rail, and you have a **slider**, free along the rail. For K
      rows (17) becomes K equations for K numbers, and the effective mass a K × K block: A = JM⁻¹Jᵀ is inverted as a
      whole.)");
  rows_adding_up(setting, page);
  page.figure(
      "joints",
      say(R"(Two bars of @ m and @ kg, three joints and the row of a stop or motor: above J, with a column for each
                  velocity, below A = JM⁻¹Jᵀ (1/kg, 1/(kg m) and 1/(kg m²)). Rows: x and y of
                  the world, n across the rail, φ the turn.)",
          setting.length, setting.mass),
      [=](Canvas& canvas) {
        const Rectangle paper = canvas.page().inset(18, 16);
        const auto cells = paper.is_high() ? paper.cells(2, 2, 22) : paper.cells(1, 4, 22);
        for (std::size_t i = 0; i < columns.size(); ++i) draw_column(canvas, columns[i], bodies, length, cells[i]);
      });
  page.text(
      R"(Look at A. An entry off the diagonal says what one row does to the other: here @ 1/kg between the pin's x and y.
      An impulse at one end along x also turns the bar, and so moves its end along y. For a pin at the *centres* of two
      bodies these entries would be zero; with long arms and small inertia the rows disturb each other a lot. The next
      step shows what that costs.)",
      Value(pin_A(0, 1), 3));
  page.text(
      R"(The other joints need no new rows, only *bounds* on λ, as for a contact. The turn's row [0 −1 0 1] with 0 ≤ λ
      is a **stop**: it pushes back at the end of the range and never pulls. With a speed as its target and |λ| ≤ τh
      it is a **motor** of strength τ. A rod's row with λ ≥ 0 for its pull is a **rope**.)");
  page.sequence(
      "six_joints",
      say(R"(The motions that joints leave free: three equations, then three bounds. The stop is at @°, the motor turns
          once in the film, the rope is slack where it is dotted.@ Straight and curved arrows: the joint's force and
          torque on the
          bar (λ/h).)",
          Value(degrees(sample_stop), 3),
          std::abs(sample_pace(length) - 1) < 0.05
              ? ""
              : say(" Shown @ times as fast as it is.", Value(sample_pace(length), 2))),
      Seconds{sample_seconds},
      [samples = Samples(setting)](Canvas& canvas, double time) mutable { samples.draw(canvas, time); });

  const std::vector<int> free{6 - static_cast<int>(pin_A.rows()), 6 - static_cast<int>(weld_A.rows())};
  page.text(
      R"(Two bodies in the plane have six velocities. A pin takes two of them and leaves @; a weld takes three and leaves
      @: the two bodies move as one.)",
      free[0], free[1]);
  double slope_error = 0;
  for (const Column& column : columns) slope_error = std::max(slope_error, column.matrices.slope_error);
  page.claim("JV beside the slope of C, largest difference over the four joints", slope_error, "m/s, rad/s",
             is(0, "difference quotient of C along V", absolute(1e-8 * std::max(1.0, length))));
  page.claim("A of the weld, largest difference relative to its largest entry",
             (weld_A - weld_by_hand(bodies)).cwiseAbs().maxCoeff() / weld_A.cwiseAbs().maxCoeff(), "1",
             is(0, "Σ 1/m on x and y, Σ (r × e)(r × e)ᵀ/I", absolute(1e-14)));
  page.claim("A of the pin beside the first two rows of the weld's, largest difference",
             (weld_A.topLeftCorner<2, 2>() - pin_A).cwiseAbs().maxCoeff(), "1/kg",
             is(0, "the same two rows", absolute(0)));
}

}  // namespace byhand::joints
