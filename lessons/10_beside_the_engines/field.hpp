#pragma once

#include "lessons/10_beside_the_engines/setting.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <numeric>

#include "lessons/engines/contest.hpp"

// Who takes part in a contest, with which settings, and the charts of its outcome.
namespace byhand::beside {

using engines::Contestant;
using engines::Engine;
using engines::frame;
using engines::Knobs;
constexpr double gravity = 9.81;       // [m/s²]
constexpr double margin = 1e-6;        // [m, rad]: errors below are not compared
constexpr double float_margin = 4e-6;  // the same of a chain in single precision [m]: a float of 50 m
constexpr double most_of_a_pendulum = 32, most_in_space = 512;  // iterations a frame that are tried, of joints
constexpr double most_of_contacts = engines::contact_iterations.back(),
                 most_of_a_wall_in_space = engines::contact_iterations.front();
/// Under node all engines share one process.
constexpr double most_of_joints_in_webassembly = 128, most_of_contacts_in_webassembly = most_of_contacts;
/// Frames in which a pile comes to its engine's own rest: 5 s, for soft contacts still sink after one.
constexpr int settling = 300;

/// The name under which the course's solver takes part.
inline const std::string& ours_name = engines::this_course().name;

/// The first two rows of each engine.
inline constexpr std::array row_names{"as shipped", "as advised"};

/// An engine with its settings: as shipped, as its manual advises, and all others that are tried.
template <class M>
struct Entrant {
  std::string name;
  bool single = false;  // precision
  std::vector<Contestant<M>> settings;
};

enum class Kind { joints, contacts };

/// Who meets: in this program, or in WebAssembly under node. A time of one is not compared with one of the other.
enum class Party { native, webassembly };

/// The course's solver and the engines that run a scene.
template <class M>
struct Field {
  Party party = Party::native;
  Kind kind = Kind::joints;
  double most_work = INFINITY;  // iterations a frame of the settings that are tried
  std::vector<Entrant<M>> entrants;
};

/// Whether engines of space take part in the plane.
enum class From { home, everywhere };

/// Who runs a scene of one kind. Settings of more than `most_work` iterations a frame are not tried.
template <class M>
Field<M> field_of(const Scene<M>& scene, Kind kind, From from = From::home, double most_work = INFINITY,
                  Party party = Party::native);

/// All who may take part somewhere, this course first.
std::vector<Engine> members(Party party);

/// One of them by its name, if there is one.
std::optional<Engine> engine_named(const std::string& name, Party party = Party::native);

/// How it solves, and how it was built where that matters.
std::string with_build(const Engine& engine);

/// Why an engine is left out of such a field; empty if it is not.
template <class M>
std::string why_not(const Engine& engine, const Scene<M>& scene, From from = From::home);

/// Of an error.
enum class Unit { metres, radians };

/// Who is left out of which scenes of a party, and why: engines of one reason share a row.
std::vector<std::vector<std::string>> left_out(const Setting& setting, Party party);
inline const std::vector<std::string> head_of_left_out{"left out", "of", "because"};

/// Of two changes the one that is farther from 0.
inline double farther(double a, double b) { return std::abs(b) <= std::abs(a) ? a : b; }

/// As far as errors are compared.
inline double told(double error, double least = margin) { return std::max(error, least); }

/// An error from several starts.
struct Spread {
  double least = INFINITY, most = INFINITY;

  void add(double error) {
    least = std::min(least, error);
    most = std::isfinite(error) ? std::max(most, error) : INFINITY;
  }
};

/// One number of each setting of an entrant, the less the better; infinite where it failed.
struct Errors {
  std::string name;
  bool single = false;  // precision
  std::vector<double> by_setting = {};
  std::map<std::size_t, Spread> spreads = {};  // of settings that were run from other starts, too

