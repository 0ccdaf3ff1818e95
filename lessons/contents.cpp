#include "lessons/page/about.hpp"

namespace byhand::course {

const std::vector<About>& contents() {
  static const std::vector<About> lessons = {
      {.slug = "01_jacobian",
       .title = "Jacobian",
       .summary = "Derive J by hand, see it on the bodies, and test it.",
       .method = "poses move with constant velocities; two forms: one sweep of Gauss–Seidel a step",
       .goals = {"derive C and J of a rod, a contact and a friction row by hand",
                 "say in which direction λJᵀ pushes each body",
                 "test a J with small steps, and find which part is wrong"},
       .before = "Vectors in the plane: dot and cross product, derivatives of a product. No mechanics."},
      {.slug = "02_single_constraint",
       .title = "Single constraint",
       .summary = "One bob, one rod: compute the impulse that keeps the rod's length, apply it, and see what it "
                  "leaves wrong.",
       .method = "symplectic Euler; one row solved exactly by (17); no drift cure",
       .goals = {"compute JM⁻¹Jᵀ and λ of one row with numbers", "turn λ into the tension of a rod, with its sign",
                 "say what JV = 0 leaves uncorrected"},
       .before = "Lesson 1; velocity, mass, kinetic energy, moment of inertia."},
      {.slug = "03_iterations",
       .title = "Iterations",
       .summary = "Rows that share bodies undo each other's work: sweeps, their rate, and all rows at once.",
       .method = "velocity stepping, symplectic Euler",
       .goals = {"carry out a sweep of Gauss–Seidel by hand", "predict how many sweeps a chain needs",
                 "decide between sweeps, a warm start and a direct solve"},
       .before =
           "Lessons 1 and 2; matrices and systems of linear equations. Eigenvalues help in the deeper steps."},
      {.slug = "04_baumgarte",
       .title = "Baumgarte",
       .summary = "Why rods grow, how a correction pulls them back, and how much correction a scene can stand.",
       .method = "symplectic Euler; one row solved exactly by (17), or Gauss–Seidel; Baumgarte",
       .goals = {"predict how fast a rod drifts",
                 "choose β for a scene and a time step, and say where it becomes unstable",
                 "read a formula for its units"},
       .before = "Lessons 1 and 2; step 6b also uses lesson 3."},
      {.slug = "05_contact",
       .title = "Contact and friction",
       .summary = "Rows that may only push, friction bounded by what they push with, bounces, and what a stack "
                  "asks of a solver.",
       .method = "symplectic Euler; Gauss–Seidel or direct with an active set; Baumgarte",
       .goals = {"clamp the sum of all impulses of a row", "predict what sticks, what slides and how far",
                 "say what a stack asks of a solver"},
       .before = "Lessons 1 to 4."},
      {.slug = "06_joints",
       .title = "Joints",
       .summary =
           "Pins, welds, sliders, stops and motors from rows and bounds; machines against their closed forms.",
       .method = "symplectic Euler; all rows directly, or Gauss–Seidel; Baumgarte",
       .goals = {"build pins, welds, sliders, stops and motors from rows and bounds",
                 "count degrees of freedom by the rank of J", "recognise redundant and conflicting rows"},
       .before = "Lessons 1 to 4; lesson 5 for bounds."},
      {.slug = "07_space",
       .title = "Three dimensions",
       .summary =
           "The same code with three more axes: turning inertia, a book that flips, friction along two axes.",
       .method = "symplectic Euler; Gauss–Seidel or direct; Baumgarte; gyroscopic term none, explicit or implicit",
       .goals = {"carry the inertia of a body along as it turns", "choose how to treat the gyroscopic term",
                 "bound friction along two axes"},
       .before = "Lessons 1 to 5; rotations in space. Quaternions are explained."},
      {.slug = "08_where_methods_fail",
       .title = "Where methods fail",
       .summary =
           "Five families of failures: their symptoms, their laws, maps of their limits, and the knobs that help.",
       .method = "symplectic Euler; Gauss–Seidel, NNCG or direct; Baumgarte, projection",
       .goals = {"tell five families of failures apart by their symptoms",
                 "predict where each begins from its law", "turn the knob that helps"},
       .before = "Lessons 1 to 6."},
      {.slug = "09_what_accuracy_costs",
       .title = "What accuracy costs",
       .summary = "Error against cost for every method, the price of the model, and a program that chooses.",
       .method =
           "all that the solver has, the best of all choices at each point: substeps and sweeps in steps of 2, "
           "strengths of √2, relaxations of 1.3, until no step gains 5 %; at most 20 initial conditions; times "
           "are medians of the frames in 20 ms",
       .goals = {"read a chart of error against cost",
                 "choose a method, a step and a number of sweeps for a scene and an accuracy",
                 "say which error a number means"},
       .before = "Lessons 1 to 4 and 8; the methods beyond the article are explained."},
      {.slug = "10_beside_the_engines",
       .title = "Beside the engines",
       .summary = "How to compare engines fairly: the same scenes and measures in Box2D, Box3D, Chipmunk, Bullet, "
                  "ODE, MuJoCo, PhysX, Jolt and Rapier.",
       .method = "velocity stepping by the scene's graph; each engine's own",
       .goals = {"compare engines fairly: the same scene, settings of equal cost, and one definition of error",
                 "say what an engine gives up for its speed, scene by scene",
                 "know where the course's solver loses, and why"},
       .before = "Lessons 5, 6 and 9.",
       .native = "the engines are native libraries, which a browser cannot load"}};
  return lessons;
}

}  // namespace byhand::course
