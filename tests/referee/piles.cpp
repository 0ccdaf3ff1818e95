#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <map>
#include <nlohmann/json.hpp>

#include "lessons/methods/row_solvers.hpp"
#include "lessons/scenes/box_pile.hpp"
#include "solver/byhand.hpp"

// Writes random piles as friction problems, with the answers of the row solvers, one pile a line of JSON. What the
// numbers mean stands in tests/referee/judge, which reads them.
namespace byhand {
namespace {

constexpr double step = 1.0 / 60;  // [s]

struct Contestant {
  const char* name;
  AnyRowSolver solver;
};

/// Each with a tolerance of 1e-10 and as many sweeps as it takes.
const std::vector<Contestant>& contestants() {
  static const std::vector<Contestant> all = {
      {"sweeps", GaussSeidel{.sweeps = 200000, .order = SweepOrder::natural, .tolerance = 1e-10}},
      {"conjugate sweeps", ConjugateSweeps{.sweeps = 100000, .order = SweepOrder::natural, .tolerance = 1e-10}},
      {"Newton", SemismoothNewton{.rounds = 1000, .tolerance = 1e-10}},
      {"accelerated gradient", AcceleratedGradient{.iterations = 200000, .tolerance = 1e-10}},
  };
  return all;
}

/// A pile that has fallen for some steps.
template <class M>
Scene<M> pile(std::uint64_t seed) {
  std::mt19937_64 bits(seed);
  const auto any = [&](int low, int high) { return low + static_cast<int>(bits() % (high - low + 1)); };
  PileOptions options{.count = any(2, 60), .speed = 0.5 * any(0, 8), .decades = any(0, 2)};
  options.surface = {.friction = 0.1 * any(1, 10), .restitution = 0};
  Scene<M> scene = box_pile<M>(seed, options);
  scene.set_contact_rows(ContactRows::points);
  Simulation<M> simulation{std::move(scene), VelocityStepping{ConjugateSweeps{}, Baumgarte{.slop = 0.001}}};
  for (int i = any(0, 90); i > 0; --i) simulation.step(step);
  return std::move(simulation.scene);
}

/// A number for each row, written by `of(block, k)`.
template <class M, class F>
std::vector<double> by_row(const System<M>& system, F&& of) {
  std::vector<double> all(system.rows());
  system.for_each_run([&]<int K, Bound B>(std::span<const Block<M, K, B>> blocks) {
    for (const auto& block : blocks)
      for (int k = 0; k < K; ++k) all[block.row + k] = of(block, k);
  });
  return all;
}

template <class M>
void write_pile(std::uint64_t seed) {
  const Scene<M> scene = pile<M>(seed);
  nlohmann::json line{{"seed", seed}, {"dof", M::dof}};
  for (const Contestant& contestant : contestants()) {
    AnyStepping method{contestant.solver, Baumgarte{.slop = 0.001}};
    method.gyroscopic = Gyroscopic::none;
    Simulation<M, AnyStepping> simulation{scene, method};
    simulation.step(step);
    const System<M>& system = simulation.work.system;
    if (!line.contains("rows")) {
      auto& rows = line["rows"] = nlohmann::json::array();
      system.for_each_run([&]<int K, Bound B>(std::span<const Block<M, K, B>> blocks) {
        for (const auto& block : blocks)
          for (int k = 0; k < K; ++k) {
            std::vector<double> J, W;
            for (int i = 0; i < 2 * M::dof; ++i)
              J.push_back(block.J.matrix(k, i)), W.push_back(block.W.matrix(k, i));
            const int normal = B == Bound::friction ? block.normal_row : -1;
            rows.push_back({{"row", block.row + k},
                            {"bodies", {block.body1, block.body2}},
                            {"J", J},
                            {"W", W},
                            {"bias", system.bias[block.row + k]},
                            {"normal", normal},
                            {"mu", normal < 0 ? 0.0 : system.upper[block.row]}});
          }
      });
      auto& free = line["free"] = nlohmann::json::array();
      for (int body = 0; body < scene.bodies().size(); ++body) {
        Velocity<M> V = scene.bodies().velocity[body];
        if (moves(scene.bodies().inverse_mass[body])) V.template head<M::linear>() += step * scene.gravity;
        for (const double v : V) free.push_back(v);
      }
    }
    std::vector<double> velocity;
    for (const auto& V : simulation.scene.bodies().velocity) velocity.insert(velocity.end(), V.begin(), V.end());
    line["answers"][contestant.name] = {{"lambda", system.lambda},
                                        {"velocity", velocity},
                                        {"passes", simulation.work.solution.passes},
                                        {"converged", simulation.work.solution.converged}};
  }
  std::puts(line.dump().c_str());
}

}  // namespace
}  // namespace byhand

int main(int argc, char** argv) {
  if (argc != 3) return std::fputs("piles FIRST COUNT: writes piles FIRST to FIRST + COUNT - 1\n", stderr), 2;
  const auto first = std::strtoull(argv[1], nullptr, 10), count = std::strtoull(argv[2], nullptr, 10);
  for (auto seed = first; seed < first + count; ++seed)
    seed % 2 == 0 ? byhand::write_pile<byhand::PlaneBody>(seed) : byhand::write_pile<byhand::SpaceBody>(seed);
}
