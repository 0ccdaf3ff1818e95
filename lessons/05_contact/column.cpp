#include "lessons/05_contact/column.hpp"

namespace byhand::contact {

std::vector<Pressed> pressed(const Pile& pile, double h) {
  std::vector<Pressed> all;
  for (const ContactPair<PlaneBody>& pair : pile.work.contacts.pairs()) {
    const double impulse = pair.points[0].normal_impulse + pair.points[1].normal_impulse;
    all.push_back({pair.bodies.first, pair.bodies.second, impulse / h});
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

std::string fate(double fell) {
  return std::isinf(fell) ? say("still stands after @ s", patience) : say("is down after @ s", Value(fell, 2));
}

Condition has_fate(const std::string& solved, double fell) {
  const Quantity time("time stood, " + solved, std::min(fell, patience), "s");
  return std::isinf(fell) ? time >= patience : time < patience;
}

double shift(const Pile& stack) { return std::abs(stack.scene.bodies().pose.back().position.x()); }

}  // namespace byhand::contact
