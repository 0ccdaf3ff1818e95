// λ is lost: `for (Row row : rows)` changes copies; write Row& to change the rows themselves.
#include "practise.hpp"

void warm_start(std::span<Row> rows, Velocities& V) {
  for (const Row& row : rows) V += row.lambda * row.W;
}

void sweep(std::span<Row> rows, Velocities& V) {
  for (Row row : rows) {
    const double change = -(dot(row.J, V) + row.b) / row.K;
    row.lambda += change;
    V += change * row.W;
  }
}
