#pragma once

#include <memory>

#include "lessons/04_baumgarte/setting.hpp"

namespace byhand::baumgarte {

/// How a chain is solved.
struct Sweeping {
  int links;
  int sweeps;
  double beta;
  bool warm = true;
};

/// By what the errors along a straight chain without weight are multiplied in each step, in the long run: from the
/// mean logarithm of their size in `steps` steps to that in the next, after as many for faster waves to die out.
/// (Means, because errors ring.) On a straight chain the step is linear, so the scene is scaled back whenever it
/// has grown or shrunk much.
double measured_growth(const Sweeping& sweeping, double h, int steps);

/// The same from the theory: the largest |z| of z³ − [1 + 2q − (1 − q)β]z² + 3qz − q = 0 over all waves of the
/// chain, of which k sweeps leave q = cos²ᵏ((2j − 1)π/2N), or nothing. A cold start remembers less: z² − [1 + q −
/// (1 − q)β]z + q = 0.
double growth_law(const Sweeping& sweeping);

/// The same of one wave with a warm start: the largest |z| of that cubic.
double growth_of_wave(double q, double beta);

/// A chain hanging from an anchor under its weight; its lowest rod begins too long by the share `start_error`.
class HangingChain {
 public:
  static constexpr double start_error = 0.01;

  HangingChain(const Sweeping& sweeping, double length, double mass, double h);
  HangingChain(const HangingChain& other);
  HangingChain& operator=(const HangingChain& other);
  ~HangingChain();

  /// Steps, unless the chain has broken up: beyond that its numbers mean nothing.
  void step();
  /// Whether a rod is a hundred times as long as it should be.
  bool broken_up() const;
  double time() const;
  double largest_error() const;  // of |C| [m]
  pictures::Linkage linkage() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace byhand::baumgarte
