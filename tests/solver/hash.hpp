#pragma once

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <bit>
#include <functional>

#include "solver/direct/equations.hpp"
#include "solver/step.hpp"

// A run that is boiled down to one number, and the work that is counted in it.
namespace byhand {

/// FNV-1a, 64 bits, over the bytes of every pose and velocity.
class Hash {
 public:
  template <class M>
  explicit Hash(const Bodies<M>& bodies) {
    for (int i = 0; i < bodies.size(); ++i) {
      add(bodies.pose[i].position.data(), M::linear);
      if constexpr (M::angular == 1) {
        add(&bodies.pose[i].rotation.cos, 1);
        add(&bodies.pose[i].rotation.sin, 1);
      }
      if constexpr (M::angular == 3) add(bodies.pose[i].rotation.coeffs().data(), 4);
      add(bodies.velocity[i].data(), M::dof);
    }
  }
  std::uint64_t value() const { return value_; }

 private:
  void add(const double* numbers, int count) {
    for (int i = 0; i < count; ++i)
      for (std::uint64_t bits = std::bit_cast<std::uint64_t>(numbers[i]), byte = 0; byte < 8; ++byte)
        value_ = (value_ ^ ((bits >> (8 * byte)) & 0xff)) * 0x100000001b3;
  }
  std::uint64_t value_ = 0xcbf29ce484222325;
};

/// Where a run ends, in a number of all its bits, and what its steps have counted.
struct End {
  std::uint64_t hash;
  std::string work;
};

/// "20 rows laid out, 600 solves, 24000 passes, 12000 rows prepared, 480000 row solves".
template <class M, class Work>
std::string counted(const Work& work) {
  const Executed& done = work.executed;
  std::string words;
  const auto add = [&](long long count, const char* what) {
    if (count != 0) words += fmt::format("{}{} {}", words.empty() ? "" : ", ", count, what);
  };
  add(done.laid_out_rows, "rows laid out");
  add(done.solves, "solves");
  add(done.passes, "passes");
  add(done.prepared_rows, "rows prepared");
  add(done.projected_rows, "projected");
  add(work.row_solves, "row solves");
  if constexpr (requires { std::any_cast<DirectWork<M>>(&work.solver); })
    if (const auto* direct = std::any_cast<DirectWork<M>>(&work.solver))
      add(direct->planned, "numbers read in plans");
  return words;
}

template <class M, class Method>
End after(int seconds, const Scene<M>& scene, const Method& method) {
  Simulation simulation{scene, method};
  for (int i = 0; i < 60 * seconds; ++i) simulation.step(1.0 / 60);
  for (const auto& V : simulation.scene.bodies().velocity) EXPECT_TRUE(V.allFinite());
  return {Hash(simulation.scene.bodies()).value(), counted<M>(simulation.work)};
}

template <class M, class Method = VelocityStepping>
End after_ten_seconds(const Scene<M>& scene, const Method& method) {
  return after(10, scene, method);
}

struct Case {
  const char* name;
  std::function<End()> run;
  End expected;
};

inline void PrintTo(const Case& one, std::ostream* out) { *out << one.name; }

inline void expect_end(const Case& one) {
  const End end = one.run();
  EXPECT_EQ(end.hash, one.expected.hash)
      << fmt::format("if the arithmetic was meant to change, write {:#018x}", end.hash);
  EXPECT_EQ(end.work, one.expected.work);
}

}  // namespace byhand
