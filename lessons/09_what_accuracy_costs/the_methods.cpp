// Step 1 and 1a: the methods that the charts compare, those that no lesson before has had with their recipes.

#include "lessons/09_what_accuracy_costs/steps.hpp"
#include "lessons/catalogue/run.hpp"

namespace byhand::accuracy {
namespace {

struct Recipe {
  std::string_view name, source, idea;
  std::array<std::string_view, 5> lines;
  std::string_view knob, holds;
};

const std::vector<Recipe> recipes{
    {"XPBD",
     "extended position-based dynamics; M. Macklin, M. Müller and N. Chentanez, 2016; for rigid bodies M. Müller "
     "and "
     "others, 2020",
     R"(corrects *positions*. It lets the bodies move freely, moves them back until the constraints hold, and takes the
     velocities from the distances covered.)",
     {"Move freely: v ← v₀ + hg, x ← x₀ + hv.", "Start every Λ at 0.",
      "For each constraint, at its present C: ΔΛ = −(C + γΛ)/(JM⁻¹Jᵀ + γ), γ = 1/(kh²) for a spring of stiffness "
      "k, 0 for a hard constraint.",
      "Correct at once: x ← x + M⁻¹Jᵀ ΔΛ.", "Read the velocity: v ← (x − x₀)/h."},
     "substeps, and the passes (iterations) in each; its authors advise one",
     R"(It holds rods, joints and contacts; joints are stable at every step.)"},
    {"AVBD",
     "augmented vertex block descent, C. Giles and others, 2025",
     R"(minimises, *body by body*, the energy of a step of implicit Euler, in which each constraint is a spring of
     stiffness κ plus a force Λ that makes up for what the spring lacks.)",
     {"Free motion: y = x₀ + h(v₀ + hg).",
      "For each body, with F = Λ − κ(C − αC₀) and G for the curvature of C: (M/h² + Σ κJᵀJ + G) Δx = −M(x − y)/h² "
      "+ Σ JᵀF.",
      "After each round over the bodies: Λ ← F, and a larger κ where C is not zero.",
      "Repeat for a number of rounds (iterations).", "Read the velocity: v ← (x − x₀)/h."},
     "iterations; α, the share of the old error C₀ that a step leaves",
     R"(It holds rods, joints and contacts, hard ones and very soft ones. Momentum is kept only as far as the rounds
     have converged, and an effect spreads by only a few bodies a round. κ is two things at once: the stiffness of the
     material, and the penalty of the iteration, whose start and growth decide whether it converges. With all masses
     multiplied by 1000 its authors' own program is unstable (avbd-demo2d, issue 11). NVIDIA's engine Newton has
     deprecated it for rigid bodies (newton, issue 3333 and pull request 3769, July 2026) in favour of an augmented
     Lagrangian method in which stiffness and penalty are separate numbers.)"},
    {"RATTLE",
     "H. C. Andersen, 1983",
     R"(is the leapfrog with constraints: half a kick of gravity, a move, half a kick. It has two sets of impulses, one
     for C = 0 after the move and one for JV = 0 after the second kick.)",
     {"V½ = V₀ + ½hg + M⁻¹J(x₀)ᵀλ", "x₁ = x₀ + hV½",
      "Choose λ so that C(x₁) = 0, by Newton's method with one factor.", "V₁ = V½ + ½hg + M⁻¹J(x₁)ᵀμ",
      "Choose μ so that J(x₁)V₁ = 0."},
     "substeps",
     R"(It holds C and JV to rounding, is of order 2, and its energy error stays bounded. It cannot handle contacts or
     redundant rows, and a step that is too long has no solution.)"},
    {"Accelerations (index 1)",
     "E. Hairer and G. Wanner, Solving Ordinary Differential Equations II",
     R"(are not a method yet, but the base of three: explicit Euler, RK4 and implicit midpoint. Differentiate C twice,
     solve for forces instead of impulses, and an ordinary differential equation is left.)",
     {"C̈ = JV̇ + J̇V = 0", "Newton's law: MV̇ = F + Jᵀf", "So JM⁻¹Jᵀ f = −(JM⁻¹F + J̇V): (17) with forces.",
      "V̇ = a(x, V) = M⁻¹(F + Jᵀf)",
      "Integrate ẋ = V and V̇ = a(x, V) by any rule: explicit Euler is the simplest."},
     "substeps",
     R"(The forces are exact for the present state. But they enforce only C̈ = 0, so C drifts. No contacts.)"},
    {"RK4",
     "the classical rule of C. Runge and W. Kutta, about 1900",
     R"(integrates these accelerations with four slopes a step, each the pair (V, a) at some state.)",
     {"k₁ at the start", "k₂ half a step along k₁", "k₃ half a step along k₂", "k₄ a whole step along k₃",
      "The step: h (k₁ + 2k₂ + 2k₃ + k₄)/6"},
     "substeps",
     R"(It is of order 4, the highest of the fixed-step methods here. Its drift and energy error are small, but grow
     with time.)"},
    {"Implicit midpoint",
     "symmetric in time, the simplest of Gauss's rules",
     R"(integrates the same accelerations with one slope a step, that at its own middle.)",
     {"Guess V_m = V₀.", "X_m = x₀ + ½hV_m", "V_m ← V₀ + ½h a(X_m, V_m)", "Repeat the last two until V_m stays.",
      "x₁ = x₀ + hV_m, V₁ = V₀ + h a(X_m, V_m)"},
     "substeps",
     R"(It is of order 2. For particles on rods, energy and C stay near their values for tens of periods and then leave
     them (`--set appendix=thousand_periods` shows it). A step that is too long does not converge.)"},
    {"Generalised coordinates",
     "R. Featherstone, 1983, the articulated body algorithm",
     R"(keep one number for each hinge, its angle, and no constraint at all. A body's place follows from its parent's
     place and that number, so C = 0 by construction.)",
     {"A joint lets a body move with V = XV_p + Sq̇: X carries its parent's motion over, S adds that of its own "
      "numbers q.",
      "From the free ends inwards, each body with all that hangs on it gets an articulated inertia A and a bias "
      "force p: "
      "the force through its joint is f = AV̇ + p.",
      "The joint does no work along S: Sᵀf = 0 gives q̈. What is left, f = ĀXV̇_p + p̄, is passed on: the parent "
      "adds "
      "XᵀĀX to its A and Xᵀp̄ to its p.",
      "From the root outwards: V̇ and q̈ of each joint.",
      "Integrate q̇ and q̈ by any rule: semi-implicit Euler, as robotics engines do, or RK4."},
     "substeps",
     R"(No joint opens at any step, the work is in proportion to the number of joints, and RK4 keeps its order 4. It
     works on trees: no loops, contacts or bounds. It can be unstable: a step that is too long makes energy.)"},
    {"NNCG",
     "nonsmooth nonlinear conjugate gradients, M. Silcowitz-Hansen and others, 2010; *conjugate sweeps* on the "
     "charts",
     R"(speeds up Gauss–Seidel. It takes the change of λ by a sweep for a gradient, and lets λ move on along earlier
     changes too.)",
     {"One sweep: g = (λ after it) − (λ before it).", "s = |g|²/|g of the sweep before|², but 0 if g has grown.",
      "λ ← λ + s d, and V with it.", "d ← g + s d", "Repeat, and end with a sweep, so that λ keeps its bounds."},
     "sweeps",
     R"(It does all that Gauss–Seidel does, contacts too. An error that decays slowly needs only about the square
     root of the sweeps it would need otherwise. With bounds there is no proof, and on some stacks no gain.)"},
    {"Accelerated gradient",
     "H. Mazhar and others, 2015, after Y. Nesterov, 1983",
     R"(moves all λ at once down the gradient JV + b + γλ, clamps them to their bounds, and goes on with momentum.)",
     {"g = JV + b + γλ at a point y ahead of λ", "λ' = y − D⁻¹g/L, clamped; D is the diagonal of JM⁻¹Jᵀ.",
      "L is doubled until it bounds the curvature on the way.",
      "y ← λ' + β(λ' − λ), with Nesterov's β; uphill β = 0", "Repeat; the best λ is kept."},
     "iterations",
     R"(It does all that Gauss–Seidel does, and the order of the rows does not matter. The error falls as 1/k² in k
     iterations.)"}};

