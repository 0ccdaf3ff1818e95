// Step 1: two links, and each row changes the error of the other.

#include "lessons/03_iterations/held_step.hpp"
#include "lessons/03_iterations/knobs.hpp"
#include "lessons/03_iterations/plain_figure.hpp"
#include "lessons/03_iterations/plain_sweep.hpp"

namespace byhand::iterations {
namespace {

/// What a panel shows: speeds and errors in units of gh.
struct Panel {
  std::string title;
  int solved = -1;  // the joint whose row was just solved
  pictures::Linkage linkage;
  std::vector<double> speeds, errors;
};

Panel panel(std::string title, int solved, const HeldStep& step, double fall) {
  Panel now{std::move(title), solved, pictures::rods_and_bobs(step.scene()), step.speeds(), step.errors()};
  for (double& speed : now.speeds) speed /= fall;
  for (double& error : now.errors) error /= fall;
  return now;
}

/// "0", "½ gh", "gh", as one says it.
std::string in_falls(double value) {
  if (std::abs(value) < 1e-12) return "0";
  if (std::abs(value - 1) < 1e-12) return "gh";
  return course::number(value, 3) + " gh";
}

void draw_panel(renderer::Canvas& canvas, const Panel& now, double length, const renderer::Rectangle& frame) {
  canvas.look_at_page();
  canvas.text({frame.centre().x(), frame.top() - 30}, now.title, {.size = 23, .bold = true});
  const renderer::Rectangle below{frame.x, frame.y, frame.width, frame.height - 60};
  const renderer::Camera camera =
      renderer::fit({-0.6 * length, -2.6 * length, 1.2 * length, 2.8 * length}, below, 10);
  canvas.look(camera);
  pictures::draw(canvas, now.linkage, {.bob = 24, .rod = 9});
  canvas.look_at_page();
  for (int i = 0; i < 2; ++i) {
    const auto& rod = now.linkage.rods[i];
    const Point middle = camera.to_page((rod.from + rod.to) / 2), bob = camera.to_page(now.linkage.bobs[i].at);
    if (i == now.solved) {
      const Point up = camera.to_page(rod.from), down = camera.to_page(rod.to);
      canvas.rod(up - Point(0, 18), down + Point(0, 26), {palette::highlight, {palette::ink, 1.6}}, 11);
    }
    canvas.text(middle - Point(16, 0), in_falls(now.errors[i]),
                {.size = 24, .colour = palette::error, .anchor = renderer::Anchor::right, .bold = true});
    const Point foot = bob + Point(44, 20);
    canvas.vector(foot, {0, -now.speeds[i]}, {palette::velocity, 62});
    canvas.text(foot + Point(14, -30), in_falls(now.speeds[i]),
                {.size = 21, .colour = palette::velocity, .anchor = renderer::Anchor::left});
  }
}

}  // namespace

void two_links(Page& page, const Knobs& knobs) {
  const double fall = knobs.fall(), m = knobs.mass, L = knobs.length, h = knobs.h;
  HeldStep step(knobs.chain(2), h);
  std::vector<Panel> panels{panel("gravity is in V", -1, step, fall)};
  const auto solve = [&](int joint) {
    step.solve_row();
    panels.push_back(
        panel(say(panels.size() > 2 ? "row @ solved again" : "row @ solved", joint + 1), joint, step, fall));
  };
  solve(0);
  const double rate = step.errors()[1] * L;
  solve(1);
  const double left = step.errors()[0] / fall, lambda = step.lambda()[1];
  solve(0);

  page.text(
      R"(In lesson 2 we solved one constraint once, and its JV stayed zero for the rest of the step. Hang a second link
      below the first: now two rows *share a bob*, and solving one changes the JV of the other.

      Two bobs of @ kg hang on rods of @ m. Gravity is already in V, so in this step of @ s both fall at gh = @ m/s.
      The upper rod is getting longer at that rate. The lower one is not, because its two ends fall together.)",
      m, L, knobs.h, fall);
  page.text(
      R"(Row 1 goes first. By (17) it stops the upper bob, and its error is zero. Now the lower bob falls away from a
      bob at rest. With C = ½(|d|² − L²) a row's JV is L times the speed at which its rod lengthens, here @ m · @ m/s =
      @ m²/s. We quote errors as that speed, in units of gh. Row 2 is next:)",
      L, fall, rate);
  page.equation(17, "λ₂ = −(@ + 0) / (@²/@ + @²/@) = @ N·s/m",
                R"(\lambda_2 = \frac{-(@ + 0)}{@^2/@ + @^2/@} = @\,\mathrm{N\,s/m})", rate, L, m, L, m, lambda);
  page.predict(
      {.ask = "Row 1 has been solved, then row 2. How large is row 1's error now, in units of gh?",
       .answer = left,
       .unit = "gh",
       .tolerance = 0.05,
       .wrong = {{0, "Row 2 pulled on the bob that both rows share."},
                 {1, "Row 2's impulse is shared by two equal bobs, so it gives the upper one only half of gh."}},
       .hints = {"Row 2's impulse acts on both bobs, equal and opposite, and both have the same mass.",
                 "After row 2 both bobs move at the same speed, and their total momentum is still m·gh.",
                 "2m·v = m·gh. Row 1's error is the speed of the upper bob."},
       .hinted = 0.5,
       .right =
           R"(The two bobs share the momentum m·gh: the lower one slows down to gh/2, the upper one is pulled down
                at gh/2, and that is row 1's error.)"});
  page.figure(
      "two_links",
      say(R"(Four moments of one solve. Green: how fast each bob falls. Purple: how fast each rod is getting
          longer, its row's error. Yellow: the row just solved. gh = @ m/s.)",
          fall),
      [=](renderer::Canvas& canvas) {
        const renderer::Rectangle paper = canvas.page().inset(20);
        const auto cells = paper.is_high() ? paper.cells(2, 2, 10) : paper.cells(1, 4, 10);
        for (std::size_t i = 0; i < cells.size(); ++i) draw_panel(canvas, panels[i], L, cells[i]);
      });
  within_a_sweep(page, knobs);
  page.text(
      R"(Row 2 has undone half of row 1's work; solving row 1 again undoes half of row 2's. (17) is exact for *one* row
      while the others wait. For many rows it is one step of a method that goes round and round: *Gauss–Seidel*. One
      round over all rows is a *sweep*. For a hanging chain, in the plainest code:)");
  page.excerpt("lessons/03_iterations/plain_sweep.cpp", "sweep");
  page.figure("plain_sweep",
              "All bobs of a chain begin to fall at gh. The largest error after each sweep of this code.",
              chart_of(plain_sweep));
  page.text(
      R"(*The article calls the method Sequential Impulses. Of (19) it says "We calculate it for a
      system"; but (17) and (19) both serve one row.* The solver's inner loop (`sweep_run` in solver/rows/gauss_seidel.cpp) does the same for rows of all
      kinds.)");

  constexpr int rounds = 10;
  HeldStep many(knobs.chain(2), h);
  for (int i = 0; i < rounds; ++i) many.solve_sweep();
  const double after = many.errors()[0] / fall;
  page.text(
      R"(With two links each sweep halves the error. After @ sweeps @ gh remain, and the two rods carry @ and @ of the
      weight. Longer chains converge more slowly; this lesson asks how fast.)",
      rounds, after, many.shares()[0], many.shares()[1]);
  const ChainOptions longer = knobs.chain(5);
  HeldStep solver(longer, h);
  std::vector<double> v(5, fall), impulses(5, 0.0);
  double apart = 0;
  for (int i = 0; i < rounds; ++i) {
    solver.solve_sweep();
    plain_sweep(longer.length, longer.mass, v, impulses);
  }
  for (std::size_t i = 0; i < v.size(); ++i) apart = std::max(apart, std::abs(v[i] - solver.speeds()[i]) / fall);
  page.claim(say("the plain sweep against the solver, 5 links, @ sweeps", rounds), apart, "gh",
             is_at_most(1e-13, "the same arithmetic: rounding"));
  page.claim("row 1's error after row 2", left, "gh", is(0.5, "equal masses share the momentum", absolute(1e-12)));
  page.claim(say("row 1's error after @ sweeps", rounds), after, "gh",
             is(std::pow(0.5, rounds), "(½)ⁿ", absolute(1e-12)));
}

}  // namespace byhand::iterations
