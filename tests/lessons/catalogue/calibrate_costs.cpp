// What a row-solve, a row that is written, a body that is moved … take in instructions, for cost.cpp. Two stages:
//
//   ninja -C build/release calibrate_costs && cd "$(mktemp -d)"
//   valgrind --tool=callgrind --callgrind-out-file=counts FOLDER/calibrate_costs run > efforts
//   (run_in_space for the weights of bodies that turn in space)
//   FOLDER/calibrate_costs fit efforts counts.*
//
// The first runs each method with many choices and has callgrind write how many instructions each run took. The
// second finds for each method the weights, none below zero, with the least relative error. A row-solve of
// Gauss–Seidel in the plane is the unit: `fit` in a folder of runs in space takes its instructions as a last
// argument "unit=…".

#include <fmt/format.h>
#include <valgrind/callgrind.h>

#include <fstream>
#include <iostream>
#include <map>
#include <sstream>

#include "lessons/catalogue/run.hpp"

namespace {

using namespace byhand;
using Counts = std::array<double, 6>;  // in the order of Weights

std::vector<Problem> in_plane() {
  return {Problem("chain", {{"links", 10}}, "bobs in the plane"), Problem("chain", {{"links", 10}}),
          Problem("chain", {{"links", 40}}), Problem("stack", {{"boxes", 5}}), Problem("pyramid", {{"base", 5}})};
}
std::vector<Problem> in_space() {
  return {Problem("chain", {{"links", 10}}, "balls in space"), Problem("chain", {{"links", 10}}, "links in space"),
          Problem("chain", {{"links", 40}}, "links in space"), Problem("top")};
}

void run(const std::vector<Problem>& problems) {
  for (const Problem& problem : problems)
    for (const Family& family : families())
      for (const int substeps : {1, 2, 6})
        for (const int passes : {1, 5, 20}) {
          if (passes > (family.pass.empty() ? 1 : family.pass == "digit" ? 5 : 20)) continue;
          Knobs knobs{.substeps = substeps, .passes = passes};
          if (family.name == "Jacobi") knobs.relaxation = 0.4;
          knobs.regularisation = 1e-6;
          const Setting setting =
              family.setting(with_cure(knobs, family.cures.size() > 1 ? Cure::baumgarte : family.cures[0]));
          AnyScene scene = problem.start();
          if (!scene.refusal(setting.method).empty()) continue;
          scene.use(setting.method);
          const auto frames = [&](int count) {
            for (int i = 0; i < count * setting.steps; ++i) scene.step(frame / setting.steps);
          };
          try {
            frames(5);
            const Effort before = scene.effort();
            CALLGRIND_ZERO_STATS;
            frames(10);
            CALLGRIND_DUMP_STATS;
            const Effort after = scene.effort();
            fmt::print("{};{};{};{};{};{};{}\n", family.name, after.row_solves - before.row_solves,
                       after.rows - before.rows, after.bodies - before.bodies, after.contacts - before.contacts,
                       after.substeps - before.substeps, after.steps - before.steps);
          } catch (const std::exception&) {
            CALLGRIND_DUMP_STATS;
            fmt::print("failed\n");
          }
        }
}

/// Weights without a negative one, each in turn the best while the others stay.
Counts fitted(const std::vector<std::pair<Counts, double>>& runs) {
  Counts weights{};
  for (int round = 0; round < 20000; ++round)
    for (std::size_t k = 0; k < weights.size(); ++k) {
      double product = 0, square = 0;
      for (const auto& [counts, instructions] : runs) {
        double rest = 1;
        for (std::size_t l = 0; l < weights.size(); ++l)
          if (l != k) rest -= weights[l] * counts[l] / instructions;
        product += rest * counts[k] / instructions;
        square += counts[k] * counts[k] / instructions / instructions;
      }
      weights[k] = square > 0 ? std::max(0.0, product / square) : 0;
    }
  return weights;
}

void fit(const char* efforts, int count, char** dumps, double unit) {
  std::map<std::string, std::vector<std::pair<Counts, double>>> by_family;
  std::ifstream lines(efforts);
  std::string line;
  for (int i = 0; i < count && std::getline(lines, line); ++i) {
    std::ifstream dump(dumps[i]);
    double instructions = 0;
    for (std::string word; dump >> word;)
      if (word == "totals:" || word == "summary:") dump >> instructions;
    std::istringstream fields(line);
    std::string name, field;
    std::getline(fields, name, ';');
    Counts counts{};
    for (double& number : counts)
      if (std::getline(fields, field, ';')) number = std::stod(field);
    if (counts[0] > 0) by_family[name].emplace_back(counts, instructions);
  }
  if (unit == 0) unit = fitted(by_family.at("Gauss–Seidel"))[0];
  fmt::print("instructions of a row-solve: {:.1f}\n", unit);
  for (const Family& family : families()) {
    const auto& runs = by_family[family.name];
    const Counts weights = fitted(runs);
    double worst = 0;
    for (const auto& [counts, instructions] : runs) {
      double sum = 0;
      for (std::size_t k = 0; k < counts.size(); ++k) sum += weights[k] * counts[k];
      worst = std::max(worst, std::abs(sum / instructions - 1));
    }
    fmt::print("      {{\"{}\", {{", family.name);
    for (std::size_t k = 0; k < weights.size(); ++k) fmt::print("{}{:.3g}", k ? ", " : "", weights[k] / unit);
    fmt::print("}}}},  // within {:.0f} %\n", 100 * worst);
  }
}

}  // namespace

int main(int argc, char** argv) {
  const std::string command = argc > 1 ? argv[1] : "", last = argv[argc - 1], unit = "unit=";
  const bool given = last.starts_with(unit);
  if (command == "fit" && argc > 3)
    fit(argv[2], argc - 3 - given, argv + 3, given ? std::stod(last.substr(unit.size())) : 0);
  else
    run(command == "run_in_space" ? in_space() : in_plane());
}