const Recipe& recipe_of(std::string_view name) {
  return *std::find_if(recipes.begin(), recipes.end(), [=](const Recipe& one) { return one.name == name; });
}

void introduce(Page& page, const Recipe& recipe) {
  std::string text =
      say("**@** (@) @\n\n", std::string(recipe.name), std::string(recipe.source), unwrapped(recipe.idea));
  for (const std::string_view line : recipe.lines) text += say("- @\n", std::string(line));
  page.text(text +
            say("\n*Knob*: @. *Strengths and limits*: @", std::string(recipe.knob), unwrapped(recipe.holds)));
}

/// The largest error of a pendulum's rod within a time [m].
double drift_within(const Problem& problem, const byhand::Setting& setting, double seconds) {
  AnyScene scene = problem.start();
  scene.use(setting.method);
  double largest = 0;
  while (scene.time() < seconds - 0.5 * frame) {
    scene.step(frame);
    largest = std::max(largest, scene.separation());
  }
  return largest;
}

/// "yes", or why not.
std::string answer(const std::string& refusal) { return refusal.empty() ? "yes" : "no"; }

}  // namespace

void the_methods(Page& page) {
  page.text(
      R"(Eight lessons have given you methods and their knobs. This one runs them all on scenes whose true motion is
      known, and sets their errors against the work they take. Two new ones come first, in five lines each; step 1a has
      the others.)");
  introduce(page, recipe_of("XPBD"));
  introduce(page, recipe_of("RATTLE"));
  page.text(
      R"(The charts also show methods of earlier lessons: Gauss–Seidel, its symmetric form and SOR, Jacobi, conjugate
      gradients and direct solves (lesson 3), Baumgarte (lesson 4), split impulse, soft constraints and projection. Any
      cure of drift goes with any solver of rows; each point of a chart is the best of their combinations.)");
}

