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
      R"(A box lies on @ points in a row. In Jacobi's method every row answers as if it were alone (lesson 3): all see
      the same fall, and all push at once. The fall of the whole box is the error that they overcorrect most: together
      they correct it μ = @ times over. μ is the largest eigenvalue of D⁻¹A, with A = JM⁻¹Jᵀ of all rows and D its
      diagonal.)",
      contacts, Value(mu, 3));
  page.predict(
      {.ask = "By what factor does one Jacobi iteration multiply this error? (Mind the sign.)",
       .answer = 1 - mu,
       .unit = "1",
       .tolerance = 0.05,
       .wrong =
           {{mu, "That is what the rows correct together. What is left of the error?"},
            {1 - contacts,
             "That would be so if all points were in one place. But they lie apart, and the box also turns."}},
       .hints = {"How much of the error do all rows correct, and what is left?", "left = error − μ · error",
                 say("1 − @ = …", Value(mu, 4))},
       .right = "μ times the error is corrected, so 1 − μ of it is left: larger, and of the other sign."});
  page.text("With relaxation each row makes only a share ω of its correction:");
  page.formula("|1 − ω μ| < 1:   ω < 2/μ = 2/@ = @",
               R"(|1 - \omega\mu| < 1: \quad \omega < \frac{2}{\mu} = \frac{2}{@} = @)", Value(mu, 3),
               Value(2 / mu, 3));
  const Map map = map_of(page, counting_knob("contacts", 2, 16, setting.resolution, renderer::Scale::linear),
                         knob("relaxation ω", 0.1, 1.9, setting.resolution),
                         [](double n, double omega) { return laws::jacobi(static_cast<int>(n), omega); });
  const auto boundary = [](double n) {
    return 2 / laws::largest_eigenvalue(std::max(2, static_cast<int>(std::lround(n))));
  };
  page.figure("contacts_and_relaxation",
              "Each cell is one run of Jacobi on the contacts of one box. Dashed: ω = 2/μ.",
              chart(map, "ω = 2/μ", boundary, {"converges", "drifts", "rings", "diverges", "no solution"}));
  const Agreement agreed = agreement(map, boundary, Settles::below);
  page.text(
      R"(@ This is the second family without any β: each row is right by itself, and together they correct too much.
      Gauss–Seidel cannot do that, because each row sees what the rows before it have done.)",
      agreed.sentence());
  claim_agreement(page, agreed, 0.15, "law of relaxed Jacobi", setting.resolution);
  page.claim(say("relaxation from which @ contacts diverge, by bisection", contacts),
             laws::bisect([](double omega) { return laws::jacobi(contacts, omega) == Outcome::settles; }, 1 / mu,
                          std::min(1.99, 3 / mu), 0.001),
             "1", is(2 / mu, "law of relaxed Jacobi: 2/μ", relative(0.01)));
  for (const int n : {4, 16})
    page.claim(say("@ contacts, 500 sweeps of Gauss–Seidel: largest JV left, over gh", n),
               left_by_gauss_seidel(n, 500), "1", is_at_most(1e-4, "it converges for every positive definite A"));
}

}  // namespace byhand::failures
