// Step 4: rows that repeat what others say, at one pose or at all of them.

#include "lessons/06_joints/dense.hpp"
#include "lessons/06_joints/linkage.hpp"
#include "lessons/06_joints/runs.hpp"
#include "lessons/06_joints/steps.hpp"
#include "lessons/pictures/acts.hpp"

namespace byhand::joints {
namespace {

constexpr double flat_seconds = 1.8, misfit = 1e-3;                // [s], [m]
constexpr double shown_share = 1e-9, strict = 1e-6, loose = 1e-4;  // regularisations [1]

Eigen::MatrixXd jacobian_at(const Setting& setting, double from_flat, int arms = 2) {
  return dense_jacobian(four_bar(bars_of(setting, pi / 2 - from_flat, arms)));
}

double least_at(const Setting& setting, double from_flat) {
  return least_eigenvalue(dense_matrix(four_bar(bars_of(setting, pi / 2 - from_flat))));
}

/// What the direct solve says to a scene, or nothing.
std::string complaint(FourBar linkage, double h) {
  linkage.method = exactly();
  try {
    linkage.step(h);
    return "";
  } catch (const SingularSystem& error) {
    const std::string words = error.what();  // and after a semicolon, what to do
    return words.substr(0, words.find(';'));
  }
}

/// A flat linkage whose right-hand pivot was set `misfit` too far out, regularised by that share of A, after a
/// step: the impulse along the bars [N s].
double self_pull(const Setting& setting, double share) {
  FourBar linkage{four_bar(bars_of(setting, pi / 2)),
                  {.solver = Direct{.regularisation = share}, .drift = Baumgarte{setting.beta}}};
  const Handle<Pin<PlaneBody>> right_pivot{2};
  linkage.scene.change(right_pivot, [](auto& pin) { pin.at.arms.first.x() += misfit; });
  linkage.step(setting.h);
  return std::abs(linkage.impulse(0)[0]);
}

/// The same by hand: the bars' rows along the line all say one thing, and ε Σ A of them is all that answers.
double self_pull_by_hand(const Setting& setting, double share) {
  return setting.beta / setting.h * misfit / (share * (4 / setting.mass + 2 / setting.coupler));
}

/// How fast the pins of a flat linkage part in the first step of its fall [m/s].
double parting_speed(const Setting& setting, double share) {
  FourBar linkage{four_bar(bars_of(setting, pi / 2)), exactly(share)};
  const Eigen::MatrixXd J = dense_jacobian(linkage.scene);
  linkage.step(setting.h);
  Eigen::VectorXd V(J.cols());
  for (int body = 1; body <= 3; ++body) V.segment<3>(3 * (body - 1)) = linkage.scene.bodies().velocity[body];
  return (J * V).cwiseAbs().maxCoeff();
}

/// The flat linkage set going, without gravity, with its second arm at `speed` [rad/s] and its first at that times
/// `ratio`.
FourBar sent_off(const Setting& setting, double speed, double ratio) {
  const FourBarOptions bars = bars_of(setting, pi / 2);
  FourBar linkage{four_bar(bars), exactly(shown_share)};
  linkage.scene.gravity.setZero();
  const double left = bars.arm * speed * ratio, right = bars.arm * speed;  // of the arms' free ends, upwards
  linkage.scene.set_velocity(1, {0, left / 2, speed * ratio});
  linkage.scene.set_velocity(2, {0, right / 2, speed});
  linkage.scene.set_velocity(3, {0, (left + right) / 2, (right - left) / bars.coupler});
  return linkage;
}

/// ω₁/ω₂ with which the linkage leaves the flat pose crossed.
double crossed_ratio(const FourBarOptions& bars) { return -(bars.coupler - bars.arm) / (bars.coupler + bars.arm); }

double from_level(const FourBar& linkage, int arm) { return arm_angle(linkage, arm) - pi / 2; }

/// How far a crossed linkage is from its closed form tan(θ₂/2) = tan(θ₁/2)/ratio, θ from level, at most until
/// `time` [rad].
double off_the_crossed_way(FourBar linkage, double ratio, double h, double time) {
  double worst = 0;
  advance_to(linkage, time, h, [&] {
    const double second = 2 * std::atan(std::tan(from_level(linkage, 1) / 2) / ratio);
    worst = std::max(worst, std::abs(std::remainder(from_level(linkage, 2) - second, 2 * pi)));
  });
  return worst;
}

/// One way to leave the flat pose.
struct Way {
  std::string name;
  FourBar linkage;
  std::vector<Point> trail = {};  // of the coupler's middle
};

/// Its kinetic energy over that at the start, over time.
Curve energy_of(const Way& way, double h) {
  FourBar linkage = way.linkage;
  const double before = kinetic_energy(linkage.scene.bodies());
  Curve curve{.label = way.name, .x = {0}, .y = {1}};
  advance_to(linkage, flat_seconds, h, [&] {
    curve.x.push_back(linkage.time);
    curve.y.push_back(kinetic_energy(linkage.scene.bodies()) / before);
  });
  return curve;
}

struct FlatFilm {
  std::vector<Way> ways;
  FourBarOptions bars;
  double h;
  Chart beside;

