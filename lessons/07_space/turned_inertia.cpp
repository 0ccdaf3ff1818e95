// Step 2: the inertia of (18) belongs to the body, and turns with it.

#include <Eigen/LU>

#include "lessons/07_space/steps.hpp"
#include "lessons/pictures/space_scene.hpp"
#include "solver/constraints/pin.hpp"

namespace byhand::space {
namespace {

Eigen::Vector3d flight() { return {0, -3, 1.5}; }  // [m/s]

/// A body that flies by and is caught by the middle of its +y side on a nail at the origin.
struct Catch {
  Pose<SpaceBody> pose;
  InverseMass<SpaceBody> mass;
  Velocity<SpaceBody> after = Velocity<SpaceBody>::Zero();
  Eigen::Vector3d before_L, after_L;  // angular momentum about the nail [kg m²/s]
  double slip = 0;                    // how fast the point on the nail still moves [m/s]

  double lost() const { return (after_L - before_L).norm() / before_L.norm(); }
};

Bodies<SpaceBody> bodies_of(const Catch& caught, const Velocity<SpaceBody>& velocity) {
  Scene<SpaceBody> scene;
  scene.add_body(Pose<SpaceBody>(), fixed<SpaceBody>());
  scene.add_body(caught.pose, caught.mass, velocity);
  return scene.bodies();
}

/// Askew to the axes of the book.
Eigen::Vector3d tilt_axis() { return {0.6, 0.8, 0}; }

/// A box of `sides` [m], turned by `tilt` [rad] about `tilt_axis`.
Catch caught_on_a_nail(const Eigen::Vector3d& sides, double mass, double tilt, bool turned) {
  Catch caught;
  caught.mass = box<SpaceBody>(mass, sides);
  caught.pose.rotation = space_rotation(Angular<SpaceBody>(tilt * tilt_axis()));
  caught.pose.position = rotate(caught.pose.rotation, Eigen::Vector3d(0, -0.5 * sides.y(), 0));
  Velocity<SpaceBody> V = Velocity<SpaceBody>::Zero(), ground = V;
  V.head<3>() = flight();
  const Bodies<SpaceBody> bodies = bodies_of(caught, V);
  caught.before_L = angular_momentum(bodies);
  const Pin<SpaceBody> nail = pin<SpaceBody>(bodies, 0, 1, Linear<SpaceBody>(0, 0, 0));

  //! [caught]
  Pose<SpaceBody> seen = caught.pose;
  if (!turned) seen.rotation = Eigen::Quaterniond::Identity();  // the mistake
  const auto J = nail.jacobian(bodies.pose[0], caught.pose);
  const auto W = times_inverse_mass(J, fixed<SpaceBody>(), bodies.pose[0], caught.mass, seen);  // (18)
  const Rows<3> lambda = -inverse_effective_mass(J, W).inverse() * dot(J, ground, V);           // (17), b = 0
  apply_impulse(W, lambda, ground, V);                                                          // (20)
  //! [caught]

  caught.after = V;
  caught.after_L = angular_momentum(bodies_of(caught, V));
  caught.slip = dot(J, ground, V).norm();
  return caught;
}

//! [18]
/// M⁻¹Jᵀ for one side of a row, (18): `l` over the mass, and `a` by the inertia turned into the world.
Velocity<SpaceBody> divided_by_mass(const Eigen::Vector3d& l, const Eigen::Vector3d& a, double mass,
                                    const Eigen::Matrix3d& I, const Eigen::Matrix3d& R) {
  Velocity<SpaceBody> W;
  W << l / mass, R * I.inverse() * R.transpose() * a;
  return W;
}
//! [18]

/// How far that is from the solver's own, for a slanting row of the caught book.
double difference_from_the_solver(const Catch& caught, double mass) {
  const Eigen::Vector3d n = Eigen::Vector3d(1, -2, 0.5).normalized(), arm(0.3, -0.2, 0.7);
  Jacobian<SpaceBody, 1> J;
  set_row_along<SpaceBody, 1>(J, 0, n, Arm<SpaceBody>::Zero(), arm);
  const auto W = times_inverse_mass(J, fixed<SpaceBody>(), Pose<SpaceBody>(), caught.mass, caught.pose);
  const Eigen::Matrix3d I = caught.mass.angular.cwiseInverse().asDiagonal();
  const Velocity<SpaceBody> plain =
      divided_by_mass(n, arm.cross(n), mass, I, caught.pose.rotation.toRotationMatrix());
  return (W.matrix.row(0).tail<6>().transpose() - plain).norm() / plain.norm();
}

Chart over_tilt(double mass, double limit) {
  Chart chart{.x = {.label = "turned by (deg)", .range = {{0, limit}}}, .y = {.label = "change of L (%)"}};
  struct Body {
    const char* name;
    Eigen::Vector3d sides;
    bool turned;
  };
  for (const Body& body :
       {Body{"book, I not turned", book_sides(), false}, Body{"book, I turned: RIRᵀ", book_sides(), true},
        Body{"cube, I not turned", {0.8, 0.8, 0.8}, false}}) {
    Curve curve{.label = body.name};
    if (body.sides.x() == body.sides.z()) curve.style = CurveStyle::markers;
    for (double tilt = 0; tilt <= limit; tilt += curve.style == CurveStyle::markers ? 10 : 1) {
      curve.x.push_back(tilt);
      curve.y.push_back(100 * caught_on_a_nail(body.sides, mass, radians(tilt), body.turned).lost());
    }
    chart.curves.push_back(std::move(curve));
  }
  return chart;
}

void draw_catch(Canvas& canvas, const Catch& caught, const std::string& words, const Rectangle& frame) {
  const Rectangle below{frame.x, frame.y, frame.width, frame.height - 70};
  Space space(pictures::from_aside({-0.15, -0.3, 0}, 0.95, below, 0.25, 0.4));
  space.ground({0, -1.1, 0}, 2.2, 0.4);
  pictures::add_book(space, caught.pose, book_sides());
  space.sphere({0, 0, 0}, 0.05, palette::fixed);
  const double scale = 0.9 / caught.before_L.norm();
  const Point3 before = scale * caught.before_L, after = scale * caught.after_L;
  const bool changed = (after - before).norm() > 0.01;
  space.arrow({0, 0, 0}, before, 0.022, palette::theory);
  if (changed) space.arrow({0, 0, 0}, after, 0.022, palette::error);
  canvas.draw(space);
  canvas.text(space.project(before), changed ? "L before" : "L before and after",
              {.size = 20,
               .colour = palette::theory,
               .anchor = changed ? renderer::Anchor::top_left : renderer::Anchor::bottom_left,
               .halo = 3,
               .offset = {0, changed ? -16.0 : 14.0}});
  if (changed)
    canvas.text(
        space.project(after), "L after",
        {.size = 20, .colour = palette::error, .anchor = renderer::Anchor::bottom, .halo = 3, .offset = {0, 12}});
  canvas.text({frame.centre().x(), frame.top() - 16}, words, {.size = 21, .bold = true});
  canvas.text({frame.centre().x(), frame.top() - 46},
              say("held point @ m/s,  L changed by @ %", Value(caught.slip < 1e-9 ? 0 : caught.slip, 2),
                  Value(caught.lost() < 1e-9 ? 0 : 100 * caught.lost(), 3)),
              {.size = 18, .colour = palette::muted});
}

}  // namespace

void turned_inertia(const Setting& setting, Page& page) {
  const double mass = setting.mass, tilt = radians(setting.tilt);
  const Catch right = caught_on_a_nail(book_sides(), mass, tilt, true),
              wrong = caught_on_a_nail(book_sides(), mass, tilt, false);
  const Eigen::Vector3d moments = right.mass.angular.cwiseInverse();

  page.text(
      R"((18) contains I⁻¹, and the article does not say about which axes. In the plane there is one axis, and it never
      turns. A body in space has three: this book of @ m and @ kg has the moments @ kg m² about its own x, y and z, and
      these axes turn with the book. In the axes of the world its inertia is)",
      book_sides(), setting.mass, moments);
  page.formula("I(world) = R I Rᵀ,   I⁻¹(world) = R I⁻¹ Rᵀ",
               R"(I_{\text{world}} = R\,I\,R^{\mathsf T}, \qquad I^{-1}_{\text{world}} = R\,I^{-1}R^{\mathsf T})");
  page.derivation("Why R I Rᵀ",
                  {{"turn ω into the axes of the body", "Rᵀω", R"(R^{\mathsf T}\omega)"},
                   {"there I gives the angular momentum", "I Rᵀω", R"(I\,R^{\mathsf T}\omega)"},
                   {"turn that back into the axes of the world", "R I Rᵀ ω", R"(R\,I\,R^{\mathsf T}\omega)"},
                   {"its inverse, as Rᵀ = R⁻¹", "(R I Rᵀ)⁻¹ = R I⁻¹ Rᵀ",
                    R"((R\,I\,R^{\mathsf T})^{-1} = R\,I^{-1}R^{\mathsf T})"}});
  page.text("It has to be computed again whenever the body has turned. With it, (18) for one body is");
  page.excerpt("lessons/07_space/turned_inertia.cpp", "18");
  page.text(
      R"(What if you forget R? The book flies by at @ m/s, @, and the middle of its yellow side catches on a nail: a
      ball joint, three rows, solved as one block. Here is that solve, with the mistake as an option:)",
      flight(),
      setting.tilt == 0 ? std::string("not turned") : say("turned by @° about @", setting.tilt, tilt_axis()));
  page.excerpt("lessons/07_space/turned_inertia.cpp", "caught");
  const bool shows = wrong.lost() > 1e-9;
  page.choose(
      {.ask = say(
           R"(Leave the inertia in the axes of this book, which @, and solve the rows. How would you
                  notice?)",
           setting.tilt == 0 ? std::string("has not turned") : say("has turned by @°", setting.tilt)),
       .options = {{"JV is not zero: the held point keeps moving",
                    R"(λ is computed and applied with the same M⁻¹, so JV vanishes whatever M⁻¹ is. The joint shows
                    nothing.)"},
                   {"the angular momentum about the nail has changed",
                    shows ? "The push acts at the nail, so it has no torque about the nail; a change is a mistake."
                          : "It would, if the book had turned. As long as R is the identity, RIRᵀ is I."},
                   {"not at all", shows ? "The nail cannot change the angular momentum about itself. Compute that."
                                        : "The book has not turned, so R is the identity and RIRᵀ is I."}},
       .answer = shows ? 1 : 2,
       .hints = {"Compare what (17) and (20) do with M⁻¹, and ask which quantity the nail cannot change.",
                 "(17) divides by JM⁻¹Jᵀ, (20) multiplies by M⁻¹Jᵀ; the push acts at the nail.",
                 "JV after = JV before + JM⁻¹Jᵀ λ"}});
  page.figure(
      "caught_on_a_nail",
      say(R"(The book just caught, with I turned and with I not turned. The held point rests in both. L is the
          angular momentum about the nail, which the nail's push cannot change; in the second it @.)",
          shows ? say("has changed, by @ %", Value(100 * wrong.lost(), 3))
                : "has not changed either, because this book has not turned"),
      [=](Canvas& canvas) {
        const auto [left, beside] = canvas.page().inset(20).panels(0.5, 20);
        draw_catch(canvas, right, "I⁻¹ turned: RI⁻¹Rᵀ", left);
        draw_catch(canvas, wrong, "I⁻¹ not turned", beside);
      });
  page.text(
      R"(@ A body that has not turned hides the mistake, and so does a ball or a cube, whose I is the same about every
      axis. So test with a book, and turn it first.)",
      shows ? "The joint looks right, but the body turns about the wrong axis, and too fast or too slow."
            : "Here joint and motion are right in spite of the mistake.");
  page.figure("lost_by_tilt",
              "Change of the angular momentum about the nail in one solve, against the tilt of the book.",
              over_tilt(mass, 90));
  page.measure("change of L, I not turned", shows ? 100 * wrong.lost() : 0, "%");

  page.claim("speed of the held point, I not turned", wrong.slip, "m/s",
             is(0, "JV = 0, whatever M⁻¹", absolute(1e-12 * flight().norm())));
  page.claim("change of L about the nail, I turned", right.lost(), "1",
             is(0, "the push has no arm", absolute(1e-12)));
  const Eigen::Matrix3d R = right.pose.rotation.toRotationMatrix(), I = moments.asDiagonal();
  const Eigen::Vector3d missing = (R * I * R.transpose() - I) * wrong.after.tail<3>();
  page.claim("change of L, I not turned", (wrong.after_L - wrong.before_L).norm(), "kg m²/s",
             is(missing.norm(), "(RIRᵀ − I)ω", absolute(1e-12 * right.before_L.norm())));
  page.claim("plain M⁻¹Jᵀ from the solver's", difference_from_the_solver(right, mass), "1",
             is(0, "times_inverse_mass", absolute(1e-12)));
}

}  // namespace byhand::space