  Spread spread(std::size_t setting) const {
    const auto found = spreads.find(setting);
    return found == spreads.end() ? Spread{by_setting[setting], by_setting[setting]} : found->second;
  }
  double shipped() const { return by_setting[0]; }
  double advised() const { return by_setting[1]; }
  double best() const { return by_setting[best_setting()]; }
  /// Of those that were run from other starts, where any were.
  std::size_t best_setting() const {
    std::size_t best = 0;
    for (std::size_t i = 0; i < by_setting.size(); ++i)
      if ((spreads.empty() || spreads.contains(i)) && told(spread(i).most) < told(spread(best).most)) best = i;
    return best;
  }
};

/// The scene with each box up to 1 µm aside, in one of several ways.
template <class M>
Scene<M> nudged(Scene<M> scene, int way);
constexpr int ways = 4;

/// "1.2 mm", or "0.8 mm to 2 mm" by the start.
std::string in_words(const Spread& spread, Unit unit);

/// Runs settings from nearby(way) in all ways, too: both rows, and those of the least errors.
template <class M, class S, class F>
void add_spreads(const Field<M>& field, S&& nearby, std::vector<Errors>& all, F&& error_of) {
  constexpr std::size_t most_tried = 3;
  if (all.size() < 2) return;
  for (std::size_t i = 0; i < all.size(); ++i) {
    Errors& errors = all[i];
    std::vector<std::size_t> tried(errors.by_setting.size());
    std::iota(tried.begin(), tried.end(), 0);
    const auto by_error = [&](std::size_t j) { return errors.by_setting[j]; };
    std::ranges::stable_sort(tried.begin() + 2, tried.end(), {}, by_error);
    tried.resize(std::min(tried.size(), 2 + most_tried));
    for (const std::size_t j : tried) {
      Spread spread{errors.by_setting[j], errors.by_setting[j]};
      for (int way = 0; way < ways && std::isfinite(spread.most); ++way)
        spread.add(error_of(field.entrants[i].settings[j], nearby(way)));
      errors.spreads[j] = spread;
    }
  }
}

/// What has come of a scene with each setting of an entrant.
template <class Outcome>
struct Outcomes {
  std::string name;
  bool single = false;
  std::vector<Outcome> by_setting = {};
};

/// look(contestant) of every setting. The engines keep global variables, so that no two run at once.
template <class M, class F>
auto outcomes_of(const Field<M>& field, F&& look) {
  std::vector<Outcomes<decltype(look(field.entrants[0].settings[0]))>> all;
  for (const Entrant<M>& entrant : field.entrants) {
    all.push_back({entrant.name, entrant.single});
    for (const Contestant<M>& contestant : entrant.settings) all.back().by_setting.push_back(look(contestant));
  }
  return all;
}

/// A number of each outcome.
template <class Outcome, class F>
std::vector<Errors> errors_of(const std::vector<Outcomes<Outcome>>& all, F&& number) {
  std::vector<Errors> errors;
  for (const Outcomes<Outcome>& outcomes : all) {
    errors.push_back({outcomes.name, outcomes.single});
    for (const Outcome& outcome : outcomes.by_setting) {
      const double found = std::invoke(number, outcome);
      errors.back().by_setting.push_back(std::isfinite(found) ? found : INFINITY);
    }
  }
  return errors;
}

/// "1.2 mm", "< 1 µm", "failed"; "0.02 rad", "< 10⁻⁶ rad".
std::string in_words(double error, Unit unit);
inline std::string in_millimetres(double metres) { return in_words(metres, Unit::metres); }

/// "Bullet, MuJoCo and Chipmunk".
std::string listed(const std::vector<std::string>& names);

/// A row an engine: its three errors in words, and the setting of the best.
template <class M>
std::vector<std::vector<std::string>> three_rows(const Field<M>& field, const std::vector<Errors>& all, Unit unit);
inline const std::vector<std::string> head_of_three_rows{"", "as shipped", "as its manual advises",
                                                         "best of the settings tried", "setting"};

/// Adds these rows as a table, and below it who has less error than the course. Alone the course has no best of
/// its settings.
template <class M>
void tell_three(Page& page, const Field<M>& field, const std::vector<Errors>& all, Unit unit);

/// The same as a figure on a logarithmic axis; what is less than the margin is drawn there. None of the course
/// alone.
void compare(Page& page, const std::string& name, const std::string& caption, const std::vector<Errors>& all,
             const std::string& label);

/// The run that a chart times, of the scene and from the start whose error it shows.
template <class M>
struct Timed {
  Scene<M> scene;
  int frames;
  engines::Start<M> start = {};
  std::string when = {};  // with which the chart's title begins: "from one start, "
};

/// From the engine's own rest, with a kick of the top by `speed` [m/s].
template <class M>
engines::Start<M> kicked_at_rest(double speed) {
  return {settling, [=](Scene<M>& seen) {
            if (speed > 0) kick(seen, speed);
            return speed > 0;
          }};
}

/// Microseconds a frame against the error, one curve an entrant: of its settings those that no other of its own
/// beats in both. Its title names who is ahead of the course somewhere. `label` is the error's, without its unit.
template <class M>
Chart against_time(const Field<M>& field, const std::vector<Errors>& errors, const Timed<M>& timed,
                   const std::string& label, Unit unit = Unit::metres);

/// The figure of such a chart, whose caption goes on with what is drawn. None of the course alone, and none where
/// no setting survived.
void compare_by_time(Page& page, const std::string& name, const std::string& caption,
                     const std::vector<Errors>& errors, const std::function<Chart()>& chart);

/// Whether this build has no other engine: then there is nothing to compare.
inline bool alone() { return engines::all_engines().empty(); }

/// Who has less error than the course, by more than a hundredth and the margin: a verdict for each row; "" of the
/// course alone. `what` is compared.
template <class M>
std::string judged(Page& page, const Field<M>& field, const std::vector<Errors>& all, Unit unit,
                   const std::string& what = "error");

/// The last of these verdicts, on the errors of the best settings.
template <class M>
std::string judged_at_best(Page& page, const Field<M>& field, const std::vector<Errors>& all, Unit unit);

/// Passes over the rows that this course takes a frame as shipped, on the mean of so many frames from its rest on,
/// after a kick where `speed` [m/s] is above 0.
template <class M>
double passes_a_frame(const Scene<M>& scene, double speed, int frames);

/// The largest distance that a body has moved from one to the other [m], in its position.
template <class M>
double largest_displacement(const Scene<M>& from, const Scene<M>& to) {
  double most = 0;
  for (int i = 0; i < from.bodies().size(); ++i)
    most = larger(most, Linear<M>(to.bodies().pose[i].position - from.bodies().pose[i].position).norm());
  return most;
}

/// The overlap of shapes that is deepest [m].
template <class M>
double deepest_overlap(const Scene<M>& scene);

}  // namespace byhand::beside
