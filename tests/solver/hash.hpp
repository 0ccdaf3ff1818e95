#pragma once

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <bit>
#include <functional>

#include "solver/step.hpp"

// A run that is boiled down to one number.
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

template <class M, class Method>
std::uint64_t after(int seconds, const Scene<M>& scene, const Method& method) {
  Simulation simulation{scene, method};
  for (int i = 0; i < 60 * seconds; ++i) simulation.step(1.0 / 60);
  for (const auto& V : simulation.scene.bodies().velocity) EXPECT_TRUE(V.allFinite());
  return Hash(simulation.scene.bodies()).value();
}

template <class M, class Method = VelocityStepping>
std::uint64_t after_ten_seconds(const Scene<M>& scene, const Method& method) {
  return after(10, scene, method);
}

struct Case {
  const char* name;
  std::function<std::uint64_t()> hash;
  std::uint64_t expected;
};

inline void PrintTo(const Case& one, std::ostream* out) { *out << one.name; }

inline void expect_hash(const Case& one) {
  const std::uint64_t hash = one.hash();
  EXPECT_EQ(hash, one.expected) << fmt::format("if the arithmetic was meant to change, write {:#018x}", hash);
}

}  // namespace byhand
