// Deeper: Jacobi on many contacts of one box.

#include "lessons/08_where_methods_fail/map.hpp"
#include "lessons/08_where_methods_fail/steps.hpp"
#include "lessons/laws/sweeps.hpp"
#include "lessons/scenes/box_on_contacts.hpp"

namespace byhand::failures {

using laws::Outcome;

/// What Gauss–Seidel leaves of the fall of a unit box on so many contacts, over gh.
double left_by_gauss_seidel(int contacts, int sweeps) {
  Simulation<PlaneBody> box{box_on_contacts(contacts), {GaussSeidel{sweeps}, NoDriftCure{}}};
  box.step(step);
  return residual(box.work.system, box.scene.bodies().velocity) / (gravity * step);
}

void many_contacts(const Setting& setting, Page& page) {
  const int contacts = 4;
  const double mu = laws::largest_eigenvalue(contacts);

  page.text(
      R"(In lesson 3 four rods on one box made Jacobi overshoot: every row sees the same fall, all push at once, and
      together they correct the fall of the box μ = @ times over. Contacts do the same. With relaxation each row makes
      only a share w of its correction:)",
      Value(mu, 3));
  page.formula("|1 − w μ| < 1:   w < 2/μ = 2/@ = @",
               R"(|1 - w\mu| < 1: \quad w < \frac{2}{\mu} = \frac{2}{@} = @)", Value(mu, 3), Value(2 / mu, 3));
  const double ratio = laws::largest_eigenvalue(2 * contacts) / mu;
  page.choose(
      {.ask = say("The box lies on @ points instead of @. What happens to the largest w?", 2 * contacts, contacts),
       .options = {{"it stays about the same", "It would if each row saw what the others do."},
                   {"it about halves", say("μ grows from @ to @: as many more rows correct the same fall.",
                                           Value(mu, 3), Value(ratio * mu, 3))},
                   {"it falls to about a quarter", "There are twice as many rows, and μ counts them once."}},
       .answer = static_cast<int>(std::lround(std::log2(ratio))),
       .hints = {"How many rows correct the fall of the box at once?",
                 "μ is about in proportion to the number of contacts.", "w < 2/μ"}});
  const Map map = map_of(page, counting_knob("contacts", 2, 16, setting.resolution, renderer::Scale::linear),
                         knob("relaxation w", 0.1, 1.9, setting.resolution),
                         [](double n, double w) { return laws::jacobi(static_cast<int>(n), w); });
  const auto boundary = [](double n) {
    return 2 / laws::largest_eigenvalue(std::max(2, static_cast<int>(std::lround(n))));
  };
  page.figure("contacts_and_relaxation",
              "Each cell is one run of Jacobi on the contacts of one box. Dashed: w = 2/μ.",
              chart(map, "w = 2/μ", boundary, {"converges", "drifts", "rings", "diverges", "no solution"}));
  const Agreement agreed = agreement(map, boundary, Settles::below);
  page.text(
      R"(@ This is the second family without any β: each row is right by itself, and together they correct too much.
      Gauss–Seidel cannot do that, because each row sees what the rows before it have done.)",
      agreed.sentence());
  claim_agreement(page, agreed, 0.15, "law of relaxed Jacobi", setting.resolution);
  page.claim(say("relaxation from which @ contacts diverge, by bisection", contacts),
             laws::bisect([](double w) { return laws::jacobi(contacts, w) == Outcome::settles; }, 1 / mu,
                          std::min(1.99, 3 / mu), 0.001),
             "1", is(2 / mu, "law of relaxed Jacobi: 2/μ", relative(0.01)));
  for (const int n : {4, 16})
    page.claim(say("@ contacts, 500 sweeps of Gauss–Seidel: largest JV left, over gh", n),
               left_by_gauss_seidel(n, 500), "1", is_at_most(1e-4, "it converges for every positive definite A"));
}

}  // namespace byhand::failures
