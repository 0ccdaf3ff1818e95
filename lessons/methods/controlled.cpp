#include "lessons/methods/controlled.hpp"

#include <algorithm>

#include "lessons/methods/displacement.hpp"
#include "solver/support/each_model.hpp"

namespace byhand {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

// Of each method: its order, what it refuses before the scene has been laid out, how a step begins, a substep,
// which returns its error [m], and the way back from it.

constexpr int order_of(const Rattle&) { return 2; }
constexpr int order_of(const Generalised&) { return 4; }

template <class M>
std::string refusal_at_once(const Scene<M>& scene, const Rattle&) {
  return refusal(scene, Controlled<Rattle>());
}
template <class M>
std::string refusal_at_once(const Scene<M>& scene, const Generalised&) {
  return refusal_unless_equalities(scene, Generalised::name);
}

template <class M>
void begin_substeps(Scene<M>& scene, const Rattle& method, double step, Rattle::Work<M>& work) {
  begin_equalities(scene, step, work);
  meet_constraints(scene, method.regularisation, work);
}
template <class M>
double try_substep(Scene<M>& scene, const Rattle& method, double, double h, bool, Rattle::Work<M>& work) {
  work.begin = scene.bodies();
  work.h = h;
  std::fill(work.system.lambda.begin(), work.system.lambda.end(), 0.0);
  try {
    rattle(scene, method.regularisation, work);
  } catch (const NoConvergence&) {
    return infinite;
  } catch (const NotFinite&) {
    return infinite;
  }
  const Bodies<M>&from = work.begin, &to = scene.bodies();
  double error = 0;
  for (int i = 0; i < to.size(); ++i) {
    if (!moves(to.inverse_mass[i])) continue;
    const Velocity<M> mean = (from.velocity[i] + to.velocity[i]) / 2;
    const double own = displacement<M>(to.inverse_mass[i], moved<M, double>(from.pose[i], mean, h), to.pose[i]);
    if (!(own <= error)) error = own;
  }
  return error;
}
template <class M>
void take_back(Scene<M>& scene, const Rattle& method, Rattle::Work<M>& work) {
  scene.state().pose = work.begin.pose;
  scene.state().velocity = work.begin.velocity;
  factor_rows(scene, method.regularisation, work);
}

template <class M>
void begin_substeps(Scene<M>& scene, const Generalised&, double, Generalised::Work<M>& work) {
  read_joints(scene, work);
}
template <class M>
double try_substep(Scene<M>& scene, const Generalised&, double time, double h, bool again,
                   Generalised::Work<M>& work) {
  return fehlberg(scene, time, h, again, work);
}
template <class M>
void take_back(Scene<M>&, const Generalised&, Generalised::Work<M>& work) {
  work.state = work.begin;
}

double cube(double x) { return x * x * x; }

/// The n-th root, n a power of two: by square roots, as libm's powers differ between processors.
double root(double x, int n) {
  for (; n > 1; n /= 2) x = std::sqrt(x);
  return x;
}

}  // namespace

template <class M, class Method>
void advance(Scene<M>& scene, const Controlled<Method>& method, double step,
             typename Controlled<Method>::template Work<M>& work) {
  require_positive("time step", step, "s");
  for (const double g : scene.gravity) require_finite("gravity", g, "m/s²");
  require_valid(method);
  constexpr Method rule;
  if (const std::string reason = refusal_at_once(scene, rule); !reason.empty())
    throw std::invalid_argument(reason);
  constexpr int order = order_of(rule);
  Attempt attempt(scene, work);
  begin_substeps(scene, rule, step, work);
  if (work.next == 0) work.next = step / 10;
  bool again = false;
  work.tried = work.rejected = 0;
  for (double time = 0; time < step;) {
    const double left = step - time, parts = std::ceil(left / work.next), h = left / parts;
    if (work.tried++ == method.most_substeps || parts > 1e12)
      throw NoConvergence("a tolerance of " + text_of(method.tolerance) + " m/s cannot be kept with " +
                          std::to_string(method.most_substeps) + " substeps in a step of " + text_of(step) +
                          " s; allow a larger error or more substeps");
    const double error = try_substep(scene, rule, time, h, again, work);
    const double room = std::min(method.tolerance * h / error, 1e6);
    again = !(room >= 1);
    if (again)
      take_back(scene, rule, work);
    else
      time = parts == 1 ? step : time + h;
    work.rejected += again;
    const double factor =
        again || work.room == 0 ? root(room, order) : root(cube(room * room / work.room), 8 * order);
    work.next = h * (room > 0 ? std::clamp(0.9 * factor, 0.2, 5.0) : 0.2);
    work.room = again ? 0 : room;
  }
  attempt.finish();
}

#define BYHAND_INSTANTIATE(M)                                                                                 \
  template void advance(Scene<M>&, const Controlled<Rattle>&, double, Controlled<Rattle>::template Work<M>&); \
  template void advance(Scene<M>&, const Controlled<Generalised>&, double,                                    \
                        Controlled<Generalised>::template Work<M>&)
BYHAND_FOR_EACH_MODEL(BYHAND_INSTANTIATE);
#undef BYHAND_INSTANTIATE

}  // namespace byhand
