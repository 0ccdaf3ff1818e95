// Deeper: a shoulder, whose arm is bounded in swing and in twist, and the sign of a quaternion.

#include "lessons/07_space/steps.hpp"
#include "lessons/pictures/space_scene.hpp"
#include "solver/constraints/limit.hpp"
#include "solver/constraints/pin.hpp"

namespace byhand::space {

/// The mistake: φ from p as it comes, which is a full turn off where p_w < 0. (q0 of `rest` is 1 here.)
template <class M>
struct TwistAsItComes : byhand::Turn<M> {
  template <class T>
  T value(const Pose<M, T>& pose1, const Pose<M, T>& pose2) const {
    const T phi = byhand::Turn<M>::template value<T>(pose1, pose2);
    if (detail::value_of(T((inverse(pose1.rotation) * pose2.rotation).w())) >= 0) return phi;
    return phi - T(std::copysign(2 * pi, detail::value_of(phi)));
  }
};

namespace {

using Vector = Eigen::Vector3d;
using Quaternion = Eigen::Quaterniond;

constexpr double cone = 40, widest = 45, twisted = 30;  // the stops of swing and twist, the twist at first [deg]
constexpr double arm_seconds = 2, arm_length = 0.6, beta = 0.2;  // [s], of the arm [m], [1]

//! [twist]
/// φ about the unit vector a [rad] of an orientation p, the shorter way round.
double twist(Quaternion p, const Vector& a) {
  if (p.w() < 0) p.coeffs() *= -1;  // the same orientation
  return 2 * std::atan2(p.vec().dot(a), p.w());
}
//! [twist]

byhand::Turn<SpaceBody> turn_about(const Vector& axis) { return {0, 1, Quaternion::Identity(), axis}; }
Swing<SpaceBody> swing_of() { return {0, 1, Vector::UnitX(), Vector::UnitX()}; }

/// A run of the arm.
struct Run {
  std::vector<double> time, twist;       // [s], counted on over whole turns [rad]
  std::vector<Pose<SpaceBody>> pose;     // of the arm
  double swung = 0, passed = -INFINITY;  // largest swing, and by how much a stop was passed at most [rad]
  double fastest = 0;                    // [rad/s]
  double pushed = 0, rate = 0;  // in the first step: the twist's lower stop [N m s], φ̇ after it [rad/s]
};

/// An arm that falls from its rest direction, level and twisted, with the torso's orientation 1 or −1.
template <template <class> class Twist>
Run let_fall(const Setting& setting, double sign) {
  Simulation<SpaceBody> arm{{}, {Direct{}, Baumgarte{beta}}};
  arm.method.gyroscopic = Gyroscopic::implicit;
  Pose<SpaceBody> torso, start;
  torso.rotation.coeffs() *= sign;
  start.rotation = space_rotation(Vector(radians(twisted), 0, 0));
  start.position = {arm_length / 2, 0, 0};
  const Vector omega(1, 3, 0);
  Velocity<SpaceBody> V;
  V << omega.cross(start.position), omega;
  auto& scene = arm.scene;
  scene.add_body(torso, fixed<SpaceBody>());
  scene.add_body(start, box<SpaceBody>(setting.mass, {arm_length, 0.14, 0.05}), V);
  const Twist<SpaceBody> phi{turn_about(Vector::UnitX())};
  scene.add(pin<SpaceBody>(scene.bodies(), 0, 1, Vector::Zero()));
  scene.add(at_most<SpaceBody>(radians(cone), swing_of()));
  const auto lower = scene.add(at_least<SpaceBody>(-radians(widest), phi));
  scene.add(at_most<SpaceBody>(radians(widest), phi));

  Run run;
  const auto& bodies = scene.bodies();
  const auto turned = [&] { return turn_about(Vector::UnitX()).value<double>(bodies.pose[0], bodies.pose[1]); };
  double before = turned(), total = before;
  const auto keep = [&] {
    const double now = turned();
    total += std::remainder(now - before, 2 * pi);
    before = now;
    run.time.push_back(arm.time);
    run.twist.push_back(total);
    run.pose.push_back(bodies.pose[1]);
    const double psi = swing_of().value<double>(bodies.pose[0], bodies.pose[1]);
    run.swung = std::max(run.swung, psi);
    run.passed = std::max({run.passed, psi - radians(cone), std::abs(now) - radians(widest)});
    run.fastest = std::max(run.fastest, bodies.velocity[1].tail<3>().norm());
  };
  keep();
  const auto J = phi.jacobian(torso, start);
  arm.step(setting.h);
  run.pushed = setting.h * arm.reaction(lower).torque2.norm();
  run.rate = dot(J, bodies.velocity[0], bodies.velocity[1])[0];
  for (keep(); arm.time < arm_seconds; keep()) arm.step(setting.h);
  return run;
}

/// How an arm turns that swings forwards, level to the side and down again, a quarter turn each.
struct Round {
  double twist = 0, summed = 0, about_itself = 0;  // at the end, ∫φ̇ dt, ∫b·ω dt [rad]
};
Round three_quarters() {
  constexpr int parts = 90;
  const Vector down = -Vector::UnitY();
  const byhand::Turn<SpaceBody> phi = turn_about(down);
  Round round;
  Pose<SpaceBody> torso, arm;
  for (const Vector& axis : {Vector(0, 0, 1), Vector(0, -1, 0), Vector(1, 0, 0)})
    for (int i = 0; i < parts; ++i) {
      const Vector turn = pi / 2 / parts * axis;
      arm.rotation = rotated_by(arm.rotation, turn);
      round.about_itself += turn.dot(rotate(arm.rotation, down));
      round.summed += turn.dot(phi.jacobian(torso, arm).matrix.row(0).tail<3>());
    }
  round.twist = twist(arm.rotation, down);
  return round;
}

/// The largest differences at random poses and velocities, of either sign of p.
struct Differences {
  double slope = 0, halfway = 0, twist = 0;  // of Ċ from JV [rad/s], of J from (a + b)/(1 + a·b), of φ [rad]
};
Differences at_random_poses() {
  Differences found;
  const auto enlarge = [](double& largest, double by) { largest = std::max(largest, std::abs(by)); };
  for (int i = 1; i <= 200; ++i) {
    const auto drawn = [i](double step) { return std::sin(step * i * i); };
    Pose<SpaceBody> torso, arm;
    torso.rotation = Quaternion(drawn(1), drawn(2), drawn(3), drawn(5)).normalized();
    arm.rotation = Quaternion(drawn(7), drawn(11), drawn(13), drawn(17)).normalized();
    Velocity<SpaceBody> V1, V2;
    V1 << 0, 0, 0, drawn(19), drawn(23), drawn(29);
    V2 << 0, 0, 0, drawn(31), drawn(37), drawn(41);
    const Quaternion p = torso.rotation.conjugate() * arm.rotation;
    const Vector axis = Vector(drawn(43), drawn(47), drawn(53)).normalized();
    const Vector a = torso.rotation * axis, b = arm.rotation * axis;
    if (std::abs(a.dot(b)) > 0.8) continue;  // near ψ = 0 the swing has no gradient, near half a turn the twist
    const auto stop = at_most<SpaceBody>(radians(widest), turn_about(axis));
    const auto round = at_most<SpaceBody>(radians(cone), Swing<SpaceBody>{0, 1, axis, axis});
    const auto J = stop.jacobian(torso, arm);
    const auto compare = [&](const auto& limit) {
      const double rate = limit.template value<Jet>(on_its_way(torso, V1), on_its_way(arm, V2))[0].rate;
      enlarge(found.slope, rate - dot(limit.jacobian(torso, arm), V1, V2)[0]);
    };
    compare(stop);
    compare(round);
    enlarge(found.halfway, (J.matrix.row(0).tail<3>().transpose() + (a + b) / (1 + a.dot(b))).norm());
    enlarge(found.twist, twist(p, axis) - stop.at.value<double>(torso, arm));
  }
  return found;
}

void draw_runs(Canvas& canvas, const Run& run, const Chart& chart) {
  const auto [left, right] = canvas.page().inset(20).panels(0.42, 16);
  Space space(pictures::from_aside({0.26, -0.14, 0}, 0.5, left, 0.45, 0.3));
  space.sphere({0, 0, 0}, 0.05, palette::fixed);
  const double turn = radians(cone);
  pictures::add_ring(space, {arm_length * std::cos(turn), 0, 0}, Vector::UnitX(), arm_length * std::sin(turn),
                     0.006, palette::theory);
  const std::size_t last = run.pose.size() - 1;
  for (const std::size_t i : {std::size_t{0}, last})
    pictures::add_book(space, run.pose[i], {arm_length, 0.14, 0.05},
                       mix(palette::paper, palette::body, i == 0 ? 0.5 : 1));
  space.arrow({0, 0, 0}, {1.15 * arm_length, 0, 0}, 0.008, palette::constraint);
  canvas.draw(space);
  canvas.text(space.project({1.15 * arm_length, 0, 0}), "a",
              {.size = 20, .colour = palette::constraint, .halo = 3, .offset = {14, 0}});
  renderer::draw(canvas, chart, right.lowered(40));
}

}  // namespace

void swing_and_twist(const Setting& setting, Page& page) {
  const Run right = let_fall<byhand::Turn>(setting, -1), wrong = let_fall<TwistAsItComes>(setting, -1);
  const Round round = three_quarters();
  const Differences found = at_random_poses();
  const double read = radians(twisted - 360), beyond = -radians(widest) - read;

  page.text(
      R"(Each turn that a joint leaves free can be bounded by one row, a stop as in lesson 6. An arm has an axis b and,
      fixed in the torso, a rest direction a. *Swing* is the angle ψ between them: a stop at @° keeps the arm within a
      cone. cos ψ = a·b gives, by the triple product of lesson 1,)",
      cone);
  page.formula("J_ψ = [0,  −n,  0,  n],   n = a × b / |a × b|",
               R"(J_\psi = \begin{bmatrix} 0 & -n & 0 & n\end{bmatrix}, \quad n = \frac{a\times b}{|a\times b|})");
  page.text("*Twist* is the turn φ about the axis. Is its J made of b in the same way?");
  const double answer = degrees(std::abs(round.twist));
  page.predict(
      {.ask =
           R"(Let your arm hang, thumb forwards. Swing it forwards to level, then level to the side, then down, and
                 never turn it about its own axis. By how many degrees has the hand turned?)",
       .answer = answer,
       .unit = "deg",
       .tolerance = 5,
       .wrong = {{0, "b·ω was zero all the way. But where does your thumb point now?"},
                 {180, "Your thumb would point backwards. Try it."},
                 {270, "That adds up turns about three different axes."}},
       .hints =
           {"Try it. Where does the thumb point?",
            "The first and last swing pass through the rest direction, and only change ψ. About which axis is "
            "the one between them?",
            "About a, by a quarter turn: 360°/4 = …"},
       .right = "The thumb points outwards: the level swing is a turn about a, and φ sees it."});
  page.text(
      R"(So b·(ω₂ − ω₁) is not the rate of φ. The orientation p = q₁⁻¹q₂ = (p_w, p_v) of the arm, seen from the torso,
      is a twist about a and then a swing across a. The ratio of two of its numbers is the twist's alone:)");
  page.formula("tan ½φ = p_v·a/p_w,   J_φ = [0,  −g,  0,  g],   g = (a + b)/(1 + a·b)",
               R"(\tan\tfrac12\varphi = \frac{p_v\cdot a}{p_w}, \quad
                  J_\varphi = \begin{bmatrix} 0 & -g & 0 & g\end{bmatrix}, \quad g = \frac{a+b}{1+a\cdot b})");
  page.derivation(
      "Why g is (a + b)/(1 + a·b)",
      {{"swing (cos ½ψ, sin ½ψ u), u ⊥ a, times twist (cos ½φ, sin ½φ a)",
        "p_w = cos ½ψ cos ½φ,   z = p_v·a = cos ½ψ sin ½φ",
        R"(p_w = \cos\tfrac12\psi\cos\tfrac12\varphi, \quad z = p_v\cdot a = \cos\tfrac12\psi\sin\tfrac12\varphi)"},
       {"differentiate tan ½φ = z/p_w", "φ̇ = 2(p_w ż − z ṗ_w)/(p_w² + z²)",
        R"(\dot\varphi = \frac{2(p_w\dot z - z\dot p_w)}{p_w^2+z^2})"},
       {"ṗ = ½Ωp, Ω = ω₂ − ω₁", "φ̇ = Ω·(p_w² a + p_w p_v × a + z p_v)/(p_w² + z²)",
        R"(\dot\varphi = \Omega\cdot\frac{p_w^2 a + p_w\,p_v\times a + z\,p_v}{p_w^2+z^2})"},
       {"p turns a into b", "b = (2p_w² − 1)a + 2p_w p_v × a + 2z p_v",
        R"(b = (2p_w^2-1)a + 2p_w\,p_v\times a + 2z\,p_v)"},
       {"1 + a·b = 2 cos² ½ψ = 2(p_w² + z²)", "φ̇ = (a + b)/(1 + a·b)·Ω",
        R"(\dot\varphi = \frac{a+b}{1+a\cdot b}\cdot\Omega)"}});
  page.text(
      R"(g points halfway between a and b. Another mistake is a classic: p and −p are the same orientation, but
      2·acos(p_w) reads θ from one and 2π − θ from the other, and where p says φ = @°, −p says @°. So where p_w is
      negative, change the sign of p first: that is the shorter way round.)",
      twisted, twisted - 360);
  page.excerpt("lessons/07_space/swing_and_twist.cpp", "twist");

  Chart chart{.x = {.label = "time (s)"}, .y = {.label = "turned about its own axis (deg)"}};
  const auto add = [&](const char* name, const Run& of, int colour) {
    Curve curve{.label = name, .colour = palette::series(colour)};
    curve.x = of.time;
    for (const double turned : of.twist) curve.y.push_back(degrees(turned));
    chart.curves.push_back(std::move(curve));
  };
  add("p or −p, p_w ≥ 0", right, 0);
  add("p as it comes", wrong, 1);
  for (const double stop : {-widest, widest}) chart.references.push_back({Reference::Across::y, stop, {}});
  page.figure(
      "arm_with_stops",
      say(R"(Left: an arm, level and twisted by @° at first, falls onto the cone of its swing (ring). Right: its twist
          between stops at ±@° (dotted), with q₁ = −1 for the torso.)",
          twisted, widest),
      [=](Canvas& canvas) { draw_runs(canvas, right, chart); });
  const double way = wrong.twist.back() - wrong.twist.front();
  const Quantity passed("passed", right.passed, "rad"),
      cured("(ωh)²/2β", std::pow(right.fastest * setting.h, 2) / (2 * beta), "rad"), turned("turned", way, "rad");
  page.text(
      R"(No picture tells q₁ = −1 from 1. But read as it comes, the twist is @°, so the lower stop at −@° finds itself
      passed by @° and pushes at once, the wrong way: to @ rad/s in the first step. @ @)",
      twisted - 360, widest, Value(degrees(beyond), 4), Value(wrong.rate, 4),
      page.verdict({{.when = turned > pi,
                     .say = say("The arm goes the long way round, through its other stop, @° in all.",
                                Value(degrees(way), 3))}}),
      page.verdict(
          {{.when = passed <= cured,
            .say = say("With p_w ≥ 0 it passes its stops by @° at most: what a step along the tangent adds "
                       "and β leaves, as of lesson 4's rod.",
                       Value(degrees(right.passed), 2))}}));

  page.claim("twist of the arm that came back", degrees(round.twist), "deg",
             is(90, "a quarter turn about a", absolute(1e-9)));
  page.claim("the same, ∫g·ω dt", degrees(round.summed), "deg", is(90, "φ̇ = g·ω", absolute(1e-9)));
  page.claim("the same, ∫b·ω dt", degrees(round.about_itself), "deg", is(0, "no turn about b", absolute(1e-9)));
  page.claim("J of both stops, at random poses: JV from Ċ", found.slope, "rad/s",
             is(0, "J is the gradient of C", absolute(1e-12)));
  page.claim("the twist's: g from (a + b)/(1 + a·b)", found.halfway, "1",
             is(0, "the derivation", absolute(1e-12)));
  page.claim("plain φ from the solver's", found.twist, "rad", is(0, "Turn", absolute(1e-12)));
  page.claim("widest swing", degrees(right.swung), "deg",
             is(cone, "it reaches the stop, and passes it by (ωh)²/2β", absolute(degrees(cured.value))));
  page.claim("push of the lower stop at first, p_w ≥ 0", right.pushed, "N m s",
             is(0, say("@° from the stop", twisted + widest), absolute(0)));
  page.claim("the same, p as it comes: φ̇", wrong.rate, "rad/s",
             is(beta * beyond / setting.h, "−βC/h, but for the gyroscopic term", relative(0.01)));
}

}  // namespace byhand::space
