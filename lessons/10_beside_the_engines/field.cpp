#include "lessons/10_beside_the_engines/field.hpp"

#include <numeric>

namespace byhand::beside {

namespace {

/// Iterations or substeps in a frame.
double work(const engines::Setting& setting) {
  double most = 1;
  for (const char* name : {"substeps", "iterations", "velocity iterations"})
    most = std::max(most, setting.knobs.value(name, 1));
  return most * setting.steps;
}

template <class M>
Entrant<M> entrant_of(const Engine& engine, Kind kind, double most_work) {
  Entrant<M> entrant{engine.name, {}};
  const auto& settings = kind == Kind::joints ? engine.settings.joints : engine.settings.contacts;
  for (const engines::Setting& setting : settings)
    if (setting.row != engines::Row::tuned || work(setting) <= most_work)
      entrant.settings.push_back(engines::contestant<M>(engine, setting));
  return entrant;
}

/// All who may take part somewhere, this course first.
std::vector<Engine> members(Party party) {
  if (party == Party::webassembly) return engines::engines_in_webassembly();
  std::vector<Engine> all = engines::all_engines();
  all.insert(all.begin(), engines::this_course());
  return all;
}

}  // namespace

template <class M>
Field<M> field_of(const Scene<M>& scene, Kind kind, bool everybody, double most_work, Party party) {
  const std::vector<Engine> all = members(party);
  if (all.size() < 2) most_work = 0;  // nobody to be best against
  Field<M> field{.party = party, .entrants = {}};
  std::vector<std::pair<std::string, std::string>> reasons;  // and whose
  for (const Engine& engine : all) {
    std::string why = engines::refusal(engine, scene);
    if (why.empty() && M::linear == 2 && engine.home == engines::Home::space && !everybody)
      why = "three-dimensional, compared below in space";
    if (why.empty()) {
      field.entrants.push_back(entrant_of<M>(engine, kind, most_work));
      continue;
    }
    const auto same = std::find_if(reasons.begin(), reasons.end(), [&](const auto& r) { return r.first == why; });
    if (same == reasons.end())
      reasons.emplace_back(why, engine.name);
    else
      same->second += ", " + engine.name;
  }
  for (const auto& [why, names] : reasons)
    field.left_out += say("@@ (@)", field.left_out.empty() ? "" : "; ", names, why);
  return field;
}

std::string listed(const std::vector<std::string>& names) {
  std::string all;
  for (std::size_t i = 0; i < names.size(); ++i)
    all += (i == 0 ? "" : i + 1 < names.size() ? ", " : " and ") + names[i];
  return all;
}

std::string in_millimetres(double metres) {
  if (!std::isfinite(metres)) return "failed";
  if (metres == 0) return "0";
  return metres < 1e-9 ? std::string("< 1 nm") : say("@ mm", Value(1000 * metres, 2));
}

template <class M>
std::vector<std::vector<std::string>> three_rows(const Field<M>& field, const std::vector<Errors>& all,
                                                 const std::function<std::string(double)>& words) {
  std::vector<std::vector<std::string>> rows;
  for (std::size_t i = 0; i < all.size(); ++i)
    rows.push_back({all[i].name, words(all[i].shipped()), words(all[i].advised()), words(all[i].best()),
                    field.entrants[i].settings[all[i].best_setting()].words()});
  return rows;
}

template <class M>
void tell_three(Page& page, const Field<M>& field, const std::vector<Errors>& all,
                const std::function<std::string(double)>& words) {
  std::vector<std::string> head = head_of_three_rows;
  std::vector<std::vector<std::string>> rows = three_rows<M>(field, all, words);
  if (alone()) {
    constexpr std::size_t shipped_and_advised = 3;
    head.resize(shipped_and_advised);
    for (auto& row : rows) row.resize(shipped_and_advised);
  }
  page.table(head, rows);
  const std::string out = left_out(field), verdicts = judged(page, all);
  if (!out.empty() || !verdicts.empty()) page.text("@@", out, verdicts);
}

namespace {

/// "or less" at the margin, if something is drawn there.
void mark_margin(Chart& chart) {
  if (std::any_of(chart.curves.begin(), chart.curves.end(),
                  [](const Curve& one) { return std::find(one.y.begin(), one.y.end(), margin) != one.y.end(); }))
    chart.references.push_back({.value = margin, .label = "or less"});
}

Chart compared(const std::vector<Errors>& all, const std::string& label) {
  Chart chart{.y = {.label = label, .scale = Scale::logarithmic}};
  chart.x.range = {{-0.5, static_cast<double>(all.size()) - 0.5}};
  const std::pair<const char*, double (Errors::*)() const> rows[] = {
      {"as shipped", &Errors::shipped},
      {"as its manual advises", &Errors::advised},
      {"best of the settings tried", &Errors::best}};
  double aside = -0.12;  // or equal values would hide each other
  for (const auto& [name, number] : rows) {
    Curve curve{.label = name, .style = CurveStyle::markers};
    for (std::size_t i = 0; i < all.size(); ++i) {
      curve.x.push_back(static_cast<double>(i) + aside);
      curve.y.push_back(std::max((all[i].*number)(), margin));
    }
    chart.curves.push_back(std::move(curve));
    aside += 0.12;
  }
  for (std::size_t i = 0; i < all.size(); ++i) chart.x.ticks.push_back({static_cast<double>(i), all[i].name});
  mark_margin(chart);
  return chart;
}

}  // namespace

void compare(Page& page, const std::string& name, const std::string& caption, const std::vector<Errors>& all,
             const std::string& label) {
  if (alone()) return;
  const bool failed = std::any_of(all.begin(), all.end(), [](const Errors& one) {
    return !std::isfinite(one.shipped()) || !std::isfinite(one.advised()) || !std::isfinite(one.best());
  });
  page.figure(name, say("@@", caption, failed ? " A cross at the upper edge: failed." : ""), compared(all, label));
}

void compare_by_time(Page& page, const std::string& name, const std::string& caption,
                     const std::vector<Errors>& errors, const std::function<Chart()>& chart) {
  if (alone()) return;
  if (std::none_of(errors.begin(), errors.end(), [](const Errors& one) { return std::isfinite(one.best()); }))
    page.text("No setting survived, so there is no chart of error and time.");
  else
    page.clocked(name, caption, chart);
}

namespace {

struct Point {
  double time = 0, error = 0;  // [µs a frame, the error's unit]
  std::string words = {};
};

/// The points that no other beats in both, from the quickest on.
std::vector<Point> front(std::vector<Point> all) {
  std::sort(all.begin(), all.end(), [](const Point& a, const Point& b) {
    return std::pair(a.time, a.error) < std::pair(b.time, b.error);
  });
  std::vector<Point> kept;
  for (const Point& point : all)
    if (kept.empty() || point.error < kept.back().error) kept.push_back(point);
  return kept;
}

/// Of members, each of which keeps its place, and so its colour and marker, in every figure of its party: the
/// series' colours, and two more.
Colour colour_of(std::size_t place) {
  constexpr std::size_t series = 8;
  constexpr Colour further[] = {palette::muted, {0, 139, 160}};
  return place < series ? palette::series(static_cast<int>(place)) : further[(place - series) % 2];
}

/// Whether some point of theirs is beaten by none of ours, in both, by more than clocks and judged() tell apart.
bool ahead_somewhere(const std::vector<Point>& theirs, const std::vector<Point>& ours) {
  return std::any_of(theirs.begin(), theirs.end(), [&](const Point& point) {
    return std::none_of(ours.begin(), ours.end(), [&](const Point& own) {
      return own.time <= 1.1 * point.time && own.error <= 1.01 * point.error;
    });
  });
}

}  // namespace

template <class M>
Chart against_time(const Field<M>& field, const std::vector<Errors>& errors, const Scene<M>& scene, int frames,
                   const std::string& label) {
  std::vector<Contestant<M>> contestants;  // without what failed
  for (std::size_t i = 0; i < errors.size(); ++i)
    for (std::size_t j = 0; j < errors[i].by_setting.size(); ++j)
      if (std::isfinite(errors[i].by_setting[j])) contestants.push_back(field.entrants[i].settings[j]);
  const std::vector<double> seconds = engines::seconds_a_frame(contestants, scene, frames, 3);
  const std::string where = field.party == Party::webassembly ? " in WebAssembly" : "";
  Chart chart{.x = {.label = "processor time" + where + " (µs a frame)", .scale = Scale::logarithmic},
              .y = {.label = label, .scale = Scale::logarithmic}};
  std::vector<std::vector<Point>> fronts;
  std::size_t place = 0;
  for (std::size_t i = 0; i < errors.size(); ++i) {
    std::vector<Point> points;
    for (const double error : errors[i].by_setting) {
      if (!std::isfinite(error)) continue;
      points.push_back({1e6 * seconds[place], std::max(error, margin), contestants[place].words()});
      ++place;
    }
    fronts.push_back(front(points));
  }
  for (const Engine& member : members(field.party)) {
    const std::string& name = member.name;
    Curve curve{.label = name, .style = CurveStyle::line_and_markers, .colour = colour_of(chart.curves.size())};
    const auto own = std::find_if(errors.begin(), errors.end(), [&](const Errors& e) { return e.name == name; });
    if (own == errors.end()) {
      curve.label = "";  // left out
    } else {
      for (const Point& point : fronts[own - errors.begin()]) {
        curve.x.push_back(point.time);
        curve.y.push_back(point.error);
        curve.point_names.push_back(point.words);
      }
      if (curve.x.empty()) curve.label += " (failed)";
    }
    chart.curves.push_back(std::move(curve));
  }
  std::vector<std::string> ahead;
  for (std::size_t i = 1; i < fronts.size(); ++i)
    if (ahead_somewhere(fronts[i], fronts[0])) ahead.push_back(errors[i].name);
  if (fronts.size() > 1)
    chart.title = ahead.empty() ? "At equal time no engine drawn here has less error than this course"
                                : "At some time less error than this course: " + listed(ahead);
  mark_margin(chart);
  return chart;
}

template <class M>
double deepest_overlap(const Scene<M>& scene) {
  ContactManager<M> contacts;
  contacts.find(scene);
  return position_error(scene, contacts).max;
}

namespace {

/// As far as figures tell numbers apart.
double told(double error) { return std::max(error, margin); }

}  // namespace

std::string judged(Page& page, const std::vector<Errors>& all) {
  if (all.size() < 2) return "";
  std::string words;
  const std::pair<const char*, double (Errors::*)() const> rows[] = {
      {"As shipped,", &Errors::shipped}, {"As advised,", &Errors::advised}, {"At their best,", &Errors::best}};
  for (const auto& [name, number] : rows) {
    const double own = told((all[0].*number)());
    double theirs = INFINITY;
    std::vector<std::string> ahead, level;
    for (std::size_t i = 1; i < all.size(); ++i) {
      const double error = told((all[i].*number)());
      theirs = std::min(theirs, error);
      if (1.01 * error < own)
        ahead.push_back(all[i].name);
      else if (std::isfinite(own) && error < 1.01 * own)
        level.push_back(all[i].name);
    }
    const Quantity ours("this course", own), less("1.01 × the least of the engines", 1.01 * theirs),
        more("1.01 × this course", 1.01 * own), least("the least of the engines", theirs);
    words += say(
        "@@", words.empty() ? "" : " ",
        page.verdict(
            {{.when = less < ours, .say = say("@ this course has more error than @.", name, listed(ahead))},
             {.when = least > more, .say = say("@ this course has the least error.", name)},
             {.when = least <= more,
              .say = level.empty()  ? say("@ all fail.", name)
                     : own > margin ? say("@ this course has the least error, level with @.", name, listed(level))
                                    : say("@ this course is below 10⁻⁶, where the comparison ends, and so @ @.",
                                          name, level.size() == 1 ? "is" : "are", listed(level))}}));
  }
  return words;
}

#define BYHAND_INSTANTIATE(M)                                                                            \
  template Field<M> field_of(const Scene<M>&, Kind, bool, double, Party);                                \
  template std::vector<std::vector<std::string>> three_rows(const Field<M>&, const std::vector<Errors>&, \
                                                            const std::function<std::string(double)>&);  \
  template void tell_three(Page&, const Field<M>&, const std::vector<Errors>&,                           \
                           const std::function<std::string(double)>&);                                   \
  template Chart against_time(const Field<M>&, const std::vector<Errors>&, const Scene<M>&, int,         \
                              const std::string&);                                                       \
  template double deepest_overlap(const Scene<M>&)
BYHAND_INSTANTIATE(PlaneBody);
BYHAND_INSTANTIATE(SpaceBody);
#undef BYHAND_INSTANTIATE

}  // namespace byhand::beside
