#pragma once

#include <memory>

#include "lessons/pictures/rods_and_bobs.hpp"

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

/// What k sweeps leave of the slowest wave, q = cos²ᵏ(π/2N).
double slow_wave(int links, int sweeps);
/// The largest β at which that wave dies out with a warm start, (1 − q)/q.
double limit_of_beta(int links, int sweeps);

/// A chain hanging from an anchor under its weight.
class HangingChain {
 public:
  HangingChain(const Sweeping& sweeping, double length, double mass, double h);
  HangingChain(const HangingChain& other);
  HangingChain& operator=(const HangingChain& other);
  ~HangingChain();

  void step();
  double time() const;
  double largest_error() const;  // of |C| [m]
  pictures::Linkage linkage() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace byhand::baumgarte
