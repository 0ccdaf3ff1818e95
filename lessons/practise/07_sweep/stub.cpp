#include "practise.hpp"

void warm_start(std::span<Row> rows, Velocities& V) {
  not_written_yet();  // instead of this line, your code
}

void sweep(std::span<Row> rows, Velocities& V) {
  not_written_yet();  // instead of this line, your code
}
