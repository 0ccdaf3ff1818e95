// Deeper: a pyramid, whose contacts make loops.

#include "lessons/05_contact/column.hpp"
#include "lessons/05_contact/steps.hpp"
#include "lessons/pictures/boxes.hpp"

namespace byhand::contact {
namespace {

constexpr double wall_seconds = 5, slop = 0.001, kick_speed = 0.02;  // [s], [m], [m/s]

Pile wall(int base, const RowSolver& solver) {
  Pile pile{pyramid(base), {solver, Baumgarte{.slop = slop}}};
  kick(pile.scene, kick_speed);
  return pile;
}

GaussSeidel coloured(int sweeps) { return {.sweeps = sweeps, .order = SweepOrder::coloured}; }

/// What becomes of the λ of a face's two points from one step to the next: each goes to its own point, none is
/// kept, or each goes to the other point.
enum class Ids { kept, lost, exchanged };

/// When step 7's kicked stack falls [s]; infinity if it stands.
double falls_with(Ids ids, const Setting& setting, int sweeps) {
  const double h = setting.h();
  Pile stack = column(setting.boxes, GaussSeidel{.sweeps = sweeps});
  System<PlaneBody>& system = stack.work.system;
  ContactManager<PlaneBody>& contacts = stack.work.contacts;
  while (stack.time < patience - 0.5 * h) {
    if (ids == Ids::lost) contacts = {};
    stack.step(h);
    if (has_fallen(stack)) return stack.time;
    if (ids != Ids::exchanged) continue;
    for (const ContactPair<PlaneBody>& pair : contacts.pairs()) {
      const int row = system.row_of[pair.constraint];
      if (pair.size == 2) std::swap(system.lambda[row], system.lambda[row + 1]);
    }
    contacts.read_impulses(system);
  }
  return INFINITY;
}

/// What ids decide, in one stack: when it falls by Ids [s].
std::vector<double> fell_by_ids(const Setting& setting, int sweeps, const Page& page) {
  return page.side_by_side(3, [&](int i) { return falls_with(static_cast<Ids>(i), setting, sweeps); });
}

Chart overlaps(int base, double h) {
  Chart chart{.x = {.label = "time (s)"}, .y = {.label = "largest overlap (mm)", .scale = Scale::logarithmic}};
  const std::pair<std::string, RowSolver> solvers[] = {
      {"2 sweeps", coloured(2)}, {"8 sweeps", coloured(8)}, {"conjugate", ByGraph{}}};
  for (const auto& [name, solver] : solvers) {
    Pile pile = wall(base, solver);
    Curve curve{.label = name};
    while (pile.time < wall_seconds - 0.5 * h) {
      pile.step(h);
      curve.x.push_back(pile.time);
      curve.y.push_back(std::max(1e-3, 1000 * position_error(pile).max));
    }
    chart.curves.push_back(std::move(curve));
  }
  chart.references.push_back({.value = 1000 * slop, .label = "slop"});
  return chart;
}

}  // namespace

void wall_of_boxes(const Setting& setting, Page& page) {
  const int base = setting.base, boxes = base * (base + 1) / 2;
  const double h = setting.h();
  const ByGraph solver;
  Pile pile = wall(base, solver);
  const auto top = pile.scene.bodies().pose.back().position;
  while (pile.time < wall_seconds - 0.5 * h) pile.step(h);

  const double left = position_error(pile).max, moved = (pile.scene.bodies().pose.back().position - top).norm();
  const bool stands = moved < 0.5;

  page.text(
      R"(In a pyramid every box rests on two others. The contacts form loops, and a direct solve would have to pay for
      each of them. Sweeps do well here: the weight comes down through @ layers, not @ boxes, and a broad base does not
      bend as a column does.)",
      base, boxes);
  page.text(
      R"(Where do the contacts of boxes come from? For two boxes the solver takes three steps:

      - *separating axes*: along each of the four axes (two per box), how far apart are the boxes, or (negative) how
        deep do they overlap? The largest of these numbers is C, and its normal is n
        (`solver/contact/boxes_in_plane.cpp`);
      - *clipping*: n belongs to a face of one box; the facing side of the other is cut off at that face's ends, and
        what is left ends in the points P, each with its own C;
      - *feature ids*: each point records the two corners that made it. In the next step the same pair is the same
        contact and gets its λ back.)");
  const int sweeps = 2 * setting.sweeps;
  const std::vector<double> fell = fell_by_ids(setting, sweeps, page);
  page.text(
      R"(Take step 7's kicked stack, with @ warm sweeps a step. @ (The sum of the two, the weight, is then still right;
      their difference, which bends the stack back, has the wrong sign.))",
      sweeps,
      page.verdict({{.when = where(has_fate("by ids", fell[0]), has_fate("ids lost", fell[1]),
                                   has_fate("λ exchanged", fell[2])),
                     .say = say(R"(With its ids it @. Lose them, and every start is cold, whatever the solver's
                                settings say: it @. Give each λ to the other point of its face: it @.)",
                                fate(fell[0]), fate(fell[1]), fate(fell[2]))}}));
  page.text(
      R"(**Colours.** Rows are sorted into groups, the colours, in which no two rows share a moving box. Rows of one
      colour do not disturb each other, so their order does not matter and they can be solved in parallel.)");
  page.text(
      R"(**Conjugate sweeps** (NNCG, nonsmooth nonlinear conjugate gradients) make use of the sweeps before. The recipe:

      - do a sweep; its change Δ of λ is called the gradient;
      - let c = |Δ|²/|Δ of the sweep before|², or 0 in the first round or if that is above 1;
      - move λ on by c·p along the last direction p;
      - set the new direction to c·p + Δ;
      - repeat; the last operation is a sweep, which puts λ within its bounds.

      The knob is the tolerance: a sweep in which no impulse changes by more than that share of the largest is the last
      of its step (here @). For slow errors the number of sweeps falls to about its square root. When a bound begins or
      ceases to act, the direction is useless for a few sweeps.)",
      solver.loops.tolerance);
  const std::vector<Pressed> contacts = pressed(pile, h);
  double most = 0, ground = 0;
  for (const Pressed& contact : contacts) {
    most = std::max(most, contact.force);
    if (contact.body1 == 0) ground += contact.force;
  }
  page.figure("pyramid",
              say(R"(@ boxes of 1 kg, @ s after a kick (@ m/s at the top). A darker box carries more; the largest
                  contact force is @ N. Lines join the bodies that touch, and are as thick as the force.)",
                  boxes, wall_seconds, kick_speed, Value(most, 3)),
              [shapes = pictures::shapes_of(pile.scene), pose = pile.scene.bodies().pose, contacts, most,
               base](Canvas& canvas) mutable {
                std::vector<double> load(pose.size(), 0.0);
                for (const Pressed& contact : contacts) load[contact.body2] += contact.force;
                const double heaviest = *std::max_element(load.begin(), load.end());
                canvas.look(fit({-0.58 * base, -0.06 * base, 1.16 * base, 1.08 * base}, canvas.page(1), 16));
                for (auto& box : shapes.boxes) {
                  box.look.fill = palette::sequential(0.55 * load[box.body] / heaviest);
                  box.look.edge.width = 1;
                }
                pictures::draw(canvas, shapes);
                for (const Pressed& contact : contacts) {
                  const Point to = pose[contact.body2].position;
                  const Point from = contact.body1 == 0 ? Point(to.x(), 0) : Point(pose[contact.body1].position);
                  if (contact.force > 1e-3 * most)
                    canvas.line(from, to, {palette::force, 1 + 9 * contact.force / most});
                }
              });
  page.text(
      stands
          ? R"(Many distributions of the load keep every box at rest, and the sweeps end at one of them. Only the
               sum is fixed: the ground carries @ N, and the weight of all is @ N.)"
          : R"(Here the pyramid does not stand: its top box has moved by more than half a metre. The ground carries
               @ N, the weight of all is @ N.)",
      Value(ground, 5), Value(boxes * gravity, 5));
  page.figure("pyramid_overlap",
              say(R"(The largest overlap anywhere in the pyramid after the kick, with 2 and 8 coloured warm sweeps
                  and with as many conjugate ones as it takes (@ at most).)",
                  solver.loops.sweeps),
              overlaps(base, h));

  page.measure("largest overlap after 5 s", without_rounding(1000 * left, 1000 * slop), "mm");
  const Condition fine = Quantity("h", h, "s") <= 0.02;
  page.claim("what the ground carries", ground, "N", is(boxes * gravity, "the weight of all", relative(1e-3)),
             fine);
  page.claim("largest overlap after 5 s", left, "m", is_at_most(slop, "slop, above which it is pushed out"), fine);
  page.claim("the top box has moved", moved, "m", is_at_most(0.004, "4 mm: it stands"), fine);
  const double cold = falls_at(column(setting.boxes, GaussSeidel{.sweeps = sweeps, .warm_start = false}), 1, h);
  page.claim("time stood with ids lost", fell[1], "s", is(cold, "a cold start in every step", absolute(0.5 * h)),
             Quantity("time", fell[1], "s") < 1);
}

}  // namespace byhand::contact
