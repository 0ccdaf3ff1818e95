// Deeper: Jacobi on many contacts of one box.

#include <cmath>

#include "lessons/08_where_methods_fail/laws/sweeps.hpp"
#include "lessons/08_where_methods_fail/map.hpp"
#include "lessons/08_where_methods_fail/steps.hpp"

namespace byhand::failures {

using namespace tutor;
using laws::Outcome;

void many_contacts(const Setting& setting, Page& page) {
  const int contacts = 4;
  const double mu = laws::largest_eigenvalue(contacts), growth = std::abs(1 - mu);

  page.text(
      R"(A box lies on @ points in a row. All rows see the same fall, and by Jacobi each answers as if it were
      alone; then all push at once.)",
      contacts);
  page.predict(
      {.ask = say("Jacobi on @ contacts of one box: by what is the error multiplied in each iteration?", contacts),
       .answer = growth,
       .unit = "1",
       .tolerance = 0.15 * growth,
       .wrong =
           {{0.5 * growth,
             "It does not shrink: each of the rows corrects all of one error, together more than twice too much."},
            {contacts - 1.0, "If all rows were the same, yes. They lie apart, and share the turn of the box."}},
       .hints = {"Together the rows correct μ times the error, μ being the largest eigenvalue of D⁻¹A."},
       .right = "Together they correct the error μ times; 1 − μ of it is left, with its sign changed."});
  page.formula("|1 − ω μ| < 1:   ω < 2/μ = 2/@ = @",
               R"(|1 - \omega\mu| < 1: \quad \omega < \frac{2}{\mu} = \frac{2}{@} = @)", Value(mu, 3),
               Value(2 / mu, 3));
  const Map map = map_of(page, counting_knob("contacts (1)", 2, 16, setting.resolution, renderer::Scale::linear),
                         knob("relaxation ω (1)", 0.1, 1.9, setting.resolution),
                         [](double n, double omega) { return laws::jacobi(static_cast<int>(n), omega); });
  const auto boundary = [](double n) {
    return 2 / laws::largest_eigenvalue(std::max(2, static_cast<int>(std::lround(n))));
  };
  page.figure("contacts_and_relaxation",
              "Each cell is a run of Jacobi on the contacts of one box. Dashed: ω = 2/μ.",
              chart(map, "ω = 2/μ", boundary));
  const double foreseen = share_foreseen(map, [&](double n, double omega) { return omega < boundary(n); });
  page.text(
      R"(It is family two without any β: each row is right by itself and all together overshoot. Gauss–Seidel,
      where each row sees what those before it did, cannot. Of @ runs the law foresees @ %.)",
      map.outcomes.size(), Value(100 * foreseen, 3));
  page.claim({.quantity = "share of runs that end as the law says",
              .unit = "1",
              .expected = 0.97,
              .source = "law B5",
              .measured = foreseen,
              .tolerance = at_least(),
              .claimed = setting.resolution >= 10,
              .range = "10 cells a side or more"});
  page.claim(
      {.quantity = say("relaxation from which @ contacts diverge, by bisection", contacts),
       .unit = "1",
       .expected = 2 / mu,
       .source = "law B5: 2/μ",
       .measured = laws::bisect([](double omega) { return laws::jacobi(contacts, omega) == Outcome::settles; },
                                1 / mu, std::min(1.99, 3 / mu), 0.001),
       .tolerance = relative(0.01)});
}

}  // namespace byhand::failures
