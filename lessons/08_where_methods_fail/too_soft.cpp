// Step 4: the contact is too soft.

#include "lessons/08_where_methods_fail/map.hpp"
#include "lessons/08_where_methods_fail/stack_film.hpp"
#include "lessons/08_where_methods_fail/steps.hpp"
#include "lessons/laws/buckling.hpp"
#include "lessons/laws/column.hpp"
#include "solver/constraints/contact.hpp"

namespace byhand::failures {
namespace {

using laws::Outcome;

// More than law 18 asks for. Solved exactly the boundary is the same, but what has buckled goes slowly.
constexpr int sweeps = 40, sweeps_filmed = 100;

Outcome nudged(int boxes, double hertz) {
  return laws::buckle({.boxes = boxes, .sweeps = sweeps, .frequency = hertz, .steps = 900});
}

/// By the law for many boxes: how tall a column contacts of this frequency hold [boxes].
double limit_of_boxes(double hertz) {
  const double stiffness = std::pow(2 * std::numbers::pi * hertz, 2) / laws::inverse_mass_of_a_corner({});
  return std::cbrt(7.837 * stiffness / (2 * gravity));
}

/// Whether it stands if each step is solved exactly.
bool stands(int boxes, double hertz) {
  return laws::buckle({.boxes = boxes, .sweeps = 0, .frequency = hertz}) == Outcome::settles;
}

/// The tallest column that stands on contacts of this frequency, by building up or taking down the law's.
int tallest(double hertz) {
  constexpr int most = 40;
  int boxes = 2;
  while (boxes < most && laws::softest_contacts(boxes + 1) < hertz) ++boxes;
  while (boxes > 2 && !stands(boxes, hertz)) --boxes;
  while (boxes < most && stands(boxes + 1, hertz)) ++boxes;
  return boxes;
}

Film<PlaneBody> film(int boxes, double hertz) {
  const auto soft = [](std::string name, double frequency, int substeps) {
    return SolvedStack{std::move(name),
                       {.solver = GaussSeidel{sweeps_filmed},
                        .drift = SoftConstraints{.frequency = 2 * std::numbers::pi * frequency},
                        .substeps = substeps}};
  };
  return film_of_stacks(boxes,
                        {soft(say("@ Hz", hertz), hertz, 1), soft(say("@ Hz, 4 substeps", hertz), hertz, 4),
                         soft(say("@ Hz", 4 * hertz), 4 * hertz, 1)},
                        3);
}

/// m_eff of a corner where one unit box of 1 kg lies on another [kg].
double effective_mass_of_a_corner() {
  using M = PlaneBody;
  Pose<M> below, above;
  above.position.y() = 1;
  const InverseMass<M> mass = box<M>(1, {1, 1});
  const Contact<M> corner{{0, 1, {Arm<M>(0.5, 0.5), Arm<M>(0.5, -0.5)}}};
  const auto J = corner.jacobian(below, above);
  return 1 / inverse_effective_mass(J, times_inverse_mass(J, mass, below, mass, above))(0, 0);
}

}  // namespace

void too_soft(const Setting& setting, Page& page) {
  const double hertz = setting.hertz;
  const int highest = tallest(hertz), filmed = highest + highest / 3 + 1, twice = tallest(2 * hertz);

  page.text(
      R"(**Symptom of the fourth family:** a stack leans, bows and falls, and *neither sweeps nor substeps move the
      limit*. Its model is too soft. Many engines make contacts soft: each is a damped spring (lesson 6) of stiffness k
      = m_eff ω², tuned by its frequency ω/2π, where m_eff = 1/(JM⁻¹Jᵀ) is the row's effective mass (lesson 2). One
      such row is stable at every ωh. But a stack on springs, solved as well as you like, still stands on springs.)");
  page.text(
      R"(In 1881 A. G. Greenhill computed how tall a tree can grow before it buckles under its own weight. A column of
      N boxes on soft contacts is such a tree. A box of width w, height a and mass m that is turned by δ
      against the one below is turned back with the torque kw²δ/2. If the top leans by θ, each of the N contacts turns
      by δ ≈ θ/N: together they store about N · kw²(θ/N)² = kw²θ²/N, while the weights lose about mgaN²θ². The column
      buckles when the weights lose more, whatever the step. Here w = a = 1 m; square boxes a tenth as large need
      contacts of √10 times the frequency.)");
  page.predict(
      {.ask = say("By the law below, contacts of @ Hz hold stacks of up to N = @. How many boxes do contacts of @ "
                  "Hz hold?",
                  hertz, Value(limit_of_boxes(hertz), 3), 2 * hertz),
       .answer = static_cast<double>(twice),
       .unit = "boxes",
       .tolerance = std::max(0.12 * twice, 1.6),
       .wrong = {{2.0 * highest, "k grows with the square of the frequency, and N with the cube root of k."},
                 {4.0 * highest, "k is four times as large, but it is N³ that grows with k."},
                 {static_cast<double>(highest),
                  "They are four times as stiff, and it is stiffness that holds a stack up."}},
       .hints = {"How does the stiffness grow with the frequency, and what must it hold?",
                 "k = m_eff ω², and mgaN² < kw²/N: N³ is proportional to k.",
                 say("N³ grows by a factor of 4: N = @ · 4^(1/3)", Value(limit_of_boxes(hertz), 3))},
       .hinted = std::floor(limit_of_boxes(2 * hertz)),
       .right = say("k is 4 times as large, so N grows by its cube root, a factor of 1.59: @ by the law; in runs "
                    "@ boxes stand.",
                    Value(limit_of_boxes(2 * hertz), 3), twice)});
  page.formula(
      "N³ < 7.84 k w²/(2 m g a),   k = m_eff ω²,   m_eff = m/5:   @ boxes at @ Hz",
      R"(N^3 < 7.84\,\frac{k w^2}{2 m g a}, \quad k = m_{\text{eff}}\,\omega^2, \quad m_{\text{eff}} = \frac{m}{5}: \quad @ \text{ boxes at } @\ \mathrm{Hz})",
      highest, setting.hertz);
  page.derivation(
      "Why N³ < 7.84 kw²/2mga",
      {{"a face that turns by θ moves its ends by wθ/2 each", "torque = 2 · k (wθ/2) · w/2 = κθ,   κ = kw²/2",
        R"(\kappa = \tfrac12 k w^2)"},
       {"energy of N boxes that lean by θ₁ … θ_N; the ground's contacts are twice as stiff",
        "½κ [2θ₁² + Σ (θᵢ − θᵢ₋₁)²] − ½mga Σ (N − i + ½) θᵢ²",
        R"(\tfrac12\kappa\Bigl[2\theta_1^2 + \sum(\theta_i - \theta_{i-1})^2\Bigr] - \tfrac12 mga\sum(N - i + \tfrac12)\,\theta_i^2)"},
       {"for many boxes of height a", "½κ ∫ θ'² dx − ½mga ∫ (N − x) θ² dx",
        R"(\tfrac12\kappa\int\theta'^2\,dx - \tfrac12 mga\int(N - x)\,\theta^2\,dx)"},
       {"least where (Greenhill's equation)", "κθ'' + mga(N − x)θ = 0,   θ(0) = 0,   θ'(N) = 0",
        R"(\kappa\theta'' + mga(N - x)\,\theta = 0, \quad \theta(0) = 0, \; \theta'(N) = 0)"},
       {"solved by a Bessel function whose first root is 1.866", "mgaN³/κ = (9/4) · 1.866² = 7.84",
        R"(\frac{mgaN^3}{\kappa} = \tfrac94\cdot 1.866^2 = 7.84)"},
       {"the row at a corner of two square boxes, I = mw²/6", "JM⁻¹Jᵀ = 2/m + 2(w/2)²/I = 5/m   ⟹   m_eff = m/5",
        R"(JM^{-1}J^T = \frac2m + \frac{2(w/2)^2}{I} = \frac5m \;\Rightarrow\; m_{\text{eff}} = \frac m5)"}});

  const Film<PlaneBody> stacks = film(filmed, hertz);
  page.sequence(
      "buckling_stack",
      say(R"(@ boxes on soft contacts, @ sweeps a step, after a slight push, shown at @ times the speed. On contacts
          of @ Hz the stack @; in 4 substeps the stack @; on contacts of @ Hz it @.)",
          filmed, sweeps_filmed, stacks.hurry(), hertz, stacks.fate(0), stacks.fate(1), 4 * hertz, stacks.fate(2)),
      Seconds{stacks.seconds()}, stacks.drawing());

