#include "lessons/exact/certified_integration.hpp"

#include <algorithm>
#include <boost/numeric/odeint/integrate/integrate_adaptive.hpp>
#include <boost/numeric/odeint/stepper/bulirsch_stoer.hpp>
#include <boost/numeric/odeint/stepper/controlled_runge_kutta.hpp>
#include <boost/numeric/odeint/stepper/generation.hpp>
#include <boost/numeric/odeint/stepper/runge_kutta_fehlberg78.hpp>
#include <cmath>
#include <limits>

#include "solver/support/require.hpp"

namespace byhand {
namespace odeint = boost::numeric::odeint;

Certified certified_integration(const Rate& rate, const std::vector<double>& start, double time,
                                double tolerance) {
  require(std::isfinite(time) && time >= 0, "time", time, "a finite number >= 0 [s]");
  require_positive("tolerance", tolerance);
  for (const double number : start) require_finite("a number of the first state", number);

  const auto system = [&](const ExtendedState& x, ExtendedState& dxdt, long double) { rate(x, dxdt); };
  const auto end = [&](auto stepper) {
    ExtendedState x(start.begin(), start.end());
    odeint::integrate_adaptive(stepper, system, x, 0.0L, static_cast<long double>(time), 1e-3L);
    return x;
  };
  const long double allowed = tolerance;
  using Fehlberg = odeint::runge_kutta_fehlberg78<ExtendedState, long double, ExtendedState, long double>;
  using Extrapolation = odeint::bulirsch_stoer<ExtendedState, long double, ExtendedState, long double>;
  const ExtendedState first = end(odeint::make_controlled<Fehlberg>(allowed, allowed));
  const ExtendedState second = end(Extrapolation(allowed, allowed));

  Certified result{{first.begin(), first.end()}, 0};
  for (std::size_t i = 0; i < first.size(); ++i) {
    const long double rounding = std::numeric_limits<double>::epsilon() * std::abs(first[i]);
    result.uncertainty =
        std::max(result.uncertainty, static_cast<double>(2 * std::abs(first[i] - second[i]) + rounding));
  }
  return result;
}

std::vector<std::vector<double>> integrated_path(const Rate& rate, const std::vector<double>& start, double end,
                                                 int parts) {
  std::vector<std::vector<double>> path{start};
  for (int i = 0; i < parts; ++i) path.push_back(certified_integration(rate, path.back(), end / parts).state);
  return path;
}

}  // namespace byhand
