#include "lessons/10_beside_the_engines/field.hpp"

#include <numeric>

#include "lessons/scenes/boxes.hpp"

namespace byhand::beside {

namespace {

constexpr int rounds = 5;  // of each time

template <class M>
Entrant<M> entrant_of(const Engine& engine, Kind kind, double most_work) {
  Entrant<M> entrant{engine.name, engine.single, {}};
  const auto& settings = kind == Kind::joints ? engine.settings.joints : engine.settings.contacts;
  for (const engines::Setting& setting : settings)
    if (setting.row != engines::Row::tuned || engines::iterations_a_frame(setting) <= most_work)
      entrant.settings.push_back(engines::contestant<M>(engine, setting));
  return entrant;
}

}  // namespace

std::vector<Engine> members(Party party) {
  if (party == Party::webassembly) return engines::engines_in_webassembly();
  std::vector<Engine> all = engines::all_engines();
  all.insert(all.begin(), engines::this_course());
  return all;
}

std::optional<Engine> engine_named(const std::string& name, Party party) {
  const std::vector<Engine> all = members(party);
  const auto found = std::ranges::find(all, name, &Engine::name);
  return found == all.end() ? std::nullopt : std::optional(*found);
}

std::string with_build(const Engine& engine) {
  return say("@@", engine.method, engine.build.empty() ? "" : say("; @", engine.build));
}

template <class M>
std::string why_not(const Engine& engine, const Scene<M>& scene, From from) {
  const bool away = M::linear == 2 && engine.home == engines::Home::space && from == From::home;
  const std::string why = engines::refusal(engine, scene);
  return why.empty() && away ? "three-dimensional, compared in space below" : why;
}

template <class M>
Field<M> field_of(const Scene<M>& scene, Kind kind, From from, double most_work, Party party) {
  const std::vector<Engine> all = members(party);
  if (all.size() < 2) most_work = 0;  // nobody to be best against
  Field<M> field{.party = party, .kind = kind, .most_work = most_work, .entrants = {}};
  for (const Engine& engine : all)
    if (why_not(engine, scene, from).empty()) field.entrants.push_back(entrant_of<M>(engine, kind, most_work));
  return field;
}

std::string in_words(double error, Unit unit) {
  if (!std::isfinite(error)) return "failed";
  if (error <= margin) return unit == Unit::metres ? "< 1 µm" : "< 10⁻⁶ rad";
  return unit == Unit::metres ? say("@ mm", Value(1000 * error, 2)) : say("@ rad", Value(error, 2));
}

std::string in_words(const Spread& spread, Unit unit) {
  const std::string least = in_words(spread.least, unit), most = in_words(spread.most, unit);
  return told(spread.most) < 1.1 * told(spread.least) || least == most ? most : say("@ to @", least, most);
}

std::string listed(const std::vector<std::string>& names) {
  std::string all;
  for (std::size_t i = 0; i < names.size(); ++i)
    all += (i == 0 ? "" : i + 1 == names.size() ? " and " : ", ") + names[i];
  return all;
}

template <class M>
std::vector<std::vector<std::string>> three_rows(const Field<M>& field, const std::vector<Errors>& all,
                                                 Unit unit) {
  std::vector<std::vector<std::string>> rows;
  for (std::size_t i = 0; i < all.size(); ++i)
    rows.push_back({all[i].name, in_words(all[i].spread(0), unit), in_words(all[i].spread(1), unit),
                    in_words(all[i].spread(all[i].best_setting()), unit),
                    field.entrants[i].settings[all[i].best_setting()].words()});
  return rows;
}

template <class M>
void tell_three(Page& page, const Field<M>& field, const std::vector<Errors>& all, Unit unit) {
  std::vector<std::string> head = head_of_three_rows;
  std::vector<std::vector<std::string>> rows = three_rows<M>(field, all, unit);
  if (alone()) {
    constexpr std::size_t shipped_and_advised = 3;
    head.resize(shipped_and_advised);
    for (auto& row : rows) row.resize(shipped_and_advised);
  }
  page.table(head, rows);
  if (const std::string verdicts = judged(page, field, all, unit); !verdicts.empty()) page.text("@", verdicts);
}

namespace {

Chart compared(const std::vector<Errors>& all, const std::string& label) {
  Chart chart{.y = {.label = label, .scale = Scale::logarithmic}};
  chart.x.range = {{-0.5, static_cast<double>(all.size()) - 0.5}};
  struct Drawn {
    const char* name;
    double (Errors::*number)() const;
    Colour colour;  // no engine's
  };
  const Drawn rows[] = {{"as shipped", &Errors::shipped, fade(palette::ink, 0.4)},
                        {"as its manual advises", &Errors::advised, fade(palette::ink, 0.7)},
                        {"best of the settings tried", &Errors::best, palette::ink}};
  double aside = -0.12;  // or equal values would hide each other
  for (const auto& [name, number, colour] : rows) {
    Curve curve{.label = name, .style = CurveStyle::markers, .colour = colour};
    for (std::size_t i = 0; i < all.size(); ++i) {
      curve.x.push_back(static_cast<double>(i) + aside);
      curve.y.push_back(told((all[i].*number)()));
    }
    chart.curves.push_back(std::move(curve));
    aside += 0.12;
  }
  for (std::size_t i = 0; i < all.size(); ++i) chart.x.ticks.push_back({static_cast<double>(i), all[i].name});
  if (std::any_of(all.begin(), all.end(), [](const Errors& one) { return one.best() <= margin; }))
    chart.references.push_back({.value = margin, .label = "or less"});
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
    page.clocked(
        name,
        say(R"(@ Of each engine's settings those are drawn that none of its own beats in both, without those
                     that failed; its line joins them, whichever knob differs. A time is the least of @ rounds. Two
                     are compared at times that leave both a run.)",
            caption, rounds),
        chart);
}

namespace {

using engines::Point;

/// The points that no other beats in both, from the quickest on.
std::vector<Point> front(std::vector<Point> all) {
  std::sort(all.begin(), all.end(), [](const Point& a, const Point& b) {
    return std::pair(a.seconds.least, a.error) < std::pair(b.seconds.least, b.error);
  });
  std::vector<Point> kept;
  for (const Point& point : all)
    if (kept.empty() || point.error < kept.back().error) kept.push_back(point);
  return kept;
}

/// The place of a member, and so its colour and marker, in every figure: those in WebAssembly come after the
/// others, but a later version of one of those has its place, and this course is the first of both.
int place_of(std::size_t member, Party party) {
  const std::vector<Engine> natives = members(Party::native);
  const std::string earlier = members(party)[member].earlier;
  for (std::size_t i = 0; i < natives.size(); ++i)
    if (natives[i].name == earlier) return static_cast<int>(i);
  const std::size_t before = member > 0 && party == Party::webassembly ? natives.size() - 1 : 0;
  return static_cast<int>(before + member);
}

/// Whose line the title of a chart shall not break.
std::string unbroken(std::string words) {
  for (std::size_t at; (at = words.find(' ')) != std::string::npos;) words.replace(at, 1, "\u00a0");
  return words;
}

/// Who has the smaller error at equal time, with the least that is, who is level within a tenth of the
/// time, and of those who are not ahead who is quicker than all runs of the course. `when` begins the sentence.
std::string title_of(const std::vector<std::pair<std::string, engines::Beside>>& all, Unit unit,
                     const std::string& when) {
  using engines::Beside;
  using engines::Rank;
  const auto those = [&](const std::string& words, const std::function<std::optional<Point>(const Beside&)>& of) {
    std::vector<std::string> names;
    for (const auto& [name, beside] : all)
      if (const auto point = of(beside))
        names.push_back(
            say("@ (@)", name,
                unbroken(say("@ in @ µs", in_words(point->error, unit), Value(1e6 * point->seconds.least, 2)))));
    return names.empty() ? "" : words + listed(names);
  };
  const auto ranked = [](Rank rank) {
    return [=](const Beside& one) { return one.rank == rank ? std::optional(one.point) : std::nullopt; };
  };
  const auto quicker = [](const Beside& one) { return one.rank == Rank::ahead ? std::nullopt : one.quicker; };
  std::string title;
  for (const std::string& part :
       {those("ahead at equal time: ", ranked(Rank::ahead)), those("level at equal time: ", ranked(Rank::level)),
        those("quicker than any run of this course: ", quicker)})
    if (!part.empty()) title += (title.empty() ? "" : "; ") + part;
  if (title.empty()) title = "at equal time, no engine is ahead of this course with the settings tried";
  title = when + title;
  title.front() = static_cast<char>(std::toupper(title.front()));
  return title;
}

/// Beside an engine in single precision both count as no better than that.
std::vector<Point> no_better(std::vector<Point> points, double least) {
  for (Point& point : points) point.error = told(point.error, least);
  return points;
}
double margin_of(const Errors& theirs, Unit unit, Kind kind) {
  return theirs.single && unit == Unit::metres && kind == Kind::joints ? float_margin : margin;
}

/// What each of these settings takes a frame. After one round only those are timed again that no other of their
/// engine beats by far in both error and time: the rest are not drawn and decide nothing.
template <class M>
std::vector<engines::Seconds> seconds_of(const Timed<M>& timed, const std::vector<Contestant<M>>& contestants,
                                         const std::vector<double>& errors) {
  constexpr double by_far = 1.5;
  auto all = engines::seconds_a_frame(timed.start, contestants, timed.scene, timed.frames, 1);
  std::vector<Contestant<M>> again;
  std::vector<std::size_t> places;
  for (std::size_t i = 0; i < contestants.size(); ++i) {
    bool beaten = false;
    for (std::size_t j = 0; j < contestants.size(); ++j)
      beaten = beaten || (contestants[j].name == contestants[i].name && errors[j] <= errors[i] &&
                          by_far * all[j].least < all[i].least);
    if (!beaten || contestants[i].setting.row == engines::Row::shipped)
      again.push_back(contestants[i]), places.push_back(i);
  }
  const auto more = engines::seconds_a_frame(timed.start, again, timed.scene, timed.frames, rounds - 1);
  for (std::size_t k = 0; k < more.size(); ++k) {
    engines::Seconds& one = all[places[k]];
    one = {std::min(one.least, more[k].least), std::max(one.most, more[k].most)};
  }
  return all;
}

}  // namespace

template <class M>
Chart against_time(const Field<M>& field, const std::vector<Errors>& errors, const Timed<M>& timed,
                   const std::string& label, Unit unit) {
  std::vector<Contestant<M>> contestants;  // without what failed
  std::vector<double> error;               // of each
  for (std::size_t i = 0; i < errors.size(); ++i)
    for (std::size_t j = 0; j < errors[i].by_setting.size(); ++j)
      if (std::isfinite(errors[i].by_setting[j]))
        contestants.push_back(field.entrants[i].settings[j]), error.push_back(errors[i].by_setting[j]);
  const std::vector<engines::Seconds> seconds = seconds_of(timed, contestants, error);
  const std::string where = field.party == Party::webassembly ? " in WebAssembly" : "";
  Chart chart{.x = {.label = label + (unit == Unit::metres ? " (m)" : " (rad)"), .scale = Scale::logarithmic},
              .y = {.label = say("processor time@, first @ frames (µs a frame)", where, timed.frames),
                    .scale = Scale::logarithmic}};
  std::vector<std::vector<Point>> points;
  std::size_t run = 0;
  for (const Errors& one : errors) {
    points.emplace_back();
    for (const double own : one.by_setting) {
      if (!std::isfinite(own)) continue;
      points.back().push_back(
          {seconds[run], told(own),
           say("@ (slowest round @ µs)", contestants[run].words(), Value(1e6 * seconds[run].most, 3))});
      ++run;
    }
  }
  Curve shipped{.label = "as shipped", .style = CurveStyle::markers, .colour = fade(palette::ink, 0.5)};
  const std::vector<Engine> all = members(field.party);
  for (std::size_t i = 0; i < all.size(); ++i) {
    const auto own =
        std::find_if(errors.begin(), errors.end(), [&](const Errors& e) { return e.name == all[i].name; });
    if (own == errors.end()) continue;
    Curve curve{.label = own->name, .style = CurveStyle::line_and_markers, .place = place_of(i, field.party)};
    const std::vector<Point>& all_of_it = points[own - errors.begin()];
    // A mark of its own would hide that of the engine.
    const Point* shipped_setting = std::isfinite(own->shipped()) ? &all_of_it.front() : nullptr;
    for (const Point& point : front(all_of_it)) {
      const bool as_shipped = shipped_setting && point.words == shipped_setting->words;
      curve.x.push_back(point.error);
      curve.y.push_back(1e6 * point.seconds.least);
      curve.point_names.push_back(point.words);
      curve.point_labels.emplace_back(as_shipped ? "as shipped" : "");
      if (as_shipped) shipped_setting = nullptr;
    }
    if (curve.x.empty()) curve.label += " (failed)";
    chart.curves.push_back(std::move(curve));
    if (!shipped_setting) continue;
    shipped.x.push_back(shipped_setting->error);
    shipped.y.push_back(1e6 * shipped_setting->seconds.least);
    shipped.point_names.push_back(own->name);
  }
  if (!shipped.x.empty()) chart.curves.push_back(std::move(shipped));
  std::vector<std::pair<std::string, engines::Beside>> beside;
  for (std::size_t i = 1; i < points.size(); ++i)
    beside.emplace_back(errors[i].name,
                        engines::at_equal_time(no_better(points[i], margin_of(errors[i], unit, field.kind)),
                                               no_better(points[0], margin_of(errors[i], unit, field.kind))));
  if (!beside.empty()) chart.title = title_of(beside, unit, timed.when);
  if (std::any_of(errors.begin(), errors.end(), [](const Errors& one) { return one.best() <= margin; }))
    chart.references.push_back({.axis = Reference::Across::x, .value = margin, .label = "or less"});
  return chart;
}

template <class M>
Scene<M> nudged(Scene<M> scene, int way) {
  // Multiples of these irrational numbers, less whole ones, repeat for no body and in no way.
  const auto aside = [](double turns) { return 2e-6 * (turns - std::floor(turns) - 0.5); };
  for (int i = 0; i < scene.bodies().size(); ++i) {
    if (!moves(scene.bodies().inverse_mass[i])) continue;
    Linear<M> place = scene.bodies().pose[i].position;
    place[0] += aside(0.618034 * i + 0.754878 * way);
    if constexpr (M::linear == 3) place[2] += aside(0.549700 * i + 0.819173 * way);
    scene.set_position(i, place);
  }
  return scene;
}

template <class M>
double deepest_overlap(const Scene<M>& scene) {
  ContactManager<M> contacts;
  contacts.find(scene);
  return position_error(scene, contacts).max;
}

template <class M>
double passes_a_frame(const Scene<M>& scene, double speed, int frames) {
  Simulation<M> simulation{scene};
  for (int i = 0; i < settling; ++i) simulation.step(frame);
  if (speed > 0) kick(simulation.scene, speed);
  const long long before = simulation.work.executed.passes;
  for (int i = 0; i < frames; ++i) simulation.step(frame);
  return static_cast<double>(simulation.work.executed.passes - before) / frames;
}

namespace {

/// What of each entrant is compared, and how the sentence about it begins.
struct Compared {
  std::string name;
  std::function<Spread(const Errors&)> spread;
};

template <class M>
Compared best_of(const Field<M>& field) {
  const int steps = field.kind == Kind::joints ? engines::joint_steps.back() : engines::contact_steps.back();
  return {std::isfinite(field.most_work)
              ? say("With the best of the settings tried, of up to @ iterations in up to @ steps a frame,",
                    field.most_work, steps)
              : say("With the best of the settings tried, in up to @ steps a frame,", steps),
          [](const Errors& one) { return one.spread(one.best_setting()); }};
}

template <class M>
std::string judged_by(const std::vector<Compared>& rows, Page& page, const Field<M>& field,
                      const std::vector<Errors>& all, Unit unit, const std::string& what) {
  if (all.size() < 2) return "";
  const std::string of_these = all.size() < members(field.party).size() ? " of these" : "";
  std::string words;
  for (const auto& [name, spread_of] : rows) {
    const Spread ours_from = spread_of(all[0]);
    // Ahead is who has less from all starts than this course has from any.
    const double own = told(ours_from.most), own_least = told(ours_from.least);
    double worst_ahead = 0, worst_level = 0, least = INFINITY, least_level = INFINITY, ends = margin;
    const bool own_varies = own > engines::equal_errors * own_least;  // by the start
    bool varies = own_varies;                                         // somebody's
    std::vector<std::string> ahead, level;
    for (std::size_t i = 1; i < all.size(); ++i) {
      const double finest = margin_of(all[i], unit, field.kind);
      const Spread theirs_from = spread_of(all[i]);
      const double error = told(theirs_from.most, finest), error_least = told(theirs_from.least, finest);
      varies = varies || error > engines::equal_errors * error_least;
      least = std::min(least, error_least);
      if (engines::equal_errors * error < told(own_least, finest))
        ahead.push_back(all[i].name), worst_ahead = std::max(worst_ahead, error);
      else if (std::isfinite(own_least) && error_least < engines::equal_errors * told(own, finest))
        level.push_back(all[i].name), worst_level = std::max(worst_level, error),
                                      least_level = std::min(least_level, error_least),
                                      ends = std::max(ends, finest);
    }
    std::vector<std::string> below{"this course"};
    below.insert(below.end(), level.begin(), level.end());
    const std::string where = varies ? say(" from these @ starts", ways + 1) : "";
    const bool by_chance = own_varies || worst_level > engines::equal_errors * own;
    const Quantity ours("ours", own), ours_at_least("ours", own_least), theirs("the least of theirs", least);
    course::Judgement sentence;
    if (!ahead.empty() && std::isfinite(own_least))
      sentence = {.when = Quantity("the largest of theirs", worst_ahead) < ours_at_least,
                  .say = say("@ this course has more @ than @@.", name, what, listed(ahead), where)};
    else if (!ahead.empty())
      sentence = {.when = Quantity("the largest of theirs", worst_ahead) < INFINITY,
                  .say = say("@ this course fails, and @.", name,
                             ahead.size() == 1 ? ahead[0] + " does not" : listed(ahead) + " do not")};
    else if (!std::isfinite(own_least))
      sentence = {.when = theirs >= INFINITY, .say = say("@ all fail.", name)};
    else if (level.empty())
      sentence = {.when = theirs > ours,
                  .say = say("@ this course has the least @@@.", name, what, of_these, where)};
    else if (own <= ends)
      sentence = {.when = Quantity("the largest", std::max(own, worst_level)) <= ends,
                  .say = say("@ @ have at most @@, where this comparison ends@.", name, listed(below),
                             unit == Unit::radians ? "10⁻⁶ rad" : say("@ µm", Value(1e6 * ends, 1)), where,
                             ends > margin ? " beside single precision" : "")};
    else if (by_chance)
      sentence = {.when = Quantity("the least of theirs", least_level) <
                          Quantity("1.01 × the largest of ours", engines::equal_errors * own),
                  .say = say("@ whether this course has less @ than @ hangs on the last digits of the start.",
                             name, what, listed(level))};
    else
      sentence = {
          .when = Quantity("the largest of those level", worst_level) <=
                  Quantity("1.01 × ours", engines::equal_errors * own),
          .say = say("@ this course has the least @@, level with @.", name, what, of_these, listed(level))};
    words += say("@@", words.empty() ? "" : " ", page.verdict({sentence}));
  }
  return words;
}

}  // namespace

template <class M>
std::string judged(Page& page, const Field<M>& field, const std::vector<Errors>& all, Unit unit,
                   const std::string& what) {
  return judged_by<M>({{"As shipped,", [](const Errors& one) { return one.spread(0); }},
                       {"As advised,", [](const Errors& one) { return one.spread(1); }},
                       best_of(field)},
                      page, field, all, unit, what);
}

template <class M>
std::string judged_at_best(Page& page, const Field<M>& field, const std::vector<Errors>& all, Unit unit) {
  return judged_by<M>({best_of(field)}, page, field, all, unit, "error");
}

#define BYHAND_INSTANTIATE(M)                                                                                   \
  template Field<M> field_of(const Scene<M>&, Kind, From, double, Party);                                       \
  template std::string why_not(const Engine&, const Scene<M>&, From);                                           \
  template std::vector<std::vector<std::string>> three_rows(const Field<M>&, const std::vector<Errors>&, Unit); \
  template void tell_three(Page&, const Field<M>&, const std::vector<Errors>&, Unit);                           \
  template std::string judged(Page&, const Field<M>&, const std::vector<Errors>&, Unit, const std::string&);    \
  template std::string judged_at_best(Page&, const Field<M>&, const std::vector<Errors>&, Unit);                \
  template double passes_a_frame(const Scene<M>&, double, int);                                                 \
  template Chart against_time(const Field<M>&, const std::vector<Errors>&, const Timed<M>&, const std::string&, \
                              Unit);                                                                            \
  template Scene<M> nudged(Scene<M>, int);                                                                      \
  template double deepest_overlap(const Scene<M>&)
BYHAND_INSTANTIATE(PlaneBody);
BYHAND_INSTANTIATE(SpaceBody);
#undef BYHAND_INSTANTIATE

}  // namespace byhand::beside
