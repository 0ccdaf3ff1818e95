// Step 3 and after it: a level chain with a load at its end, in the plane and in space.

#include "lessons/10_beside_the_engines/field.hpp"
#include "lessons/10_beside_the_engines/steps.hpp"
#include "lessons/exact/swinging_chain.hpp"
#include "lessons/laws/transverse.hpp"
#include "lessons/scenes/branches.hpp"
#include "lessons/scenes/chain.hpp"

namespace byhand::beside {
namespace {

constexpr double let_go_level = std::numbers::pi / 2;
constexpr double most_gained = 0.1;  // energy, over what gravity could do
constexpr int timed_frames = 60, timed_space_frames = 30;

/// When a load let go level is at its lowest point: a quarter of a pendulum's period, K(sin² 45°) √(L/g) [s].
double time_down(int links) { return 1.8541 * std::sqrt(links / gravity); }

/// Frames of a whole swing, let go level. At least 6 s.
int frames_of(int links) { return static_cast<int>(std::ceil(std::max(6.0, 4 * time_down(links)) / frame)); }

/// Frames until the load has passed its lowest point, where the pull is greatest (law 7), and half of that time
/// on.
int frames_past_lowest(int links) { return static_cast<int>(std::ceil(1.5 * time_down(links) / frame)); }

/// After so many frames the places are compared: 2 s, or half the way down.
int exact_frames_of(int links) { return static_cast<int>(std::min(2.0, 0.5 * time_down(links)) / frame + 0.5); }

/// T h²/(m l) of the topmost pin at the lowest point, with the links' weight, if the chain swings as one rod.
double number_of_law_7(int links, double end_mass) {
  const double others = links - 1, moment = end_mass + others / 2,
               turning = 2 * gravity * moment / (end_mass + others / 3);  // ω² L
  return ((end_mass + others) * gravity + turning * moment) * frame * frame;
}

/// Let go level, or lower by a few µrad.
template <class M>
Scene<M> chain_of(int links, double end_mass, int microradians = 0) {
  return pinned_chain<M>({.links = links, .end_mass = end_mass, .angle = let_go_level - 1e-6 * microradians});
}

/// The centres of the links when they are compared, from an integration in their angles to rounding.
std::vector<Eigen::Vector2d> exact_places(int links, double end_mass) {
  std::vector<SwingingChain::Link> all;
  for (int i = 1; i <= links; ++i) {
    const double mass = i == links ? end_mass : 1;
    all.push_back({.length = 1, .centre = 0.5, .mass = mass, .inertia = mass * (1 + 0.01) / 12});
  }
  return SwingingChain(all, let_go_level, gravity).at(exact_frames_of(links) * frame).positions;
}

/// What has come of a chain. All are infinite once a pin has opened by a link, or once it has gained a tenth of
/// the energy that gravity could give it: coordinates that cannot part can still explode.
struct Hung {
  enum class End { held, parted, exploded } end = End::held;
  double gap = 0;     // the largest of a pin [m]
  double off = 0;     // when compared, of the link that is farthest from where it belongs [m]
  double gained = 0;  // the largest change of the energy, up or down, over what gravity could do over its reach
  double time = 0;    // of its end [s]
};

template <class M>
Hung hang(const Contestant<M>& contestant, const Scene<M>& scene, int frames,
          const std::vector<Eigen::Vector2d>& exact = {}) {
  double scale = 0;
  for (int i = 0; i < scene.bodies().size(); ++i)
    if (moves(scene.bodies().inverse_mass[i]))
      scale += gravity * scene.bodies().pose[i].position.norm() / scene.bodies().inverse_mass[i].linear;
  Hung hung;
  engines::run_while<M>({}, contestant, scene, frames, [&](const Scene<M>& seen, double time) {
    hung.gap = larger(hung.gap, position_error(seen).max);
    if (std::abs(time - exact_frames_of(static_cast<int>(exact.size())) * frame) < 0.5 * frame)
      for (std::size_t i = 0; i < exact.size(); ++i)
        hung.off = larger(hung.off, (seen.bodies().pose[i + 1].position.template head<2>() - exact[i]).norm());
    const double gained = (energy(seen) - energy(scene)) / scale;
    hung.gained = farther(hung.gained, gained);
    hung.time = time;
    if (!(hung.gap < 1))
      hung.end = Hung::End::parted;
    else if (!(gained < most_gained))
      hung.end = Hung::End::exploded;
    return hung.end == Hung::End::held;
  });
  return hung.end == Hung::End::held ? hung : Hung{hung.end, INFINITY, INFINITY, INFINITY, hung.time};
}

/// The largest gaps, of both rows and of what is near the best from starts nearby, too.
template <class M>
std::vector<Errors> gaps_of(const Field<M>& field, const std::vector<Outcomes<Hung>>& outcomes, int links,
                            double end_mass) {
  auto gaps = errors_of(outcomes, &Hung::gap);
  add_spreads(
      field, [&](int way) { return chain_of<M>(links, end_mass, way + 1); }, gaps,
      [&](const auto& who, const auto& start) { return hang<M>(who, start, frames_of(links)).gap; });
  return gaps;
}

/// How and when those failed that did, as shipped and as advised.
std::string failures(const std::vector<Outcomes<Hung>>& all) {
  std::vector<std::string> parted, exploded;
  for (const Outcomes<Hung>& one : all)
    for (const std::size_t row : {0, 1}) {
      const Hung& hung = one.by_setting[row];
      const std::string name = say("@ @ after @ s", one.name, row_names[row], Value(hung.time, 3));
      if (hung.end == Hung::End::parted) parted.push_back(name);
      if (hung.end == Hung::End::exploded) exploded.push_back(name);
    }
  std::string words;
  if (!parted.empty()) words += say("A pin opened by a link: @. ", listed(parted));
  if (!exploded.empty())
    words += say("The energy grew by @ % of that of a fall before any pin had opened so far: @.",
                 100 * most_gained, listed(exploded));
  return words;
}

/// Of the settings whose gap is the best, the one whose energy changes least.
std::size_t best_by_gap_and_energy(const Outcomes<Hung>& one, const Errors& gaps) {
  std::size_t best = gaps.best_setting();
  for (std::size_t i = 0; i < one.by_setting.size(); ++i)
    if (told(one.by_setting[i].gap) <= told(gaps.best()) &&
        std::abs(one.by_setting[i].gained) < std::abs(one.by_setting[best].gained))
      best = i;
  return best;
}

/// Which of both rows and of the best settings fail later, watched on from one start.
template <class M>
void tell_later(Page& page, const Field<M>& field, const std::vector<Outcomes<Hung>>& outcomes,
                const std::vector<Errors>& gaps, const Scene<M>& scene) {
  constexpr double minute = 60;  // [s]
  std::vector<std::string> failed;
  for (std::size_t i = 0; i < gaps.size(); ++i) {
    std::map<std::size_t, std::string> rows{{0, row_names[0]}, {1, row_names[1]}};
    if (!alone())
      rows.emplace(best_by_gap_and_energy(outcomes[i], gaps[i]), "at its best by the gap and of equals by energy");
    for (const auto& [setting, row] : rows) {
      if (!std::isfinite(gaps[i].by_setting[setting])) continue;
      const Hung hung = hang<M>(field.entrants[i].settings[setting], scene, static_cast<int>(minute / frame));
      if (hung.end != Hung::End::held)
        failed.push_back(say("@ @ after @ s", gaps[i].name, row, Value(hung.time, 3)));
    }
  }
  const Quantity many("how many fail later", static_cast<double>(failed.size()));
  page.text("@", page.verdict(
                     {{.when = many < 1,
                       .say = say("Watched on to @ s, from one start, none fails that has held so far.", minute)},
                      {.when = many >= 1,
                       .say = say("Watched on to @ s, from one start, these fail that have held so far: @.",
                                  minute, listed(failed))}}));
}

template <class M>
void tell_gaps(Page& page, const Field<M>& field, const std::vector<Outcomes<Hung>>& outcomes,
               const std::vector<Errors>& gaps, const Scene<M>& scene) {
  tell_three<M>(page, field, gaps, Unit::metres);
  if (const std::string how = failures(outcomes); !how.empty()) page.text("@", how);
  tell_later(page, field, outcomes, gaps, scene);
}

std::string in_per_cent(double share) {
  return std::isfinite(share) ? say("@ %", Value(100 * share, 2)) : std::string("failed");
}

/// Energy of the rows that the gap is told of.
std::vector<std::vector<std::string>> energies(const std::vector<Outcomes<Hung>>& all,
                                               const std::vector<Errors>& gaps) {
  std::vector<std::vector<std::string>> rows;
  for (std::size_t i = 0; i < all.size(); ++i)
    rows.push_back(
        {all[i].name, in_per_cent(all[i].by_setting[0].gained), in_per_cent(all[i].by_setting[1].gained)});
  for (std::size_t i = 0; i < all.size() && !alone(); ++i)
    rows[i].push_back(in_per_cent(all[i].by_setting[best_by_gap_and_energy(all[i], gaps[i])].gained));
  return rows;
}
std::vector<std::string> head_of_energies() {
  std::vector<std::string> head{"", "as shipped", "as its manual advises"};
  if (!alone()) head.emplace_back("best by the gap, and of equals by energy");
  return head;
}

/// Where this course's chain tears, by substeps as shipped, and what law 7 says of that.
void by_law_7(Page& page, const Scene<PlaneBody>& scene, int links, double end_mass) {
  const Quantity limit("law 7's limit of pinned rods", laws::limit_of_rods);
  std::vector<std::vector<std::string>> rows;
  std::vector<double> torn, held;
  for (const int substeps : {1, 2, 4, 8}) {
    const engines::Setting setting{.knobs = {{"substeps", substeps}}};
    const double number = number_of_law_7(links, end_mass) / (substeps * substeps),
                 gap = hang<PlaneBody>(engines::contestant<PlaneBody>(engines::this_course(), setting), scene,
                                       frames_past_lowest(links))
                           .gap;
    (std::isfinite(gap) ? held : torn).push_back(number);
    rows.push_back({std::to_string(substeps), say("@", Value(number, 2)), in_millimetres(gap)});
  }
  page.text(
      R"(If the chain swings as one rod, its links' weight counted, T h²/(m l) at the top and at the lowest point is, for
      this course's substeps, with the largest gap of the first @ s, when the load has passed that point:)",
      Value(frames_past_lowest(links) * frame, 2));
  page.table({"substeps", "T h²/(m l)", "largest gap"}, rows);
  const Quantity tear("how many of them tear", static_cast<double>(torn.size())),
      hold("how many of them hold", static_cast<double>(held.size())),
      least("the least that tears", torn.empty() ? 0 : *std::ranges::min_element(torn)),
      most("the most that holds", held.empty() ? 0 : *std::ranges::max_element(held));
  page.text("@ @",
            page.verdict({{.when = tear < 1, .say = "With none of them it tears so soon."},
                          {.when = least > limit, .say = "What tears so soon is beyond law 7's third."},
                          {.when = least <= limit,
                           .say = "It tears below law 7's third, too, which takes the chain for one rod."}}),
            page.verdict({{.when = hold < 1, .say = "With none of them it holds so long."},
                          {.when = most <= limit,
                           .say = "What holds so long is below it; the rest of the swing is another matter."},
                          {.when = most > limit,
                           .say = say("Yet with @ it holds so long beyond a third.", Value(most.value, 2))}}));
}

/// Law 7 is of the way down.
template <class M>
void claim_way_down(Page& page, const std::string& name, const Scene<M>& scene, const Setting& setting) {
  const Engine& own = engines::this_course();
  page.claim(
      say("@, this course as advised: largest gap in @ s", name,
          Value(frames_past_lowest(setting.links) * frame, 2)),
      hang<M>(engines::contestant<M>(own, own.settings.joints[1]), scene, frames_past_lowest(setting.links)).gap,
      "m", is_at_most(0.01, "a hundredth of a link: a direct solve leaves the drift of the step alone"),
      where(within(10, Quantity("links", setting.links), 200),
            within(50, Quantity("end mass", setting.end_mass), 300)));
}

/// pinned_tree with the inertia of thin rods: links of 1 kg and about 1 m.
Scene<PlaneBody> tree(int levels) {
  Scene<PlaneBody> scene = pinned_tree<PlaneBody>(levels);
  for (int i = 1; i < scene.bodies().size(); ++i)
    scene.set_mass(i, with_mass<PlaneBody>(1, Angular<PlaneBody>(1.0 / 12)));
  return scene;
}

/// An engine of soft joints: with the substeps alone, and with the joints' hertz as high as they let it be.
template <class M>
void stiffer_by_hertz(Page& page, const std::string& name, const Scene<M>& scene) {
  const auto engine = engine_named(name);
  if (!engine) return;
  const auto gap = [&](int substeps, double hertz) {
    const engines::Setting setting{.knobs = {{"substeps", substeps}, {"joint hertz", hertz}}};
    return hang<M>(engines::contestant<M>(*engine, setting), scene, 60).gap;
  };
  constexpr double shipped = 60, quarter = 15;  // [Hz], a quarter of 60 substeps a second
  std::vector<std::vector<std::string>> rows;
  double first = 0, alone = 0, with = 0;
  for (const int substeps : {4, 8, 16, 32}) {
    alone = gap(substeps, shipped), with = gap(substeps, quarter * substeps);
    if (substeps == 4) first = with;
    rows.push_back({std::to_string(substeps), in_millimetres(alone),
                    say("@ at @ Hz", in_millimetres(with), quarter * substeps)});
  }
  const double power = std::log(with / first) / std::log(32.0 / 4);
  page.text(
      R"(The joints of @ are springs of a given frequency, 60 Hz as shipped, capped at a quarter of the substep rate.
      So from four substeps to 32 more of them alone take off @ of the gap in a second, and the frequency has to be turned up with them. A spring of frequency ω yields by
      F/mω²: the gap after a second should go as 1/hertz², and goes as hertz to the power of @.)",
      name,
      page.verdict({{.when = Quantity("gap with 32 substeps over that with 4", alone / first) > 0.9,
                     .say = "next to nothing"},
                    {.when = Quantity("gap with 32 substeps over that with 4", alone / first) <= 0.9,
                     .say = say("@ %", Value(100 * (1 - alone / first), 2))}}),
      Value(power, 3));
  page.table({"substeps of " + name, "60 Hz, as shipped", "a quarter of the substeps"}, rows);
  page.claim("power of the hertz with which the gap goes, " + name, power, "1",
             is(-2, "a spring yields F/mω²", absolute(0.15)));
}

}  // namespace

