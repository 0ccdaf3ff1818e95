#include "lessons/tutor/about.hpp"

namespace byhand::tutor {

const std::vector<About>& contents() {
  static const std::vector<About> lessons = {
      {.slug = "01_jacobian",
       .title = "Jacobian",
       .summary = "Derive J by hand, see it on the bodies, and test it.",
       .method = "poses move with constant velocities; two forms: one sweep of Gauss–Seidel a step"},
      {.slug = "02_single_constraint",
       .title = "Single constraint",
       .summary = "One bob, one rod: solve (17), apply (20), and watch what that does not solve.",
       .method = "symplectic Euler; one row solved exactly by (17); no drift cure"},
      {.slug = "03_iterations",
       .title = "Iterations",
       .summary = "Rows that share bodies undo each other's work: sweeps, their rate, and all rows at once.",
       .method = "velocity stepping, symplectic Euler"},
      {.slug = "04_baumgarte",
       .title = "Baumgarte",
       .summary = "Why rods grow, how (22) pulls them back, and how much of it a scene can bear.",
       .method = "symplectic Euler; one row solved exactly by (17), or Gauss–Seidel; Baumgarte"},
      {.slug = "05_contact",
       .title = "Contact and friction",
       .summary =
           "Rows that may only push, friction bounded by what they push with, bounces, and what a stack asks of a solver.",
       .method = "symplectic Euler; Gauss–Seidel or direct with an active set; Baumgarte"},
      {.slug = "06_joints",
       .title = "Joints",
       .summary =
           "Pins, welds, sliders, stops and motors from rows and bounds; machines against their closed forms.",
       .method = "symplectic Euler; all rows directly, or Gauss–Seidel; Baumgarte"},
      {.slug = "07_space",
       .title = "Three dimensions",
       .summary = "The same code with three axes more: turning inertia, tops that flip, friction along two axes.",
       .method =
           "symplectic Euler; Gauss–Seidel or direct; Baumgarte; gyroscopic term none, explicit or implicit"},
      {.slug = "08_where_methods_fail",
       .title = "Where methods fail",
       .summary =
           "Four families of failures: their symptoms, maps of where they live, the laws behind, the knobs.",
       .method = "symplectic Euler; Gauss–Seidel, NNCG or direct; Baumgarte, projection"},
      {.slug = "09_what_accuracy_costs",
       .title = "What accuracy costs",
       .summary = "Error against cost for every method, the price of the model, and a program that chooses.",
       .method = "all that the solver has, each with its best settings and with its defaults"},
      {.slug = "10_beside_the_engines",
       .title = "Beside the engines",
       .summary = "The same scenes in Box2D, Chipmunk, Bullet and ODE: errors, times, and who wins where.",
       .method = "velocity stepping by the scene's graph; each engine's own"}};
  return lessons;
}

}  // namespace byhand::tutor