void other_methods(Page& page) {
  const Problem pendulum("pendulum", {{"length", 2}, {"mass", 3}}), stack("stack", {{"boxes", 3}});
  const byhand::Setting rk4 = family_named("RK4").setting({});
  const double five = drift_within(pendulum, rk4, 5), ten = drift_within(pendulum, rk4, 10);
  page.choose(
      {.ask = R"(Some methods hold C̈ = 0 instead of JV = 0: they solve for forces and integrate the accelerations.
          RK4 does so in each of its four stages. What happens to the length of a pendulum's rod?)",
       .options = {{"it stays right to rounding", "C̈ = 0 leaves C free to be any straight line in time."},
                   {"its error grows",
                    say(R"(Nothing pulls C back to zero, so every small error stays: @ m off after 5 s, @ m
                                    after 10 s.)",
                        Value(five, 2), Value(ten, 2))},
                   {"its error swings about zero",
                    "Something would have to pull C back, but C̈ = 0 does not contain C."}},
       .answer = ten > 1.3 * five ? 1 : 0,
       .hints = {"What does C̈ = 0 say about C itself?", "C̈ = 0 integrates to C = C₀ + Ċ₀ t.",
                 "Each step leaves a small error in C₀ or Ċ₀. What removes it?"}});

  for (const Recipe& recipe : recipes)
    if (recipe.name != "XPBD" && recipe.name != "RATTLE") introduce(page, recipe);
  page.text("Not every method can do every scene:");
  std::vector<std::vector<std::string>> rows;
  int without_contacts = 0, refused = 0;
  for (const Family& family : families()) {
    Knobs knobs;
    if (family.name == "AVBD") knobs = with_cure(knobs, Cure::baumgarte);
    const Method method = family.setting(knobs).method;
    const std::string joints = pendulum.start().refusal(method), contacts = stack.start().refusal(method);
    refused += !joints.empty();
    without_contacts += !contacts.empty();
    std::string choices = "substeps";
    if (!family.pass.empty()) choices += ", " + family.pass + "s";
    if (family.most_relaxation > family.least_relaxation) choices += ", ω";
    rows.push_back(
        {family.name, choices, family.cures.size() > 1 ? "any" : "its own", answer(joints), answer(contacts)});
  }
  page.table({"method", "to choose", "cure of drift", "rods and joints", "contacts"}, rows);

  page.claim("methods that cannot do rods", static_cast<double>(refused), "1",
             is(0, "the paragraphs above", absolute(0)));
  page.claim(
      "methods that cannot do contacts", static_cast<double>(without_contacts), "1",
      is(7, "RATTLE, three rules on accelerations, conjugate gradients, generalised coordinates", absolute(0)));
  page.claim("RK4 on a pendulum: error of the rod after 10 s, over 5 s", ten / five, "1",
             is_at_least(1.3, "nothing takes it away"));
  const auto energy_change = [&](const char* name) {
    return measure(pendulum, family_named(name), {})[Error::energy];
  };
  page.claim("implicit midpoint on a pendulum: change of energy over 10 s, over mgL",
             energy_change("implicit midpoint"), "1", is_at_most(1e-3, "symmetric, and the time is short"));
  const byhand::Point euler = measure(pendulum, family_named("explicit Euler"), {});
  page.claim("explicit Euler on the same accelerations: seconds until the rod is off by a tenth",
             euler.outcome == Outcome::opened ? euler.seconds : INFINITY, "s",
             is_at_most(5, "order 1: it gains energy, and nothing holds C"));
}

}  // namespace byhand::accuracy