void chains(const Setting& setting, Page& page) {
  using M = PlaneBody;
  const int links = setting.links, frames = frames_of(links);
  const double end_mass = setting.end_mass;
  const Scene<M> scene = chain_of<M>(links, end_mass);
  const double swings = frames * frame / (4 * time_down(links));
  page.text(
      R"(A chain of @ pinned links of 1 m and 1 kg, the last of @ kg, is held level and let go. A
      sweep against the order of its rows passes the force that holds the chain on by one link, so from λ = 0 it takes
      a sweep per link, and more with a heavy end (lesson 3); a direct solve or joint coordinates take one pass. On velocities alone a step too long for the pull tears the chain, however exact it is (lesson 8, law 7); a correction
      of positions with new Jacobians can hold it all the same. So it is watched for @ s, @. Runs from nearly
      the same start part in so long a time. So both rows, and what is near the best, are run from @ more starts, let go
      up to @ µrad lower, and tables show the range of these @. The gap is that of the worst pin. A run has
      failed if a pin opens by a whole link, or if the chain gains more than @ % of the energy of a fall through its
      length, which joint coordinates can without a gap: their pins cannot part, and the motion further down compares them. Each engine is given these joints alone: a rope from the
      anchor to the load beside them, which Box2D's manual suggests against stretching, is not tried.)",
      links, end_mass, Value(frames * frame, 2),
      swings < 1.01 ? std::string("a whole swing") : say("@ swings", Value(swings, 2)), ways, ways, ways + 1,
      100 * most_gained);

  const Field<M> field = field_of(scene, Kind::joints);
  const auto exact = exact_places(links, end_mass);
  const auto outcomes = outcomes_of(field, [&](const auto& who) { return hang<M>(who, scene, frames, exact); });
  const auto gaps = gaps_of(field, outcomes, links, end_mass), offs = errors_of(outcomes, &Hung::off);
  const double pull = 3 * end_mass * gravity;
  page.predict(
      {.ask = say(
           R"(The load of @ kg alone, on a weightless rod, is released from horizontal: what is the tension at the
                lowest point?)",
           end_mass),
       .answer = pull,
       .unit = "N",
       .tolerance = 0.03 * pull,
       .wrong = {{end_mass * gravity, "It swings, so the rod also has to turn it upwards."},
                 {2 * end_mass * gravity, "mv²/L is 2mg, and the weight comes on top of it."}},
       .hints = {"Energy gives v² at the lowest point.", "v² = 2gL", "F = mg + mv²/L"},
       .hinted = 3 * end_mass * gravity,
       .right = say("mg + 2mg = @ N. In a chain of many pinned rods law 7 wants T h²/(m l) below a third; at one "
                    "step a frame the load alone makes it @, and the links add to that.",
                    Value(pull, 3), Value(pull * frame * frame, 2))});
  tell_gaps(page, field, outcomes, gaps, scene);
  by_law_7(page, scene, links, end_mass);
  compare(page, "chain_gap",
          say("The chain of @ with @ kg at its end: largest gap of a pin in @ s, from one start.", links, end_mass,
              Value(frames * frame, 2)),
          gaps, "largest gap (m)");
  compare_by_time(page, "chain_clocked", "Gap and time of the same chain.", gaps, [=] {
    return against_time(field, gaps, Timed<M>{scene, timed_frames, {}, "from one start, "}, "largest gap");
  });
  stiffer_by_hertz<M>(page, "Box2D 3", scene);

  page.text(
      R"(A small gap is not yet the right motion. An integration in the links' angles gives the true position of each
      link after @ s, before the load has passed its lowest point. From one start, the worst link is off by:)",
      Value(exact_frames_of(links) * frame, 2));
  tell_three<M>(page, field, offs, Unit::metres);
  compare_by_time(page, "chain_motion_clocked", "How far the worst link is off then, and the time of a frame.",
                  offs, [=] {
                    return against_time(field, offs, Timed<M>{scene, timed_frames}, "off by");
                  });

  page.text(
      "The largest change in energy, up or down, relative to the energy of a fall through the chain's length, "
      "from one start:");
  page.table(head_of_energies(), energies(outcomes, gaps));

  struct Other {
    std::string name;
    std::vector<Scene<M>> starts;
    int frames;
  };
  std::vector<Other> others;
  for (const int length : {10, 200}) {
    if (length == links) continue;
    others.push_back({say("chain of @", length), {}, frames_of(length)});
    for (int way = 0; way <= ways; ++way) others.back().starts.push_back(chain_of<M>(length, end_mass, way));
  }
  others.push_back({"tree of 255", {tree(8)}, 360});
  page.text(
      R"(The same end mass on chains of other lengths, each over its own swing and from as many starts, and a binary
      tree of 255 links of 1 kg without a load, for 6 s and from one start, each engine as its manual advises (–: left out):)");
  std::vector<std::string> head{"largest gap"}, out;
  std::vector<std::vector<std::string>> rows;
  for (std::size_t o = 0; o < others.size(); ++o) {
    const auto& [name, starts, long_enough] = others[o];
    head.push_back(name);
    for (const Engine& engine : members(Party::native))
      if (const std::string why = why_not(engine, starts[0]); !why.empty() && why_not(engine, scene).empty())
        out.push_back(say("@ of the @: it @", engine.name, name, why));
    for (const Entrant<M>& entrant : field_of(starts[0], Kind::joints, From::home, 0).entrants) {
      Spread gap{INFINITY, 0};
      for (const Scene<M>& start : starts) gap.add(hang<M>(entrant.settings[1], start, long_enough).gap);
      auto row = std::find_if(rows.begin(), rows.end(), [&](const auto& r) { return r[0] == entrant.name; });
      if (row == rows.end()) rows.push_back({entrant.name}), row = rows.end() - 1;
      row->resize(o + 1, "–");
      row->push_back(in_words(gap, Unit::metres));
    }
  }
  for (auto& row : rows) row.resize(others.size() + 1, "–");
  page.table(head, rows);
  if (!out.empty()) page.text("Left out besides: @.", listed(out));

  claim_way_down(page, "the chain", scene, setting);
}