  void draw(Canvas& canvas, double time) {
    const auto [upper, lower] = canvas.page().inset(14).split_rows(0.58, 8);
    const auto cells = upper.cells(1, static_cast<int>(ways.size()), 12);
    const double a = bars.arm, c = bars.coupler;
    for (std::size_t i = 0; i < ways.size(); ++i) {
      FourBar& linkage = ways[i].linkage;
      std::vector<Point>& trail = ways[i].trail;
      if (trail.empty()) trail.push_back(linkage.scene.bodies().pose[3].position);
      advance_to(linkage, time, h, [&] { trail.push_back(linkage.scene.bodies().pose[3].position); });
      const TextStyle bold{.size = 22, .colour = palette::series(static_cast<int>(i)), .bold = true};
      const std::string name = pictures::wrapped(canvas, ways[i].name, cells[i].width, bold);
      canvas.text({cells[i].centre().x(), cells[i].top() - (name == ways[i].name ? 14 : 28)}, name, bold);
      const Rectangle below{cells[i].x, cells[i].y, cells[i].width, cells[i].height - 32};
      canvas.look(fit({-1.1 * a, -1.25 * a, c + 2.2 * a, 2.5 * a}, below, 4));
      canvas.clip(below);
      canvas.line({0, 0}, {c, 0}, {palette::muted, 1.4, Dash::dotted});
      if (trail.size() > 1) canvas.trail(trail, {palette::series(static_cast<int>(i)), 3});
      pictures::draw(canvas, pictures::rods_and_bobs(linkage.scene));
      canvas.clip({});
      canvas.look_at_page();
    }
    renderer::draw(canvas, pictures::grown_to(beside, time), lower);
  }
};

}  // namespace

void flat(const Setting& setting, Page& page) {
  const FourBarOptions bars = bars_of(setting, pi / 2);
  const double h = setting.h();
  const Eigen::MatrixXd J = jacobian_at(setting, 0), three = jacobian_at(setting, radians(30), 3);
  const int at_flat = rank(J), rank_of_three = rank(three), rows_of_three = static_cast<int>(three.rows());
  const FourBar third{four_bar(bars_of(setting, radians(60), 3)), exactly()};

  page.text(
      R"(Hang a third, equal arm between the two, parallel to them: with one more body and two more pins, @ velocities
      and @ rows.)",
      static_cast<int>(three.cols()), rows_of_three);
  page.choose(
      {.ask = "Count again. Does it still move?",
       .options =
           {{"no",
             say(R"(@ − @ = @ counts rows. Only @ of them are independent: that number is the rank.)",
                 three.cols(), rows_of_three, static_cast<int>(three.cols()) - rows_of_three, rank_of_three)},
            {"yes",
             say(R"(@ − @ = @, but one row repeats the others: the coupler is level already, and the third arm asks for it
                               again. The rank, the number of independent rows, is @.)",
                 three.cols(), rows_of_three, static_cast<int>(three.cols()) - rows_of_three, rank_of_three)}},
       .answer = static_cast<int>(three.cols()) > rank_of_three ? 1 : 0,
       .hints = {"Look at the coupler's motion with two arms. Does the third arm prevent it?",
                 "degrees of freedom = velocities − rank, not velocities − rows.",
                 "The coupler stays level with two arms. What does the third arm ask of it?"}});
  page.text(
      R"(So A has no inverse, and the direct solve says so instead of dividing by zero: "@". (A sweep does not notice: it
      only divides by the blocks on the diagonal.)

      With two arms the rank can drop too, but only where the linkage is *flat*, all bars in one line. There the four
      pins' rows along that
      line repeat one another, and the rank falls from @ to @:)",
      complaint(third, h), static_cast<int>(J.rows()), at_flat);
  Curve least{.label = "measured", .style = CurveStyle::markers},
      square{.label = "slope 2", .style = CurveStyle::theory};
  for (int i = 0; i <= 12; ++i) {
    const double off = 90 * std::pow(10, -i / 3.0);
    least.x.push_back(off);
    least.y.push_back(least_at(setting, radians(off)));
  }
  square.x = {30, least.x.back()};
  for (const double off : square.x) square.y.push_back(least.y.back() * std::pow(off / least.x.back(), 2));
  page.figure("towards_flat", "The least eigenvalue of A falls with the square of the angle from flat.",
              Chart{.x = {.label = "arms from level (°)", .scale = Scale::logarithmic},
                    .y = {.label = "least eigenvalue of A (1/kg)", .scale = Scale::logarithmic},
                    .curves = {least, square}});

  const double ratio = crossed_ratio(bars), speed = pi / 2;
  const std::vector<Way> ways{{"equal, 1 : 1", sent_off(setting, speed, 1)},
                              {say("crossed, 1 : −@", Value(-1 / ratio, 3)), sent_off(setting, speed, ratio)},
                              {"neither, 1 : −1", sent_off(setting, speed, -1)}};
  Chart energies{.x = {.label = "time (s)"}, .y = {.label = "kinetic energy / initial", .range = {{0, 1.1}}}};
  for (const Way& way : ways) energies.curves.push_back(energy_of(way, h));
  // The second lies on the first: marks at some of its points leave the line below to be seen.
  Curve& second = energies.curves[1];
  Curve sparse{.label = second.label, .style = CurveStyle::markers};
  const std::size_t last = second.x.size() - 1;
  for (std::size_t k = 0; k <= 24; ++k) {
    const std::size_t i = k * last / 24;
    sparse.x.push_back(second.x[i]);
    sparse.y.push_back(second.y[i]);
  }
  second = sparse;
  const auto kept = [&](int way) { return energies.curves[way].y.back(); };
  const std::string jerked = say("@", Value(100 * energies.curves[2].y[2], 2)),
                    settled = say("@", Value(100 * kept(2), 2));
  page.text(
      R"(One independent row fewer, one degree of freedom more. In the flat pose the linkage has two, and *two motions are
      possible from here*: it can stay a parallelogram, or fold into a crossed linkage, whose arms turn in opposite
      directions, at first as (c + a) to (c − a), @ to 1. The velocities decide between them, not J.
      What if they fit neither, say 1 to −1? J at the flat pose allows such velocities too, so the first step moves the
      pins apart, and the next has to pull them together again. These two steps leave @ % of the energy@.)",
      Value(-1 / ratio, 3), jerked,
      settled == jerked ? "" : say(", and after @ s it is @ %", flat_seconds, settled));
  page.sequence(
      "ways_on",
      say(R"(The same flat pose with three choices of velocity, without gravity; regularisation @. Only two
                    fit a motion of the linkage.)",
          shown_share),
      Seconds{flat_seconds}, [film = FlatFilm{ways, bars, h, energies}](Canvas& canvas, double time) mutable {
        film.draw(canvas, time);
      });
  page.text(
      R"(**Regularisation** lets the direct solve pass this pose: add a small share ε of A's own diagonal D to A, (A +
      εD)λ = −(JV + b). It acts like softness γ = εD: each row may give way a little. The cost: pins separate at
      the speed γλ = εDλ, in proportion to ε and to their load. The benefit: λ is bounded. Suppose the right-hand pivot
      is δ = @ mm too far out.
      In the flat pose the bars cannot reach it and pull at each other in vain; only ε limits that pull:)",
      1000 * misfit);
  page.formula("λ = (β/h) δ / (ε (4/m_a + 2/m_c)) = @ N·s for ε = @, β = @; an arm's weight: m_a gh = @ N·s",
               R"(\lambda = \frac{\beta\,\delta/h}{\varepsilon\,(4/m_a + 2/m_c)} = @\,\mathrm{N\,s}
                  \text{ for } \varepsilon = @,\; \beta = @; \text{ an arm's weight: } m_a g h = @\,\mathrm{N\,s})",
               self_pull_by_hand(setting, strict), strict, setting.beta, setting.mass * gravity * h);
  Chart price{.x = {.label = "regularisation ε", .scale = Scale::logarithmic},
              .y = {.label = "speed at which pins separate (m/s)", .scale = Scale::logarithmic}};
  Chart gain{.x = price.x, .y = {.label = "pull of a misfit (N s)", .scale = Scale::logarithmic}};
  Curve parting{.label = "measured", .style = CurveStyle::markers},
      in_proportion{.label = "in proportion to ε", .style = CurveStyle::theory},
      pull{.label = "measured", .style = CurveStyle::markers}, law{.label = "law", .style = CurveStyle::theory};
  for (int decade = -9; decade <= -1; ++decade) {
    const double share = std::pow(10, decade);
    parting.x.push_back(share);
    parting.y.push_back(parting_speed(setting, share));
    in_proportion.x.push_back(share);
    in_proportion.y.push_back(parting.y.front() * share / parting.x.front());
    pull.x.push_back(share);
    pull.y.push_back(self_pull(setting, share));
    law.x.push_back(share);
    law.y.push_back(self_pull_by_hand(setting, share));
  }
  price.curves = {parting, in_proportion};
  gain.curves = {pull, law};
  page.figure(
      "price_of_regularisation",
      say(R"(Cost and benefit of ε in the first step from flat. Left: how fast the pins separate when the linkage falls.
                  Right: the impulse along the bars when the pivots are @ mm too far apart.)",
          1000 * misfit),
      [price, gain](Canvas& canvas) {
        const Rectangle paper = canvas.page();
        const auto cells = paper.inset(14, paper.is_high() ? 14 : 60).grid(1, 2, 24);
        draw(canvas, price, cells[0]);
        draw(canvas, gain, cells[1]);
      });
  page.text(
      R"(With ε = @ the pins separate at @ mm/s and the pull is @ N·s. Where loops close, always use some regularisation,
      small enough not to be seen.)",
      loose, Value(1000 * parting_speed(setting, loose), 2), Value(self_pull(setting, loose), 3));

  page.measure("energy left, started along neither branch", kept(2), "1");
  page.claim("rank of the three-armed linkage", static_cast<double>(rank_of_three), "1",
             is(11, "twelve rows, one of them redundant", absolute(0)));
  page.claim("rank of the flat linkage", static_cast<double>(at_flat), "1",
             is(7, "eight rows, one of them redundant", absolute(0)));
  page.claim("least eigenvalue of A, at 1° over at 0.5°",
             least_at(setting, radians(1)) / least_at(setting, radians(0.5)), "1",
             is(4, "square of the angle", absolute(0.01)));
  page.claim(say("pull of the misfit, ε = @", strict), self_pull(setting, strict), "N s",
             is(self_pull_by_hand(setting, strict), "βδ/(hε(4/m_a + 2/m_c))",
                relative(4 * strict * (1 + setting.coupler / setting.mass))));
  page.claim(say("speed at which pins part, ε = @ over ε = @", loose, strict),
             parting_speed(setting, loose) / parting_speed(setting, strict), "1",
             is(loose / strict, "proportional to ε", absolute(0.5)));
  for (const int way : {0, 1})
    page.claim("energy left, started " + ways[way].name, kept(way), "1", is(1, "pins do no work", absolute(0.01)),
               Quantity("h", h, "s") <= 1.0 / 50);
  page.claim("the crossed branch beside its closed form, largest difference",
             off_the_crossed_way(sent_off(setting, speed, ratio), ratio, h, flat_seconds), "rad",
             is(0, "tan(θ₂/2) = −tan(θ₁/2) (c + a)/(c − a)", absolute(0.05)), Quantity("h", h, "s") <= 1.0 / 50);
}

}  // namespace byhand::joints
