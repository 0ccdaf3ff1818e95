#include "lessons/01_jacobian/picture.hpp"

// (3) to (8): a rate is linear in the velocities, and its coefficients are one row J with four parts.
namespace byhand::lesson01 {
namespace {

//! [four products]
/// (8) as it is printed: l₁·v₁ + a₁·ω₁ + l₂·v₂ + a₂·ω₂, for bodies in the plane.
double four_products(const Jacobian<PlaneBody, 1>& J, const Velocity<PlaneBody>& V1,
                     const Velocity<PlaneBody>& V2) {
  const Linear<PlaneBody> v1 = V1.head<2>(), v2 = V2.head<2>();
  const double w1 = V1[2], w2 = V2[2];
  return J.l1().dot(v1) + J.a1()(0, 0) * w1 + J.l2().dot(v2) + J.a2()(0, 0) * w2;
}
//! [four products]

/// Ċ of a bob at d from a resting anchor that moves at `v`, from differences of C [m²/s].
double rate_by_differences(const Linear<PlaneBody>& d, const Linear<PlaneBody>& v, double step) {
  Pair pair{{{0, 1, {}}, d.norm()}, {}, {}, {0, 0, 0}, {v.x(), v.y(), 0}};
  pair.pose2.position = d;
  return difference(pair, step);
}

}  // namespace

void one_row(course::Page& page, const Settings& set) {
  const double length = set.length, speed = set.speed;
  page.text(
      R"(We want C = 0 at all times. C is not linear in the positions, so solving C = 0 for them is hard. Its rate is
      easier: if C is zero now and does not change, it stays zero.)");
  page.equation(3);
  page.text(
      R"(Why is the rate easier? C changes only because the bodies move. Move one of them along x at 1 m/s, alone,
      and C changes at some rate; at 2 m/s it changes twice as fast. If it moves in two ways at once, the rates add.
      So Ċ is a sum: each component of velocity times a number that says how much C depends on it. Put the velocities
      in a column V = (v₁, ω₁, v₂, ω₂) and the numbers, in the same order, in a row J: the sum is their product.)");
  page.equation(4);
  page.text("(4) says two things. Ċ = JV is true of every motion; = 0 is what the constraint demands of it.");

  page.derivation(
      "Ċ = JV, by the chain rule",
      {{"C depends on time through six coordinates q₁, …, q₆ (x, y and angle of each body)",
        "C = C(q₁(t), …, q₆(t))", R"(C = C(q_1(t), \dots, q_6(t)))"},
       {"the chain rule", "Ċ = ∂C/∂q₁ · q̇₁ + … + ∂C/∂q₆ · q̇₆",
        R"(\dot C = \frac{\partial C}{\partial q_1}\,\dot q_1 + \dots + \frac{\partial C}{\partial q_6}\,\dot q_6)"},
       {"the rates of the coordinates are the velocities", "(q̇₁, …, q̇₆) = V = (v₁, ω₁, v₂, ω₂)",
        R"((\dot q_1, \dots, \dot q_6) = V = (v_1, \omega_1, v_2, \omega_2))"},
       {"the slopes, in the same order, are the row J", "Ċ = JV", R"(\dot C = JV)"}});
  page.text(
      R"(J is the *Jacobian* of C. V holds four velocities, a linear and an angular one of each body. So J has four
      parts, which the article calls l₁, a₁, l₂, a₂. (In (1) the same letters meant positions and angles. From here
      on they are the parts of J.))");
  page.equation(6);
  page.text("(The article writes the four parts below one another in (6); it means the row of (7).)");
  page.equation(7);
  page.text(
      R"(Multiplied out, a row times a column is four dot products. In the plane ω and a are single numbers.)");
  page.equation(8);
  page.excerpt("lessons/01_jacobian/one_row.cpp", "four products");

  const Linear<PlaneBody> slope = length * Linear<PlaneBody>(0.6, -0.8), v = Linear<PlaneBody>::Constant(speed);
  const double rate = slope.dot(v), step = 1e-3 * length / speed;
  page.predict(
      {.ask =
           course::say(R"(A bob on a rod whose other end is fixed. Move the bob at 1 m/s along x and C changes at @
                         m²/s; at 1 m/s along y it changes at @ m²/s. Now it moves at (@, @) m/s. How large is
                         Ċ?)",
                       slope.x(), slope.y(), speed, speed),
       .answer = rate,
       .unit = "m²/s",
       .tolerance = 0.02 * length * speed,
       .wrong = {{1.4 * length * speed, "One of the two rates is negative; add them with their signs."},
                 {slope.x() + slope.y(), "That is for 1 m/s along both axes."}},
       .hints = {"What does each component of the velocity contribute by itself?",
                 "(8) with v₁ = 0 and no turning: Ċ = l₂·v₂.",
                 course::say("@ · @ + (@) · @ = …", slope.x(), speed, slope.y(), speed)},
       .right = R"(The two measured rates are the part l₂ of the row. Once J is known, every motion's Ċ is a sum of
                products.)"});
  page.text(
      R"(The same row also works in the other direction. J says how velocities change C; as a column, Jᵀ says in which directions to push
      the bodies to change C, and one number λ says how hard. In the article this comes before (6):)");
  page.equation(5);
  page.text(
      R"(So λl₁ pushes body 1 and λa₁ turns it; λl₂ and λa₂ do the same to body 2. Lesson 2 asks how large λ must be.
      *The article calls Jᵀ "the inverse" of J. A row has no inverse; 7f says what Jᵀ is.* But first we have to find J.)");

  const Pair pair = pair_of(set);
  const double speeds = pair.V1.norm() + pair.V2.norm();
  page.claim("Ċ of the bob of the question", rate, "m²/s",
             is(rate_by_differences(slope, v, step), "differences of C along the motion",
                course::absolute(1e-11 * length * speed)));
  page.claim("(8) for two turning boxes, four products", four_products(pair.row(), pair.V1, pair.V2), "m²/s",
             is(pair.rate(), "JV as the solver computes it",
                course::absolute(1e-14 * pair.row().matrix.norm() * speeds)));
}

}  // namespace byhand::lesson01