void chain_in_space(const Setting& setting, Page& page) {
  using M = SpaceBody;
  const int links = setting.links, frames = frames_of(links);
  const double end_mass = setting.end_mass;
  const Scene<M> scene = chain_of<M>(links, end_mass);
  const Field<M> field = field_of(scene, Kind::joints, From::home, most_in_space);
  const auto outcomes = outcomes_of(field, [&, exact = exact_places(links, end_mass)](const auto& who) {
    return hang<M>(who, scene, frames, exact);
  });
  const auto gaps = gaps_of(field, outcomes, links, end_mass), offs = errors_of(outcomes, &Hung::off);
  page.text(
      R"(The same chain in space: a pin is three rows, and a link has six degrees of freedom instead of three. @)",
      alone() ? ""
              : "Here the engines of space meet this course in space; a pale line shows what the smaller model "
                "saves.");
  tell_gaps(page, field, outcomes, gaps, scene);
  page.text("The largest change in energy, as above:");
  page.table(head_of_energies(), energies(outcomes, gaps));
  compare_by_time(
      page, "space_chain_clocked", "Gap and time of the chain in space. Pale blue: this course in the plane.",
      gaps, [=] {
        Chart chart =
            against_time(field, gaps, Timed<M>{scene, timed_space_frames, {}, "from one start, "}, "largest gap");
        const Scene<PlaneBody> flat = chain_of<PlaneBody>(links, end_mass);
        Field<PlaneBody> own = field_of(flat, Kind::joints);
        own.entrants.resize(1);
        const auto plane = errors_of(
            outcomes_of(own, [&](const auto& who) { return hang<PlaneBody>(who, flat, frames); }), &Hung::gap);
        Curve curve = against_time(own, plane, Timed<PlaneBody>{flat, timed_space_frames}, "").curves.front();
        curve.label += ", in the plane";
        curve.style = CurveStyle::line_and_markers;
        curve.colour = fade(palette::series(0), 0.5);
        chart.curves.push_back(curve);
        return chart;
      });
  page.text("From one start, how far the worst link is off after @ s:", Value(exact_frames_of(links) * frame, 2));
  tell_three<M>(page, field, offs, Unit::metres);
  stiffer_by_hertz<M>(page, "Box3D", scene);
  claim_way_down(page, "the chain in space", scene, setting);
}