  const auto off = [&](int take) { return stacks.failed(take) ? filmed : stacks.last(take); };
  std::string standing;
  for (const auto& [take, where] :
       {std::pair{0, "on these contacts"}, {1, "in 4 substeps"}, {2, "on the stiffer ones"}})
    if (!stacks.failed(take))
      standing += say("@@ m off @", standing.empty() ? "" : ", ", Value(stacks.last(take), 2), where);
  page.text(
      "Contacts of @ Hz hold @ boxes, so these @ buckle.@", hertz, highest, filmed,
      standing.empty() ? "" : say(" After @ s the top box is @.", stacks.hurry() * stacks.seconds(), standing));

  static std::map<int, Map> maps;
  const Map& map = kept(maps, setting.resolution, [&] {
    return map_of(page, counting_knob("boxes N", 4, 22, setting.resolution, renderer::Scale::linear),
                  knob("frequency of the contacts (Hz)", 8, 100, setting.resolution),
                  [](double n, double hz) { return nudged(static_cast<int>(n), hz); });
  });
  const auto boundary = [](double n) { return laws::softest_contacts(static_cast<int>(std::lround(n))); };
  page.figure("boxes_and_stiffness",
              say("Each cell is one run of 15 s, 60 steps a second of @ sweeps. The push is "
                  "10⁻⁷ m/s, not "
                  "0.02 m/s as in the film, so most columns that buckle only lean after 15 s. Dashed: the law for "
                  "N boxes.@",
                  sweeps, on_ringing(map)),
              chart(map, "N³ = 7.84 kw²/2mga", boundary, stack_outcomes));
  const Agreement agreed = agreement(map, boundary, Settles::above);
  page.text(agreed.sentence());
  page.text(
      R"(**Which knob?** Stiffer contacts, or fewer boxes. Engines cap the frequency of a contact at a share of their
      step rate (Box2D 3.2: an eighth), so their substeps help after all where they allow stiffer contacts. Hard
      contacts do not buckle; only the limit of the first family applies to them.)");
  page.text(
      R"(From the casebook, rows softer than their users thought: joints that do not stiffen, `./lessons/run case 2`;
      friction that cannot hold, `./lessons/run case 3`; a contact that sinks when it is told to be stiff,
      `./lessons/run case 12`.)");

