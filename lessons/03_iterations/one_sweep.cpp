// Step 2: a chain and one sweep, row by row.

#include "lessons/03_iterations/held_step.hpp"
#include "lessons/03_iterations/knobs.hpp"

namespace byhand::iterations {
namespace {

struct Instant {
  std::string title;
  int solved = -1;  // the joint whose row was just solved
  std::vector<double> shares, errors, speeds;
};

/// Two sweeps row by row, then whole sweeps in growing strides until the error is a thousandth.
std::vector<Instant> instants(const ChainOptions& chain, double h, double fall) {
  HeldStep step(chain, h);
  std::vector<Instant> all;
  const auto keep = [&](std::string title, int solved) {
    all.push_back({std::move(title), solved, step.shares(), step.errors(), step.speeds()});
    for (double& error : all.back().errors) error /= fall;
    for (double& speed : all.back().speeds) speed /= fall;
  };
  keep("gravity is in V, nothing is solved", -1);
  int sweeps = 0;
  for (; sweeps < 2; ++sweeps)
    for (int row = 0; row < chain.links; ++row) {
      step.solve_row();
      keep(say("sweep @, row @", sweeps + 1, row + 1), row);
    }
  while (step.error() > 1e-3 * fall) {
    for (const int until = std::max(sweeps + 1, sweeps * 9 / 8); sweeps < until; ++sweeps) step.solve_sweep();
    keep(say("after @ sweeps", sweeps), -1);
  }
  return all;
}

std::vector<std::string> joint_names(int links) {
  std::vector<std::string> names;
  for (int joint = 1; joint <= links; ++joint)
    names.push_back(links <= 20 || joint % 5 == 0 ? std::to_string(joint) : "");
  return names;
}

renderer::Chart bars_of(const std::vector<double>& values, std::string label, renderer::Colour colour) {
  renderer::Chart chart;
  chart.x.label = "joint, from the top";
  chart.y.label = std::move(label);
  chart.y.range = {{0, 1.05}};
  chart.bar_names = joint_names(static_cast<int>(values.size()));
  chart.bars.push_back({.values = values, .colour = colour});
  return chart;
}

/// The weight below each joint, as a share of the whole.
renderer::Curve right_shares(int links) {
  renderer::Curve curve{.style = renderer::CurveStyle::theory};
  for (int joint = 0; joint < links; ++joint) {
    curve.x.push_back(joint);
    curve.y.push_back(1.0 - static_cast<double>(joint) / links);
  }
  return curve;
}

void draw_chain(renderer::Canvas& canvas, const pictures::Linkage& linkage, const Instant& now,
                const renderer::Rectangle& frame) {
  const int links = static_cast<int>(linkage.rods.size());
  const double reach = -linkage.bobs.back().at.y(), pitch = reach / links;
  const renderer::Camera camera =
      renderer::fit({-0.1 * reach, -reach - 0.8 * pitch, 0.2 * reach, reach + 1.2 * pitch}, frame, 8);
  const double spacing = pitch * camera.scale;
  canvas.look(camera);
  pictures::draw(canvas, linkage, {.bob = std::min(15.0, 0.22 * spacing), .rod = std::min(5.0, 0.1 * spacing)});
  canvas.look_at_page();
  for (int i = 0; i < links; ++i) {
    const Point bob = camera.to_page(linkage.bobs[i].at), above = camera.to_page(linkage.rods[i].from);
    if (i == now.solved)
      canvas.rod(above - Point(0, 0.25 * spacing), bob + Point(0, 0.25 * spacing),
                 {palette::highlight, {palette::ink, 1.2}}, 0.16 * spacing);
    canvas.vector(bob + Point(28, 0.3 * spacing), {0, -now.speeds[i]}, {palette::velocity, 0.6 * spacing});
    if (links <= 20)
      canvas.text(Point(above.x() - 16, (above.y() + bob.y()) / 2), std::to_string(i + 1),
                  {.size = 16, .colour = palette::muted, .anchor = renderer::Anchor::right});
  }
}

void draw_instant(renderer::Canvas& canvas, const pictures::Linkage& linkage, const Instant& now) {
  auto [left, right] = canvas.page().inset(18).split_columns(0.24, 16);
  canvas.text({left.x + 6, left.top() - 14}, now.title,
              {.size = 25, .anchor = renderer::Anchor::left, .bold = true});
  left.height -= 40;
  right.height -= 40;
  draw_chain(canvas, linkage, now, left);
  const auto [upper, lower] = right.split_rows(0.5, 14);
  renderer::Chart carried = bars_of(now.shares, "carried (share of all weight)", palette::force);
  carried.curves.push_back(right_shares(static_cast<int>(now.shares.size())));
  draw(canvas, carried, upper);
  draw(canvas, bars_of(now.errors, "error: stretching (gh)", palette::error), lower);
}

}  // namespace

void one_sweep(Page& page, const Knobs& knobs) {
  const ChainOptions chain = knobs.chain();
  const double fall = knobs.fall();
  const auto top_after_one = [&](SweepOrder order) {
    HeldStep step(chain, knobs.h, GaussSeidel{.warm_start = false, .order = order});
    step.solve_sweep();
    return step.shares().front();
  };
  HeldStep first(chain, knobs.h);
  first.solve_sweep();
  const std::vector<double> shares = first.shares();
  const double right = 1.0;

  page.text(
      R"(Now @ links, each with a bob of @ kg: @ N in all. The top joint must carry the whole weight, and each joint below
      it one bob less: the dashed line in the pictures. λ is in N·s/m as in lesson 2, so the force of a joint is
      −λL/h.)",
      knobs.links, knobs.mass, knobs.weight());
  page.predict(
      {.ask = say(R"(λ is zero everywhere. One sweep from top to bottom solves each of the @ rows once. What share
                  of the weight does the top joint carry then?)",
                  knobs.links),
       .answer = shares.front(),
       .unit = "1",
       .tolerance = 0.2 / knobs.links(),
       .wrong = {{right,
                  "When row 1 is solved, only its own bob pulls on it: the rows below have not acted yet."}},
       .hints = {"When row 1 is solved, what has happened to the bobs below it so far?",
                 "Row 1 stops its own bob: λL = −m·gh. The whole weight times h is N·m·gh.",
                 say("m·gh / (@·m·gh) = …", knobs.links)},
       .hinted = 1.0 / knobs.links(),
       .right = say("One bob out of @: row 1 was solved first, when no other row had pulled on its bob.",
                    knobs.links)});

  const auto linkage = pictures::rods_and_bobs(first.scene());
  const auto frames = instants(chain, knobs.h, fall);
  page.sequence(
      "row_by_row",
      say(R"(Two sweeps row by row, then whole sweeps in growing strides. Arrows: how fast each bob still falls.
          Upper bars: what each joint carries, as a share of all @ N (dashed: the weight below it). Lower bars: each row's
          error. Yellow: the row being solved.)",
          knobs.weight()),
      Frames{static_cast<int>(frames.size())}, [=](renderer::Canvas& canvas, double at) {
        draw_instant(canvas, linkage, frames[static_cast<std::size_t>(at)]);
      });
  page.text(
      R"(After the first sweep the @joints carry the shares @ of the weight. Each row splits its error between two equal
      bobs, so it passes *half* of it on to the next: gh, then gh/2, and so on. A sweep from bottom to top gives the
      top joint the same share: every row but the top one finds its two bobs falling together, without an error.)",
      knobs.links() <= 4 ? "" : "upper ",
      std::vector<double>(shares.begin(), shares.begin() + std::min(4, knobs.links())));
  page.claim("share at the top joint, from top to bottom", shares.front(), "1",
             is(1.0 / knobs.links(), "its own bob's weight", relative(1e-12)));
  page.claim("the same from bottom to top", top_after_one(SweepOrder::reverse), "1",
             is(1.0 / knobs.links(), "its own bob's weight", relative(1e-12)));
  page.claim("the same in red–black order", top_after_one(SweepOrder::coloured), "1",
             is(1.0 / knobs.links(), "its own bob's weight", relative(1e-12)));
  page.claim("share at the lowest joint, from top to bottom", shares.back(), "1",
             is(std::pow(0.5, knobs.links() - 1) / knobs.links(), "halved at each joint", absolute(1e-15)));
}

}  // namespace byhand::iterations
