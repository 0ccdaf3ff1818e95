#include "lessons/catalogue/tuning.hpp"

#include <algorithm>
#include <cmath>
#include <set>

#include "lessons/catalogue/limits.hpp"

namespace byhand {
namespace {

constexpr int most_substeps = 8192, most_passes = 8192;

/// Relaxation as a number that can be doubled: 1/(2 - ω) above 1, ω below.
double stepped(double relaxation, double factor) {
  if (relaxation > 1 || (relaxation == 1 && factor > 1)) {
    const double steps = factor / (2 - relaxation);
    return steps <= 1 ? 1 : 2 - 1 / steps;
  }
  return std::min(1.0, relaxation * factor);
}

/// The points of a front that gain at least 5 % on each other and lie a factor √2 in cost apart.
std::vector<Point> thinned(const std::vector<Point>& front, Error error) {
  std::vector<Point> kept;
  for (auto point = front.rbegin(); point != front.rend(); ++point) {  // from the cheapest
    if (!kept.empty() && (*point)[error] > 0.95 * kept.back()[error]) continue;
    if (kept.size() > 1 && point->cost < std::sqrt(2.0) * kept[kept.size() - 2].cost)
      kept.back() = *point;
    else
      kept.push_back(*point);
  }
  return kept;
}

/// Two digits, as a person would set it.
double rounded(double value) {
  if (!(value > 0)) return value;
  const double scale = std::pow(10, 1 - std::floor(std::log10(value)));
  return std::round(value * scale) / scale;
}

}  // namespace

const Point& Runs::at(const Knobs& knobs) {
  const Knobs allowed = within_laws(problem_, *family_, knobs);
  const auto [place, fresh] = known_.try_emplace(allowed);
  if (!fresh) return place->second;
  if (earlier_)
    if (const auto run = earlier_->find(allowed);
        run != earlier_->end() && (run->second.outcome != Outcome::too_slow || run->second.cost > watch_.most))
      return place->second = run->second;
  place->second = measure(problem_, *family_, allowed, watch_);
  ++made_;
  work_ += work_of(place->second);
  if (earlier_) (*earlier_)[allowed] = place->second;
  return place->second;
}

std::vector<Point> Runs::points() const {
  std::vector<Point> all;
  for (const auto& [knobs, point] : known_) all.push_back(point);
  return all;
}

Knobs within_laws(const Problem& problem, const Family& family, Knobs knobs) {
  knobs.substeps = std::clamp(knobs.substeps, 1, most_substeps);
  knobs.passes = family.pass.empty() ? 1 : std::clamp(knobs.passes, 1, family.pass == "digit" ? 12 : most_passes);
  knobs.relaxation = rounded(std::clamp(knobs.relaxation, family.least_relaxation, family.most_relaxation));
  switch (knobs.cure) {
    case Cure::none: knobs.strength = 0; break;
    case Cure::baumgarte: {
      const bool swept = family.name == "Gauss–Seidel";
      const double most = family.name == "AVBD" ? 1
                          : !swept              ? 1.9
                                                : largest_beta(problem, knobs.passes, knobs.relaxation);
      // Less is no cure; that is a choice of its own.
      knobs.strength = std::min(rounded(std::max(knobs.strength, 0.01)), 0.95 * most);
      break;
    }
    case Cure::split_impulse: knobs.strength = rounded(std::clamp(knobs.strength, 0.01, 1.9)); break;
    case Cure::soft: knobs.strength = rounded(std::clamp(knobs.strength, 1e-4, 1e4)); break;
    case Cure::projection: knobs.strength = std::clamp(std::round(knobs.strength), 1.0, 256.0); break;
  }
  return knobs;
}

Knobs first_knobs(const Problem& problem, const Family& family, Cure cure, int passes) {
  const LawLimit limit = limit_of(problem);
  Knobs knobs{.substeps = limit.substeps, .passes = family.pass.empty() ? 1 : passes};
  // Law 18: n substeps are worth n² sweeps.
  if (family.solves_rows && !family.exact && family.name == "Gauss–Seidel")
    knobs.substeps = std::max(knobs.substeps,
                              static_cast<int>(std::ceil(std::sqrt(static_cast<double>(limit.sweeps) / passes))));
  if (family.name == "Jacobi") knobs.relaxation = 0.5;
  if (family.name == "AVBD") return knobs = with_cure(knobs, Cure::baumgarte), knobs.strength = 0.05, knobs;
  return within_laws(problem, family, with_cure(knobs, cure));
}

std::vector<Knobs> neighbours(const Problem& problem, const Family& family, const Knobs& knobs) {
  std::vector<Knobs> all;
  const auto add = [&](auto&& change) {
    Knobs next = knobs;
    change(next);
    next = within_laws(problem, family, next);
    if (next != knobs && std::find(all.begin(), all.end(), next) == all.end()) all.push_back(next);
  };
  for (const double factor : {2.0, 0.5}) {
    add([&](Knobs& k) { k.substeps = static_cast<int>(std::lround(factor * k.substeps)); });
    if (family.pass == "digit")
      add([&](Knobs& k) { k.passes += factor > 1 ? 1 : -1; });
    else
      add([&](Knobs& k) { k.passes = static_cast<int>(std::lround(factor * k.passes)); });
    add([&](Knobs& k) { k.strength *= k.cure == Cure::projection ? factor : std::sqrt(factor); });
    add([&](Knobs& k) { k.strength *= factor * factor; });
    add([&](Knobs& k) { k.relaxation = stepped(k.relaxation, factor > 1 ? 1.3 : 1 / 1.3); });
  }
  if (family.exact)  // a step of which costs much
    for (const double factor : {1.25, 0.8})
      add([&](Knobs& k) {
        k.substeps =
            static_cast<int>(factor > 1 ? std::ceil(factor * k.substeps) : std::floor(factor * k.substeps));
      });
  for (const Cure cure : family.cures)
    if (cure != knobs.cure) add([&](Knobs& k) { k = with_cure(k, cure); });
  return all;
}

void explore(Runs& runs, std::span<const Error> watched, int most) {
  const Problem& problem = runs.problem();
  const Family& family = runs.family();
  for (const int passes : {1, 8})
    for (const Cure cure : family.cures) {
      Knobs knobs = first_knobs(problem, family, cure, passes);
      for (const int more : {1, 2, 4})  // times the substeps before: 1, 2 and 8 times the law's
        if (const Point& point = runs.at((knobs.substeps *= more, knobs)); point.outcome == Outcome::refused) {
          if (family.pass.empty() && family.exact && family.solves_rows && knobs.regularisation == 0) break;
          return;
        }
    }
  if (family.name == "direct" && pareto_front(runs.points(), watched.front()).empty())
    for (const Cure cure : family.cures)  // rows that repeat each other
      for (const int substeps : {1, 4}) {
        Knobs knobs = first_knobs(problem, family, cure, 1);
        knobs.substeps *= substeps;
        knobs.regularisation = 1e-9;
        runs.at(knobs);
      }
  std::set<Knobs> expanded;
  for (bool gains = true; gains && runs.count() < most;) {
    gains = false;
    for (const Error error : watched)
      for (const Point& point : thinned(pareto_front(runs.points(), error), error)) {
        if (runs.count() >= most || !expanded.insert(point.knobs).second) continue;
        gains = true;
        for (const Knobs& next : neighbours(problem, family, point.knobs)) runs.at(next);
      }
  }
}

}  // namespace byhand
