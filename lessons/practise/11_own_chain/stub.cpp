#include "practise.hpp"

void simulate(const Setting& setting, std::span<Bob> bobs) {
  not_written_yet();  // instead of this line, your program
}
