// Lesson 01, Jacobian: from a number that says how wrong things are to the row of numbers that says how it
// changes.

#include "lessons/01_jacobian/steps.hpp"

using namespace byhand;
using namespace byhand::lesson01;

int main(int argc, char** argv) {
  tutor::Lesson lesson(tutor::contents().at(0));
  const Settings set{
      lesson.parameter("length", 2.0, "m", {0.2, 20}, "length L of the rod"),
      lesson.parameter("stretch", 0.1, "m", {-0.1, 1}, "how much too long the rod is at first"),
      lesson.parameter("speed", 3.0, "m/s", {0.1, 30}, "how fast bodies move"),
      lesson.parameter("spin", 2.0, "rad/s", {-20, 20}, "how fast bodies turn"),
      lesson.parameter("mass", 3.0, "kg", {0.1, 100}, "mass of a bob or link"),
      lesson.parameter("h", 1.0 / 60, "s", {1e-4, 0.1}, "time step"),
      lesson.parameter("beta", 0.2, "1", {0.01, 1.5}, "share of the error that a step should remove"),
      lesson.parameter("links", 10, "1", {2, 40}, "links of the chain"),
  };
  const auto with = [&](void (*step)(tutor::Page&, const Settings&)) {
    return [step, set](tutor::Page& page) { step(page, set); };
  };

  lesson.step("What C says", with(what_c_says));
  lesson.step("Differentiate", with(differentiate));
  lesson.step("The triple product", with(triple_product));
  lesson.step("J by inspection", with(inspection));
  lesson.step("Slope 2, or 1 if a sign is wrong", with(slopes));
  lesson.step("The same recipe for a contact", with(contact));

  lesson.deeper("Dual numbers: the machine as referee", with(dual_numbers));
  lesson.deeper("Friction: the same row along a tangent", with(friction));
  lesson.deeper("How to read (23)", with(separation));
  lesson.deeper("½(d² − L²) or |d| − L?", with(two_forms));
  lesson.deeper("A linkage's J, and how much of it is nothing", with(linkage));
  lesson.deeper("Jᵀ is not an inverse", with(dual_map));

  lesson.closing(
      {.now_you_know =
           {"C is one number, zero when all is well; for the article's rod it is in square metres.",
            "Ċ = JV: differentiate, free ω with the triple product, read the coefficients off.",
            "J points where C grows, and does not know how wrong things are.",
            "What J leaves of ΔC falls with slope 2; a wrong sign makes it slope 1.",
            "A contact's normal points from body 1 to body 2, and has to turn if the bodies change names."},
       .tries = {{"A rod that is too short: watch the sign of C, and where J points.",
                  "./lessons/run jacobian --set stretch=-0.1"},
                 {"Bodies that do not turn hide a wrong a₂: both slopes become 2.",
                  "./lessons/run jacobian --set spin=0 --step 5"},
                 {"A rod of ten metres, C and J from two different forms.",
                  "./lessons/run jacobian --set length=10 --step 6d"}},
       .next =
           R"(Write C and J yourself: `./lessons/run practise 1`, 2 and, for a constraint that no lesson derives, 11.

           You have a direction. Lesson 2 finds how hard to push along it: λ, from one number for the error and
           one for the mass.)"});
  return lesson.run(argc, argv);
}
