// Deeper: a pyramid, whose contacts make loops.

#include <algorithm>
#include <cmath>

#include "lessons/05_contact/column.hpp"
#include "lessons/05_contact/steps.hpp"
#include "lessons/pictures/boxes.hpp"

namespace byhand::contact {
namespace {

using namespace tutor;
using namespace renderer;

constexpr double wall_seconds = 5, slop = 0.001;  // [s], [m]

Pile wall(int base, const RowSolver& solver) {
  Pile pile{pyramid(base), {solver, Baumgarte{.slop = slop}}};
  kick(pile.scene, 0.02);
  return pile;
}

GaussSeidel coloured(int sweeps) { return {.sweeps = sweeps, .order = SweepOrder::coloured}; }

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
      curve.y.push_back(std::max(1e-3, 1000 * position_error(pile.scene).max));
    }
    chart.curves.push_back(std::move(curve));
  }
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

  page.text(
      R"(In a pyramid every box rests on two others: contacts make loops, and a direct solve would have to be paid
      for them. Here sweeps are at home. The weight comes down over @ rows and not over @ boxes, loads may change
      places between neighbours, and a base as broad as this does not creep. Rows are taken colour by colour, in
      groups that share no box. Between sweeps λ goes on in the direction in which the sweeps before have led it:
      conjugate sweeps, which reach a wall's slow modes as the square of their number. A sweep that changes no
      impulse by more than @ of the largest is the last of its step. That is little, and it is cheap: a wall that is
      left rocking rocks for ever and wants more sweeps than one at rest.)",
      base, boxes, solver.loops.tolerance);
  const std::vector<Pressed> contacts = pressed(pile, h);
  double most = 0, ground = 0;
  for (const Pressed& contact : contacts) {
    most = std::max(most, contact.force);
    if (contact.body1 == 0) ground += contact.force;
  }
  page.figure("pyramid",
              say(R"(@ boxes of 1 kg, @ s after a kick. Darker: carried by more; the darkest contact presses with @
                  N. Lines: what presses on what, as thick as the force.)",
                  boxes, wall_seconds, Value(most, 3)),
              [shapes = pictures::shapes_of(pile.scene), pose = pile.scene.bodies().pose, contacts, most,
               base](Canvas& canvas) mutable {
                std::vector<double> load(pose.size(), 0.0);
                for (const Pressed& contact : contacts) load[contact.body2] += contact.force;
                const double heaviest = *std::max_element(load.begin(), load.end());
                canvas.look(fit({-0.58 * base, -0.06 * base, 1.16 * base, 1.08 * base}, canvas.page(), 16));
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
      R"(There are many ways to hand the load down that all keep every box at rest, and the sweeps end at one of
      them. Only the sum is sure: the ground carries @ N, the weight of all.)",
      Value(ground, 5));
  page.figure("pyramid_overlap",
              say(R"(The largest overlap anywhere in the pyramid after the kick, with 2 and 8 coloured warm sweeps
                  and with as many conjugate ones as it takes (@ at most). Slop: @ mm.)",
                  solver.loops.sweeps, 1000 * slop),
              overlaps(base, h));

  page.measure("largest overlap after 5 s", 1000 * position_error(pile.scene).max, "mm");
  page.claim({.quantity = "what the ground carries",
              .unit = "N",
              .expected = boxes * gravity,
              .source = "the weight of all",
              .measured = ground,
              .tolerance = relative(1e-3)});
  page.claim({.quantity = "largest overlap after 5 s",
              .unit = "m",
              .expected = slop,
              .source = "slop, above which it is pushed out",
              .measured = position_error(pile.scene).max,
              .tolerance = at_most()});
  page.claim({.quantity = "the top box has moved",
              .unit = "m",
              .expected = 0.004,
              .source = "4 mm: it stands",
              .measured = (pile.scene.bodies().pose.back().position - top).norm(),
              .tolerance = at_most(),
              .claimed = h <= 0.02,
              .range = "h ≤ 0.02 s"});
}

}  // namespace byhand::contact
