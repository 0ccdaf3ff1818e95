#pragma once

#include "lessons/10_beside_the_engines/setting.hpp"

#include "lessons/engines/contest.hpp"

// Who takes part in a contest, with which settings, and the charts of its outcome.
namespace byhand::beside {

using engines::Contestant;
using engines::Engine;
using engines::frame;
using engines::Knobs;
constexpr double gravity = 9.81;  // [m/s²]
constexpr double margin = 1e-6;   // [m, rad]: the comparison ends there; a float of 50 m knows no less
constexpr int settling = 60;      // frames in which a pile comes to its engine's own rest

/// The name under which the course's solver takes part.
inline const std::string& ours_name = engines::this_course().name;

/// An engine with its settings: as shipped, as its manual advises, and all others that are tried.
template <class M>
struct Entrant {
  std::string name;
  std::vector<Contestant<M>> settings;
};

/// Who meets: in this program, or in WebAssembly under node. A time of one is not compared with one of the other.
enum class Party { native, webassembly };

/// The course's solver and the engines that run a scene, and why the others do not.
template <class M>
struct Field {
  Party party = Party::native;
  std::vector<Entrant<M>> entrants;
  std::string left_out = {};  // "Box2D 3 (knows the plane alone); …"
};

enum class Kind { joints, contacts };

/// Who runs a scene of one kind. Engines of space are left out of the plane, unless `everybody` takes part;
/// settings of more than `most_work` iterations a frame are not tried.
template <class M>
Field<M> field_of(const Scene<M>& scene, Kind kind, bool everybody = false, double most_work = INFINITY,
                  Party party = Party::native);

/// One number of each setting of an entrant, the less the better; infinite where it failed.
struct Errors {
  std::string name;
  std::vector<double> by_setting;

  double shipped() const { return by_setting[0]; }
  double advised() const { return by_setting[1]; }
  double best() const { return by_setting[best_setting()]; }
  std::size_t best_setting() const {
    return std::min_element(by_setting.begin(), by_setting.end()) - by_setting.begin();
  }
};

/// What has come of a scene with each setting of an entrant.
template <class Outcome>
struct Outcomes {
  std::string name;
  std::vector<Outcome> by_setting;
};

/// look(contestant) of every setting. The engines keep global variables, so that no two run at once.
template <class M, class F>
auto outcomes_of(const Field<M>& field, F&& look) {
  std::vector<Outcomes<decltype(look(field.entrants[0].settings[0]))>> all;
  for (const Entrant<M>& entrant : field.entrants) {
    all.push_back({entrant.name, {}});
    for (const Contestant<M>& contestant : entrant.settings) all.back().by_setting.push_back(look(contestant));
  }
  return all;
}

/// A number of each outcome.
template <class Outcome, class F>
std::vector<Errors> errors_of(const std::vector<Outcomes<Outcome>>& all, F&& number) {
  std::vector<Errors> errors;
  for (const Outcomes<Outcome>& outcomes : all) {
    errors.push_back({outcomes.name, {}});
    for (const Outcome& outcome : outcomes.by_setting) {
      const double found = std::invoke(number, outcome);
      errors.back().by_setting.push_back(std::isfinite(found) ? found : INFINITY);
    }
  }
  return errors;
}

/// "A, B and C".
std::string listed(const std::vector<std::string>& names);

/// "1.2 mm", "failed".
std::string in_millimetres(double metres);

/// A row an engine: its three errors in words, and the setting of the best.
template <class M>
std::vector<std::vector<std::string>> three_rows(const Field<M>& field, const std::vector<Errors>& all,
                                                 const std::function<std::string(double)>& words);
inline const std::vector<std::string> head_of_three_rows{"", "as shipped", "as its manual advises",
                                                         "best of the settings tried", "setting"};

/// Adds these rows as a table, and below it who is left out and who has less error than the course. Alone the
/// course has no best of its settings.
template <class M>
void tell_three(Page& page, const Field<M>& field, const std::vector<Errors>& all,
                const std::function<std::string(double)>& words);

/// The same as a figure on a logarithmic axis; what is less than the margin is drawn there. None of the course
/// alone.
void compare(Page& page, const std::string& name, const std::string& caption, const std::vector<Errors>& all,
             const std::string& label);

/// Error against microseconds a frame, one curve an entrant: of its settings those that no other of its own beats
/// in both. Its title names who is ahead of the course somewhere, by more than a tenth of the time.
template <class M>
Chart against_time(const Field<M>& field, const std::vector<Errors>& errors, const Scene<M>& scene, int frames,
                   const std::string& label);

/// The figure of such a chart. None of the course alone, and none where no setting survived.
void compare_by_time(Page& page, const std::string& name, const std::string& caption,
                     const std::vector<Errors>& errors, const std::function<Chart()>& chart);

/// Whether this build has no other engine: then there is nothing to compare.
inline bool alone() { return engines::all_engines().empty(); }

/// "Left out: Box3D (knows space alone). ", or "".
template <class M>
std::string left_out(const Field<M>& field) {
  return field.left_out.empty() ? "" : say("Left out: @. ", field.left_out);
}

/// Who has less error than the course, by more than a hundredth and the margin: a verdict for each row; "" of the
/// course alone.
std::string judged(Page& page, const std::vector<Errors>& all);

/// The overlap of shapes that is deepest [m].
template <class M>
double deepest_overlap(const Scene<M>& scene);

}  // namespace byhand::beside
