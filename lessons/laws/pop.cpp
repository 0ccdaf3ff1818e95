#include "lessons/laws/pop.hpp"

#include <fmt/format.h>

#include "lessons/laws/closed_forms.hpp"
#include "lessons/laws/column.hpp"

// Law 2. An overlap d is left at v = βd/h in the first step. The row can push but not pull, so the body keeps that
// speed, and gravity takes gh of it in every further step: n steps lift it by nβd - gh² n(n - 1)/2. It leaves the
// ground if that is more than d for a whole number n of steps:
//
//   d > min over n > 1/β of gh² n(n - 1)/2(nβ - 1)
//
// With any n it would be least near n = 2/β: at most (1 - β/2) 2gh²/β², and that where 2/β is whole; at β = 0.9
// it is 8 % less.
//
// A cap on the speed lowers the jump; a split impulse has none.
namespace byhand::laws {

Law pop() {
  Law law{
      2,
      Family::overshooting_correction,
      "contact pop",
      "a contact that is corrected through its velocity keeps that velocity: a deep overlap throws the body up",
      "d < min over whole n > 1/β of gh² n(n − 1)/(2(nβ − 1)), at most (1 − β/2) 2gh²/β²",
      {}};
  for (const auto& [beta, rate] : {std::pair{0.05, 60},
                                   {0.1, 60},
                                   {0.1, 120},
                                   {0.2, 60},
                                   {0.2, 240},
                                   {0.3, 60},
                                   {0.4, 60},
                                   {0.6, 60},
                                   {0.9, 60}}) {
    const Column column{.boxes = 1, .beta = beta, .step = 1.0 / rate};
    law.boundaries.push_back(bisected({"overlap",
                                       "m",
                                       fmt::format("β {}, {} Hz", beta, rate),
                                       popping_overlap(beta, column.step),
                                       0.02,
                                       {},
                                       [=](double overlap) { return !pops(column, overlap); }}));
  }
  return law;
}

}  // namespace byhand::laws
