// You remember λ and do not apply it: it is counted, but no body gets it.
#include "practise.hpp"

void warm_start(std::span<Row> rows, Velocities& V) { (void)rows, (void)V; }

void sweep(std::span<Row> rows, Velocities& V) {
  for (Row& row : rows) {
    const double change = -(dot(row.J, V) + row.b) / row.K;
    row.lambda += change;
    V += change * row.W;
  }
}