  claim_agreement(page, agreed, 0.15, "law of buckling", setting.resolution);
  const Condition in_reach = within(8, Quantity("boxes", highest), 30);
  const double law = laws::softest_contacts(highest);
  if (in_reach)
    page.claim(say("softest contacts on which @ boxes stand, by bisection", highest),
               laws::bisect([=](double hz) { return stands(highest, hz); }, 0.6 * law, 1.6 * law, 0.004), "Hz",
               is(law, "law of buckling, for so many boxes", relative(0.04)), in_reach);
  constexpr laws::BoxSize crate{0.2, 0.2};
  const double crates = laws::softest_contacts(10, crate);
  page.claim("softest contacts on which 10 boxes of 0.2 m stand, by bisection",
             laws::bisect(
                 [=](double hz) {
                   return laws::buckle({.boxes = 10, .size = crate, .sweeps = 0, .frequency = hz}) ==
                          Outcome::settles;
                 },
                 0.6 * crates, 1.6 * crates, 0.004),
             "Hz", is(crates, "law of buckling, with their height and width", relative(0.04)));
  page.claim("effective mass of the contact at a corner of two boxes of 1 kg", effective_mass_of_a_corner(), "kg",
             is(0.2, "1/(2/m + 2(w/2)²/I), I = mw²/6", relative(1e-12)));
  page.claim("top box in the film: how far off on soft contacts, over contacts 16 times as stiff",
             std::min(off(0), off(1)) / off(2), "1", is_at_least(10, "law of buckling"));
}

}  // namespace byhand::failures
