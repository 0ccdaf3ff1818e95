// Step 4: a box on a slope, on both sides of tanθ = μ.

#include "lessons/05_contact/steps.hpp"
#include "lessons/pictures/boxes.hpp"
#include "lessons/scenes/incline.hpp"

namespace byhand::contact {
namespace {

constexpr double slide_seconds = 2;
const Linear<PlaneBody> sides(0.8, 0.5);  // of the box [m]

Simulation<PlaneBody> on_slope(const Setting& setting, double angle, double speed = 0) {
  return {box_on_incline<PlaneBody>(angle, setting.friction(), speed, sides, setting.mass),
          {GaussSeidel{.sweeps = 30, .tolerance = 1e-14}, Baumgarte{}}};
}

/// How far the box has come along the slope [m].
double slid(const Simulation<PlaneBody>& simulation, double angle) {
  return simulation.scene.bodies().pose[1].position.dot(Linear<PlaneBody>(std::cos(angle), -std::sin(angle)));
}

double slid_after(Simulation<PlaneBody> simulation, double angle, double time, double h) {
  while (simulation.time < time - 0.5 * h) simulation.step(h);
  return slid(simulation, angle);
}

/// Along the slope, once it slides [m/s²].
double acceleration(double angle, double friction) {
  return std::max(0.0, gravity * (std::sin(angle) - friction * std::cos(angle)));
}

/// λₜ over its bound, for a box that rests [1].
double share_of_bound(const Setting& setting, double angle) {
  Simulation<PlaneBody> box = on_slope(setting, angle);
  while (box.time < 0.5) box.step(setting.h);
  const Touch<PlaneBody> ground = box.touches()[0];
  const double normal = ground.impulse.dot(ground.normal), tangent = cross(ground.normal, ground.impulse)[0];
  return std::abs(tangent) / (setting.friction() * normal);
}

/// ½at(t + h) of symplectic Euler [m].
double law_of_sliding(double angle, double friction, double time, double h) {
  return 0.5 * acceleration(angle, friction) * time * (time + h);
}

/// Where it begins to slide [rad], by bisection.
double measured_limit(const Setting& setting) {
  double sticks = 0, slides = radians(60);
  for (int i = 0; i < 40; ++i) {
    const double middle = 0.5 * (sticks + slides);
    (slid_after(on_slope(setting, middle), middle, 0.5, setting.h) > 1e-9 ? slides : sticks) = middle;
  }
  return 0.5 * (sticks + slides);
}

struct Slope {
  double angle;
  Simulation<PlaneBody> box;
};

/// The contacts' impulses at the lower corners as they are now; the contacts were found a step ago.
std::vector<pictures::Push> forces_now(const Slope& slope) {
  std::vector<pictures::Push> forces = pictures::pushes(slope.box);
  if (forces.size() != 2) return forces;
  const Point along(std::cos(slope.angle), -std::sin(slope.angle)), up(-along.y(), along.x());
  if (along.dot(forces[1].at - forces[0].at) < 0) std::swap(forces[0], forces[1]);
  const Point below = slope.box.scene.bodies().pose[1].position - 0.5 * sides.y() * up;
  forces[0].at = below - 0.5 * sides.x() * along;
  forces[1].at = below + 0.5 * sides.x() * along;
  return forces;
}

void draw_slope(Canvas& canvas, const Slope& slope, const Rectangle& frame, const Rectangle& world, double weight,
                double h, int number) {
  canvas.look_at_page();
  const double distance = slid(slope.box, slope.angle);
  canvas.text({frame.centre().x(), frame.top() - 22}, say("@°", Value(degrees(slope.angle), 3)),
              {.size = 24, .colour = palette::series(number), .bold = true});
  canvas.text({frame.centre().x(), frame.y + 16},
              say("has slid @ m", Value(std::abs(distance) < 5e-7 ? 0 : distance, 3)), {.size = 20});
  const Rectangle below{frame.x, frame.y + 40, frame.width, frame.height - 90};
  canvas.clip(below);
  canvas.look(fit(world, below, 0));
  pictures::Shapes shapes = pictures::shapes_of(slope.box.scene);

  pictures::draw(canvas, shapes);
  if (slope.box.time > 0) pictures::draw(canvas, forces_now(slope), {palette::force, 0.9 / (weight * h), "mg"});
  canvas.vector(slope.box.scene.bodies().pose[1].position, Point(0, -weight), {palette::muted, 0.9 / weight, "N"});
  canvas.clip({});
  canvas.look_at_page();
}

Chart ways_over_time(const std::vector<Slope>& slopes, double friction, double h) {
  Chart chart{.x = {.label = "time (s)", .range = {{0, slide_seconds}}}, .y = {.label = "slid (m)"}};
  std::vector<Curve> laws;
  for (Slope slope : slopes) {
    Curve run{.label = say("@°", Value(degrees(slope.angle), 3))}, law{.style = CurveStyle::theory};
    run.style = CurveStyle::line_and_markers;
    const int every = std::max(1, static_cast<int>(std::round(0.1 / h)));
    for (int step = 0; slope.box.time < slide_seconds + 0.5 * h; slope.box.step(h), ++step) {
      law.x.push_back(slope.box.time);
      law.y.push_back(law_of_sliding(slope.angle, friction, slope.box.time, h));
      if (const bool last = slope.box.time > slide_seconds - 0.5 * h; step % every != 0 && !last) continue;
      run.x.push_back(slope.box.time);
      run.y.push_back(slid(slope.box, slope.angle));
    }
    chart.curves.push_back(std::move(run));
    laws.push_back(std::move(law));
  }
  chart.curves.insert(chart.curves.end(), laws.begin(), laws.end());
  return chart;
}

Chart distances(const Setting& setting, double limit) {
  const double h = setting.h(), mu = setting.friction(), time = std::round(1 / h) * h;
  Curve measured{.label = "measured", .style = CurveStyle::markers},
      law{.label = "½at(t + h)", .style = CurveStyle::theory};
  const double steepest = std::max(radians(41), limit + radians(12));  // always some that slide
  for (double angle = radians(4); angle < steepest; angle += radians(2)) {
    measured.x.push_back(degrees(angle));
    measured.y.push_back(without_rounding(slid_after(on_slope(setting, angle), angle, time, h), 1));
  }
  std::vector<double> angles{limit};  // where the law has its corner
  for (double angle = radians(4); angle < steepest; angle += radians(0.5)) angles.push_back(angle);
  std::sort(angles.begin(), angles.end());
  for (const double angle : angles) {
    law.x.push_back(degrees(angle));
    law.y.push_back(law_of_sliding(angle, mu, time, h));
  }
  return {.x = {.label = "slope (°)"},
          .y = {.label = "slid in 1 s (m)"},
          .curves = {measured, law},
          .references = {{Reference::Across::x, degrees(limit), "tanθ = μ"}}};
}

}  // namespace

void sticks_or_slides(const Setting& setting, Page& page) {
  const double mu = setting.friction(), h = setting.h(), mass = setting.mass, limit = std::atan(mu);
  const double slope = std::max(radians(setting.slope), limit + radians(4));

  page.text(
      R"(Put a box of @ kg on a slope. Nothing in the solver says "static" or "kinetic": one row, JV = 0
      within ±μλₙ, sticks while its λ is inside the bound and slides while λ is at the bound.)",
      setting.mass);
  const int gentle = static_cast<int>(degrees(limit) / 2);  // [deg]
  const double used = std::tan(radians(gentle)) / mu;
  page.predict(
      {.ask = say(R"(μ = @, and the box stands on a slope of @°. What share of its bound μλₙ is friction's
                           λₜ?)",
                  setting.friction, gentle),
       .answer = used,
       .unit = "1",
       .tolerance = 0.03,
       .wrong = {{1, "That would be the largest possible λₜ; the row only asks for JV = 0."},
                 {std::sin(radians(gentle)) / std::cos(radians(gentle)),
                  "That is λₜ/λₙ; the bound is μ times λₙ."}},
       .hints = {"The box stays at rest. How large is the force along the slope that friction cancels?",
                 "λₜ = mgh·sinθ, λₙ = mgh·cosθ.", say("tan @° / @.", gentle, setting.friction)},
       .hinted = std::tan(radians(gentle)) / setting.friction(),
       .right = R"(λₜ is only as large as JV = 0 needs: tanθ/μ of the bound. Where that reaches 1, at tanθ =
                         μ, the box begins to slide; the mass cancels.)"});
  const double farthest = law_of_sliding(slope, mu, slide_seconds, h) + 0.9;
  const double steepest = std::max(slope, limit + radians(1)), fall = farthest * std::sin(steepest);
  const Rectangle world{-0.8, -0.4 - fall, 0.8 + farthest * std::cos(slope), 1.4 + fall};
  std::vector<Slope> slopes;
  for (const double angle : {limit - radians(1), limit + radians(1), slope})
    slopes.push_back({angle, on_slope(setting, angle)});
  page.sequence(
      "three_slopes",
      say(R"(μ = @: one degree below the angle arctan μ, one degree above, and @°. Orange: the contacts' forces, normal
          and friction together; grey: the weight. Where the box sticks they cancel. Below: how far each has slid;
          dashed, the formula below.)",
          setting.friction, Value(degrees(slope), 3)),
      Seconds{slide_seconds},
      [slopes, ways = ways_over_time(slopes, mu, h), world, h, mass](Canvas& canvas, double time) mutable {
        const auto [above, under] = canvas.page().inset(16).split_rows(0.62, 10);
        const auto frames = above.cells(1, static_cast<int>(slopes.size()), 14);
        for (std::size_t i = 0; i < slopes.size(); ++i) {
          while (slopes[i].box.time < time - 0.5 * h) slopes[i].box.step(h);
          draw_slope(canvas, slopes[i], frames[i], world, mass * gravity, h, static_cast<int>(i));
        }
        renderer::draw(canvas, pictures::grown_to(ways, slopes.front().box.time), under);
      });
  page.text(
      R"(The limit is sharp. At 0.999 of that angle the box has moved only by rounding after a second; at 1.001 of it,
      it
      slides with the textbook's acceleration, a = g(sinθ − μ·cosθ). Its velocity is exactly a·t, because each step
      adds a·h. The distance is not ½at² but ½at(t + h): symplectic Euler moves with the velocity at the *end* of each
      step.)");
  page.derivation("The distance in steps", {{"after k steps", "v = k a h", R"(v_k = k\,a\,h)"},
                                            {"each step moves by h times the new velocity",
                                             "s = h · ah (1 + 2 + … + n)", R"(s = a h^2\,(1 + 2 + \dots + n))"},
                                            {"1 + 2 + … + n = n(n + 1)/2, and t = nh", "s = ½ a t (t + h)",
                                             R"(s = \tfrac12\,a\,t\,(t+h))"}});
  page.figure("distance_over_slope",
              say("How far the box slides in a second, μ = @, and the law.", setting.friction),
              distances(setting, limit));

  const double time = std::round(1 / h) * h, beside = 0.001;
  page.measure("slid in 1 s on the third slope",
               without_rounding(slid_after(on_slope(setting, slope), slope, time, h), 1), "m");
  page.claim(say("friction's λ over its bound at @°", gentle), share_of_bound(setting, radians(gentle)), "1",
             is(used, "tanθ/μ", relative(1e-6)));
  page.claim("slope at which it begins to slide", degrees(measured_limit(setting)), "°",
             is(degrees(limit), "tanθ = μ", absolute(1e-5)));
  page.claim(
      "slid in 1 s at 0.999 of that angle",
      without_rounding(slid_after(on_slope(setting, (1 - beside) * limit), (1 - beside) * limit, time, h), 1), "m",
      is(0, "it sticks", absolute(1e-9)));
  page.claim("slid in 1 s at 1.001 of that angle",
             slid_after(on_slope(setting, (1 + beside) * limit), (1 + beside) * limit, time, h), "m",
             is(law_of_sliding((1 + beside) * limit, mu, time, h), "½at(t + h)", absolute(1e-9)));
  page.claim("slid in 1 s on the third slope", slid_after(on_slope(setting, slope), slope, time, h), "m",
             is(law_of_sliding(slope, mu, time, h), "½at(t + h)", absolute(1e-9)));
}

}  // namespace byhand::contact
