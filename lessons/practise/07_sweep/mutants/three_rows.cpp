// Your loop ends at 3: a sweep has rows.size() rows.
#include "practise.hpp"

void warm_start(std::span<Row> rows, Velocities& V) {
  for (std::size_t i = 0; i < 3 && i < rows.size(); ++i) V += rows[i].lambda * rows[i].W;
}

void sweep(std::span<Row> rows, Velocities& V) {
  for (std::size_t i = 0; i < 3 && i < rows.size(); ++i) {
    Row& row = rows[i];
    const double change = -(dot(row.J, V) + row.b) / row.K;
    row.lambda += change;
    V += change * row.W;
  }
}
