// Lesson 1: from C, the value of a constraint, to J, the row that says how C changes with the velocities.

#include "lessons/01_jacobian/steps.hpp"

using namespace byhand;
using namespace byhand::lesson01;

int main(int argc, char** argv) {
  course::Lesson lesson(course::lesson_of(__FILE__));
  const Settings set{
      lesson.parameter("length", 2.0, "m", {0.5, 10}, "length L of the rod"),
      lesson.parameter("stretch", 0.1, "m", {-0.1, 0.3}, "how much too long the rod is at first"),
      lesson.parameter("speed", 3.0, "m/s", {0.1, 30}, "how fast bodies move"),
      lesson.parameter("spin", 2.0, "rad/s", {-20, 20}, "how fast bodies turn"),
      lesson.parameter("h", 1.0 / 60, "s", {1e-4, 0.1}, "time step"),
      lesson.parameter("beta", 0.2, "1", {0.01, 1.5}, "share of the error that a step should remove"),
  };
  const auto with = [&](void (*step)(course::Page&, const Settings&)) {
    return [step, set](course::Page& page) { step(page, set); };
  };

  lesson.step("What C says", with(what_c_says));
  lesson.hold(in_hand(set));
  lesson.step("A rate is a row times velocities", with(one_row));
  lesson.step("Differentiate", with(differentiate));
  lesson.step("The triple product", with(triple_product));
  lesson.step("J by inspection", with(inspection));
  lesson.step("Test J with small steps", with(slopes));
  lesson.step("The same steps for a contact", with(contact));

  lesson.deeper("Dual numbers: the computer checks J", with(dual_numbers));
  lesson.deeper("Friction: the same row along a tangent", with(friction));
  lesson.deeper("How to read (23)", with(separation));
  lesson.deeper("½(d² − L²) or |d| − L?", with(two_forms));
  lesson.deeper("J of a chain, and how much of it is zero", with(linkage));
  lesson.deeper("What Jᵀ is", with(dual_map));

  lesson.closing(
      {.now_you_know =
           {"C is one number, zero where the constraint is met; for the article's rod it is in square metres.",
            "Ċ = JV: a rate is linear in the velocities. J is the row of its coefficients: l₁, a₁, l₂, a₂.",
            "To find J: differentiate C, take ω out of the cross product, read the coefficients off.",
            "J points in the direction of increasing C, whatever the sign of C. λJᵀ pushes the bodies along it.",
            "|ΔC − h·JV| falls like h²; with a wrong sign in an entry that the motion uses it falls only like h.",
            "A contact's normal points from body 1 to body 2; if you exchange the bodies, reverse it."},
       .tries = {{"A rod that is too short: watch the sign of C, and where J points.",
                  "./lessons/run jacobian --set stretch=-0.1"},
                 {"Bodies that do not turn: the test misses a wrong a₂.",
                  "./lessons/run jacobian --set spin=0 --step 6"},
                 {"A rod of ten metres, C and J from two different forms.",
                  "./lessons/run jacobian --set length=10 --step 7d"}},
       .next =
           R"(Write C and J yourself: `./lessons/run practise 1`, 2 and, with a constraint that no lesson derives, 11.

           J says in which direction to push. Lesson 2 computes how hard: λ, from the rate JV and the masses.)"});
  return lesson.run(argc, argv);
}