namespace {

/// Of an articulation that fails as shipped: both rows with the friction that its joints ship with, which is off
/// here.
template <class M>
void with_friction(Page& page, const std::vector<Outcomes<Hung>>& outcomes, const Scene<M>& scene, int frames) {
  const std::string name = "PhysX articulation";
  const auto shipped = std::ranges::find(outcomes, name, &Outcomes<Hung>::name);
  if (shipped == outcomes.end() || std::isfinite(shipped->by_setting[0].gap)) return;
  const Engine engine = *engine_named(name, Party::webassembly);
  std::string words;
  for (const std::size_t row : {0, 1}) {
    engines::Setting setting = engine.settings.joints[row];
    setting.knobs = {{"joint friction", 0.05}};
    const Hung hung = hang<M>(engines::contestant<M>(engine, setting), scene, frames);
    const std::string as = row_names[row];
    const Quantity gap("the gap with friction", hung.gap);
    words += say(
        "@@", row == 0 ? "" : " ",
        page.verdict(
            {{.when = gap < 1,
              .say = say("With the friction of 0.05 that PhysX ships its joints with it holds @, from one "
                         "start: a gap of @, and the energy changes by @.",
                         as, in_millimetres(hung.gap), in_per_cent(hung.gained))},
             {.when = gap >= 1,
              .say = say("With the friction of 0.05 that PhysX ships its joints with it fails @ as well.", as)}}));
  }
  page.text("@", words);
}

template <class M>
void chain_in_webassembly_of(const Setting& setting, const std::string& place, Page& page) {
  const int links = setting.links, frames = frames_of(links);
  const double end_mass = setting.end_mass;
  const Scene<M> scene = chain_of<M>(links, end_mass);
  const Field<M> field =
      field_of(scene, Kind::joints, From::home, most_of_joints_in_webassembly, Party::webassembly);
  const auto outcomes = outcomes_of(field, [&, exact = exact_places(links, end_mass)](const auto& who) {
    return hang<M>(who, scene, frames, exact);
  });
  const auto gaps = gaps_of(field, outcomes, links, end_mass), offs = errors_of(outcomes, &Hung::off);
  page.text("The chain of step 3 @, its largest gap:", place);
  tell_gaps(page, field, outcomes, gaps, scene);
  with_friction(page, outcomes, scene, frames);
  page.text("From one start, how far its worst link is off after @ s:", Value(exact_frames_of(links) * frame, 2));
  tell_three<M>(page, field, offs, Unit::metres);
  compare_by_time(page, say("webassembly_chain_@", M::linear),
                  say("How far the worst link is off, and the time of a frame, @.", place), offs, [=] {
                    return against_time(field, offs, Timed<M>{scene, timed_space_frames}, "off by");
                  });
  const Engine& own = engines::this_course();
  const double native = hang<M>(engines::contestant<M>(own, own.settings.joints[1]), scene, frames).gap;
  page.claim(say("the chain @, this course as advised in WebAssembly: largest gap", place), gaps.front().advised(),
             "m", is(native, "the same solver in this program", absolute(1e-12)),
             where(within(10, Quantity("links", links), 200), within(50, Quantity("end mass", end_mass), 300)));
}

}  // namespace

void chain_in_webassembly(const Setting& setting, Page& page) {
  chain_in_webassembly_of<PlaneBody>(setting, "in the plane", page);
  chain_in_webassembly_of<SpaceBody>(setting, "in space", page);
}

}  // namespace byhand::beside
