#include "lessons/07_space/steps.hpp"

// The same solver with three axes to move along and three to turn about: what stays, what turns with the body, and
// what a second axis of friction asks.
int main(int argc, char** argv) {
  using namespace byhand;
  using namespace byhand::space;

  course::Lesson lesson(course::lesson_of(__FILE__));
  const Setting setting{
      .h = lesson.parameter("h", 1.0 / 60, "s", {1.0 / 480, 1.0 / 30}, "time step"),
      .tilt = lesson.parameter("tilt", 60.0, "deg", {0, 90}, "how far the caught book is turned"),
      .angle = lesson.parameter("angle", 60.0, "deg", {20, 75}, "of the pendulums from straight down"),
      .spin = lesson.parameter("spin", 10.0, "rad/s", {2, 15}, "of the book about its y axis"),
      .wobble = lesson.parameter("wobble", 0.05, "1", {0.005, 0.3}, "share of the spin about each other axis"),
      .friction = lesson.parameter("friction", 0.3, "1", {0.1, 1}, "coefficient μ"),
  };
  const auto with = [setting](void (*step)(const Setting&, course::Page&)) {
    return [=](course::Page& page) { step(setting, page); };
  };

  lesson.step("The same code", with(same_code));
  lesson.step("The inertia turns with the body", with(turned_inertia));
  lesson.step("A pendulum on a cone", with(conical));
  lesson.step("A pendulum between two cones", with(nutation));
  lesson.step("ω turns without a force", with(left_out));
  lesson.step("The book that flips", with(flips));
  lesson.hold(book_in_hand(setting));
  lesson.step("Two axes of friction", with(two_axes));

  lesson.deeper("Orientations and hinges", with(orientation));
  lesson.deeper("Swing and twist", with(swing_and_twist));
  lesson.deeper("A gyroscope does not fall", with(gyroscope));
  lesson.hold(gyroscope_in_hand(setting));
  lesson.deeper("A book that tumbles", with(let_loose));
  lesson.deeper("A turntable", with(turntable));

  lesson.closing(
      {.now_you_know =
           {"A row has the same four parts in space; r × n has three numbers there, and a row has 12.",
            R"(I belongs to the body and turns with it: RIRᵀ. If R is forgotten, JV still vanishes, but the angular
            momentum changes.)",
            "A rod conserves the angular momentum about the vertical to rounding; the periods have an error that "
            "falls "
            "with the step.",
            R"(Iω stays, so ω turns. Without the gyroscopic term nothing flips, with the explicit term energy grows, the
            implicit one conserves energy and momentum.)",
            "Coulomb's bound is a disc. Bounded axis by axis it is a square, which favours directions and bends "
            "paths."},
       .tries = {{"A smaller wobble takes longer to grow into a flip:",
                  "./lessons/run space --step 6 --set wobble=0.005"},
                 {"A faster spin: with the explicit term energy grows faster.",
                  "./lessons/run space --step 6 --set spin=15"},
                 {"A book that is not turned hides the mistake:", "./lessons/run space --step 2 --set tilt=0"}},
       .next =
           R"(You now have all of the article in three dimensions. Lesson 8 shows where its methods fail, lesson 9 what
               their accuracy costs.)"});
  return lesson.run(argc, argv);
}
