#pragma once

#include <functional>

#include "lessons/08_where_methods_fail/setting.hpp"

// Films of one scene that is run in several ways, beside each other; each stops where it fails.
namespace byhand::failures {

/// One of the runs.
template <class M>
struct Take {
  std::string name;
  Simulation<M> run;
};

/// How a run of a film ends. Drifts: it has not failed, but its gauge still grows.
enum class End { holds, drifts, fails };

/// What a film shows and for how long.
template <class M>
struct Shooting {
  std::vector<Take<M>> takes = {};
  renderer::Rectangle view = {};                     // of the world [m]
  double seconds = 3.5;                              // of film
  double hurry = 1;                                  // seconds of the scene in one of the film
  renderer::Axis gauge = {};                         // what the chart beside shows
  std::function<double(const Scene<M>&)> read = {};  // and how it is read off the scene
  std::vector<renderer::Curve> laws = {};            // drawn over it
  std::function<bool(const Scene<M>&)> failed = {};  // where a run stops
  std::string failure = {}, success = {};            // its words: "falls" or "stands"
  std::string drifting = "";                         // "still leans further"; none if no run can drift
  double noticed = 0;                                // by the gauge, where a run that still grows drifts
  std::function<void(renderer::Canvas&, const Scene<M>&, const renderer::Look& bodies)> draw = {};  // in the world
};

/// Draws a run's cell on the page: its name above, what is said of it below, the scene by `draw` in between.
void draw_cell(renderer::Canvas& canvas, const renderer::Rectangle& cell, const renderer::Rectangle& view,
               int number, const std::string& name, const std::string& words, bool failed,
               const std::function<void()>& draw);

/// The runs made and their gauges read: what is then drawn, as often as it is wanted.
template <class M>
class Film {
 public:
  explicit Film(Shooting<M> shooting);

  double seconds() const { return plan_.seconds; }
  double hurry() const { return plan_.hurry; }
  bool failed(int take) const { return ends_[take] == End::fails; }
  /// Whether it fails, drifts or holds, for a verdict that says so.
  course::Condition fails(int take) const { return ended(take, End::fails); }
  course::Condition drifts(int take) const { return ended(take, End::drifts); }
  course::Condition holds(int take) const { return ended(take, End::holds); }
  /// "falls after 2.4 s", "still leans further" or "stands".
  std::string fate(int take) const;
  /// When it failed, or how long it ran [s].
  double ended_after(int take) const { return fails_at_[take]; }
  /// What its gauge says at the end.
  double last(int take) const { return last_[take]; }
  course::FrameDrawing drawing() const;

 private:
  static constexpr double step = 1.0 / 60;
  course::Condition ended(int take, End end) const {
    const std::string& name = plan_.takes[take].name;
    const auto words = [&](End one) {
      return course::say("@: @", name,
                         one == End::fails    ? plan_.failure
                         : one == End::drifts ? plan_.drifting
                                              : plan_.success);
    };
    return {ends_[take] == end, words(end), words(ends_[take])};
  }
  /// Whether a gauge that goes up and down is larger in the last third than in the third before.
  bool grows(const std::vector<double>& gauge) const {
    const auto third = static_cast<std::ptrdiff_t>(gauge.size() / 3);
    const auto largest = [](auto from, auto to) { return from == to ? 0 : *std::max_element(from, to); };
    const double last = largest(gauge.end() - third, gauge.end()),
                 before = largest(gauge.end() - 2 * third, gauge.end() - third);
    return last > plan_.noticed && last > 1.05 * before;
  }

  Shooting<M> plan_;
  std::vector<End> ends_;
  std::vector<double> fails_at_;  // [s], of those that fail
  std::vector<double> last_;      // what the gauges say in the end
  renderer::Chart gauges_;
};

template <class M>
Film<M>::Film(Shooting<M> shooting) : plan_(std::move(shooting)) {
  const double end = plan_.hurry * plan_.seconds;
  gauges_ = {.x = {.label = "time (s)", .range = {{0, end}}}, .y = plan_.gauge};
  for (const Take<M>& take : plan_.takes) {
    renderer::Curve curve{.label = take.name};
    Simulation<M> run = take.run;
    std::vector<double> gauge;
    for (;; run.step(step)) {
      const double value = plan_.read(run.scene);
      const bool shown = plan_.gauge.scale == renderer::Scale::linear || value > 0;
      gauge.push_back(value);
      curve.x.push_back(run.time);
      curve.y.push_back(shown ? value : NAN);
      if (run.time > end - 0.5 * step || plan_.failed(run.scene)) break;
    }
    ends_.push_back(plan_.failed(run.scene)                   ? End::fails
                    : !plan_.drifting.empty() && grows(gauge) ? End::drifts
                                                              : End::holds);
    fails_at_.push_back(run.time);
    last_.push_back(plan_.read(run.scene));
    gauges_.curves.push_back(std::move(curve));
  }
  gauges_.curves.insert(gauges_.curves.end(), plan_.laws.begin(), plan_.laws.end());
}

template <class M>
std::string Film<M>::fate(int take) const {
  if (failed(take)) return course::say("@ after @ s", plan_.failure, course::Value(fails_at_[take], 3));
  return ends_[take] == End::drifts ? plan_.drifting : plan_.success;
}

template <class M>
course::FrameDrawing Film<M>::drawing() const {
  return [film = *this, takes = plan_.takes](renderer::Canvas& canvas, double time) mutable {
    const Shooting<M>& plan = film.plan_;
    const auto [left, right] = canvas.page().inset(14).panels(0.64, 16);
    const auto cells = left.cells(1, static_cast<int>(takes.size()), 8);
    for (int i = 0; i < static_cast<int>(takes.size()); ++i) {
      Simulation<M>& run = takes[i].run;
      while (run.time < plan.hurry * time - 0.5 * step && !plan.failed(run.scene)) run.step(step);
      const bool failed = plan.failed(run.scene);
      draw_cell(canvas, cells[i], plan.view, i, takes[i].name,
                failed ? film.fate(i) : course::say("@ s", course::Value(run.time, 3)), failed,
                [&] { plan.draw(canvas, run.scene, pictures::look_of_run(i)); });
    }
    renderer::draw(canvas, pictures::grown_to(film.gauges_, plan.hurry * time + 1e-9), right.lowered(40));
  };
}

}  // namespace byhand::failures
