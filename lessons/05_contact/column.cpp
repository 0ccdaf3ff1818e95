#include "lessons/05_contact/column.hpp"

namespace byhand::contact {

std::vector<Pressed> pressed(const Pile& pile, double h) {
  std::vector<Pressed> all;
  const System<PlaneBody>& system = pile.work.system;
  for (int place = 0; place < pile.scene.count(); ++place) {
    const auto& entry = pile.scene.entries()[place];
    const int row = system.row_of[place];
    all.push_back({entry.body1, entry.body2, (system.lambda[row] + system.lambda[row + 1]) / h});
  }
  return all;
}

std::vector<double> layer_forces(const Pile& stack, double h) {
  std::vector<double> forces(static_cast<std::size_t>(stack.scene.bodies().size() - 1), 0.0);
  for (const Pressed& contact : pressed(stack, h)) forces[contact.body2 - 1] += contact.force;
  return forces;
}

Pile column(int boxes, const RowSolver& solver, double kick_speed, double top_mass) {
  Pile pile{stack(boxes, top_mass), {solver, left_alone}};
  kick(pile.scene, kick_speed);
  return pile;
}

bool has_fallen(const Pile& stack) {
  const auto& pose = stack.scene.bodies().pose;
  return !(pose.back().position.y() > static_cast<double>(pose.size()) - 2);
}

double falls_at(Pile stack, double time, double h) {
  while (stack.time < time - 0.5 * h) {
    stack.step(h);
    if (has_fallen(stack)) return stack.time;
  }
  return std::numeric_limits<double>::infinity();
}

double shift(const Pile& stack) { return std::abs(stack.scene.bodies().pose.back().position.x()); }

}  // namespace byhand::contact
