#include "lessons/catalogue/cost.hpp"

namespace byhand {
namespace {

struct Part {
  RowKind kind;
  std::string_view name;
  Prices prices;
};

constexpr Part parts[] = {
#include "lessons/catalogue/prices.inc"
};

}  // namespace

Prices operator+(const Prices& a, const Prices& b) {
  return {a.row_solve + b.row_solve,
          a.laid_out_row + b.laid_out_row,
          a.solve + b.solve,
          a.pass + b.pass,
          a.prepared_row + b.prepared_row,
          a.projected_row + b.projected_row,
          a.written_row + b.written_row,
          a.body + b.body,
          a.contact + b.contact,
          a.substep + b.substep,
          a.step + b.step};
}

Prices prices_of(RowKind kind, std::string_view part) {
  for (const Part& one : parts)
    if (one.kind == kind && one.name == part) return one.prices;
  return {};
}

double cost_of(const Effort& effort, const Prices& prices) {
  const auto paid = [](long long count, double price) { return price * static_cast<double>(count); };
  const Executed& also = effort.executed;
  return paid(effort.row_solves, prices.row_solve) + paid(also.laid_out_rows, prices.laid_out_row) +
         paid(also.solves, prices.solve) + paid(also.passes, prices.pass) +
         paid(also.prepared_rows, prices.prepared_row) + paid(also.projected_rows, prices.projected_row) +
         paid(effort.written_rows, prices.written_row) + paid(effort.bodies, prices.body) +
         paid(effort.contacts, prices.contact) + paid(effort.substeps, prices.substep) +
         paid(effort.steps, prices.step);
}

}  // namespace byhand
