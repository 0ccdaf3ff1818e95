#include "lessons/01_jacobian/picture.hpp"
#include "lessons/scenes/pendulum.hpp"
#include "solver/constraints/pin.hpp"

// Many rows, nearly all of their entries zero.
namespace byhand::lesson01 {
namespace {

/// Links pinned end to end, the first one to the world, which is body 0; pin i joins bodies i and i + 1.
struct Chain {
  std::vector<Pose<PlaneBody>> poses;
  std::vector<Pin<PlaneBody>> pins;

  int links() const { return int(pins.size()); }
  Jacobian<PlaneBody, 2> rows(const Pin<PlaneBody>& pin) const {
    return pin.jacobian(poses[std::size_t(pin.at.body1)], poses[std::size_t(pin.at.body2)]);
  }
};

Chain chain_of(const Settings& set) {
  constexpr double angle = 0.9;  // from straight down [rad]
  const Arm<PlaneBody> upper_end(0, set.length / 2), centre(0, 0);
  Chain chain;
  chain.poses.emplace_back();
  for (int i = 0; i < set.links; ++i) {
    chain.poses.push_back({(i + 0.5) * set.length * from_straight_down<PlaneBody>(angle), plane_rotation(angle)});
    chain.pins.push_back({{i, i + 1, {i > 0 ? Arm<PlaneBody>(-upper_end) : centre, upper_end}}});
  }
  return chain;
}

/// J of the whole chain: two rows a pin, three columns a link (the world has none: nothing moves it).
Eigen::MatrixXd whole(const Chain& chain) {
  Eigen::MatrixXd J = Eigen::MatrixXd::Zero(2 * chain.links(), 3 * chain.links());
  int row = 0;
  for (const Pin<PlaneBody>& pin : chain.pins) {
    const auto part = chain.rows(pin);
    if (pin.at.body1 > 0) J.block<2, 3>(row, 3 * (pin.at.body1 - 1)) = part.side1();
    J.block<2, 3>(row, 3 * (pin.at.body2 - 1)) = part.side2();
    row += 2;
  }
  return J;
}

/// A pin's row takes one component of v and, with it, one ω of each of its two links: 2 · 2 entries that are not
/// zero for the first pin, which has one link, and 2 · 4 for every further one.
double share_of_zeros(int links) { return 1 - (8.0 * links - 4) / (2.0 * links * 3 * links); }

renderer::Chart picture_of(const Eigen::MatrixXd& J) {
  renderer::HeatMap map{.label = "entry of J (1, m)", .diverging = true, .square = true};
  for (int column = 0; column < J.cols(); ++column) map.x.push_back(column + 1);
  for (int row = 0; row < J.rows(); ++row) map.y.push_back(row + 1);
  for (int row = 0; row < J.rows(); ++row)
    for (int column = 0; column < J.cols(); ++column) {
      const double entry = J(row, column);
      map.values.push_back(entry == 0 ? std::nan("") : entry);
    }
  return {.x = {.label = "velocity: v_x, v_y, ω of link 1, 2, …"},
          .y = {.label = "row: two for each pin", .reversed = true},
          .heat_map = map};
}

pictures::Linkage shown(const Chain& chain) {
  pictures::Linkage linkage;
  for (const Pin<PlaneBody>& pin : chain.pins) {
    const Pose<PlaneBody>& link = chain.poses[std::size_t(pin.at.body2)];
    const renderer::Point upper_end(link.position + in_world<PlaneBody, double>(link, pin.at.arms.second));
    linkage.links.push_back({upper_end, 2 * link.position - upper_end});
    (pin.at.body1 == 0 ? linkage.anchors : linkage.hinges).push_back(upper_end);
  }
  return linkage;
}

/// The chain with one pin marked, beside the matrix with that pin's two rows framed where its links' columns are.
void draw_pin_and_rows(renderer::Canvas& canvas, const Chain& chain, const Eigen::MatrixXd& J, int pin) {
  const auto [left, right] = canvas.page().inset(16).panels(0.42, 20);
  const auto linkage = shown(chain);
  std::vector<renderer::Point> corners{{0, 0}};
  for (const auto& link : linkage.links) corners.push_back(link.to);
  canvas.look(renderer::fit(renderer::bounds(corners), left, 60));
  pictures::draw(canvas, linkage);
  const renderer::Point joint = linkage.links[std::size_t(pin)].from;
  canvas.disc(joint, 18 / canvas.camera().scale, {renderer::fade(palette::force, 0), {palette::force, 3.5}});
  canvas.text(joint, course::say("pin @", pin + 1),
              {.size = 20, .colour = palette::force, .anchor = renderer::Anchor::bottom_left, .offset = {16, 14}});
  const renderer::Rectangle plot = renderer::draw(canvas, picture_of(J), right);
  const double cell = plot.width / double(J.cols());
  const int first = 3 * std::max(pin - 1, 0), columns = 3 * (pin > 0 ? 2 : 1);
  canvas.look_at_page();
  canvas.rectangle({plot.x + first * cell, plot.top() - (2 * pin + 2) * cell, columns * cell, 2 * cell},
                   {renderer::fade(palette::force, 0), {palette::force, 3.5}});
}

/// How many entries of a row are stored.
template <class Model>
constexpr int stored = decltype(Jacobian<Model, 1>::matrix)::ColsAtCompileTime;

}  // namespace

void linkage(course::Page& page, const Settings& set) {
  page.text(
      R"(How many numbers are in a row? An l and an a for each of two bodies. In the plane a body turns in one way only,
      so a is *one* number and a row has (2 + 1)·2 = @. In space it has (3 + 3)·2 = @. A row between two particles needs @
      in the plane and @ in space. The solver stores no more than that, and (8) reads:)",
      stored<PlaneBody>, stored<SpaceBody>, stored<PlaneParticle>, stored<SpaceParticle>);
  page.excerpt("solver/jacobian.hpp", "8");
  page.text(
      R"(*The article's "two scalar values in 2D" is true of l alone: there a is one number. In 3D its "three" holds for
      both.*)");

  const Chain chain = chain_of(set);
  const Eigen::MatrixXd J = whole(chain);
  const int links = set.links;
  const double zeros = double((J.array() == 0).count()) / double(J.size());
  page.text(
      R"(Now hang up a chain of @ links: @ pins, one of them to a fixed point. A pin is two constraints, so there are @
      rows, and the bodies together have @ components of velocity: a matrix of @ numbers.)",
      links, J.rows() / 2, J.rows(), J.cols(), J.size());
  const int chosen = links / 2;
  page.figure(
      "linkage",
      course::say(R"(The chain and its J: pin @ joins two links, and its two rows are zero (empty) outside the
                         columns of these two.)",
                  chosen + 1),
      [=](renderer::Canvas& canvas) { draw_pin_and_rows(canvas, chain, J, chosen); });

  page.text(
      R"(@ % of the entries are zero, and @ % for a chain twice as long. So the solver does not build this
      matrix: it keeps the rows, each with the numbers of its own two bodies, and (8) skips the rest.)",
      course::Value(100 * zeros, 3), course::Value(100 * share_of_zeros(2 * links), 3));

  Eigen::VectorXd V = Eigen::VectorXd::Zero(J.cols());
  for (int i = 0; i < V.size(); ++i) V[i] = double((37 * i + 11) % 23) / 23 - 0.5;  // anything at all
  const Eigen::VectorXd by_matrix = J * V;
  double difference = 0;
  for (int i = 0; i < links; ++i) {
    const Velocity<PlaneBody> V1 =
        i > 0 ? Velocity<PlaneBody>(V.segment<3>(3 * (i - 1))) : Velocity<PlaneBody>::Zero();
    const Velocity<PlaneBody> V2 = V.segment<3>(3 * i);
    const auto row = chain.rows(chain.pins[std::size_t(i)]);
    difference = std::max(difference, (dot(row, V1, V2) - by_matrix.segment<2>(2 * i)).cwiseAbs().maxCoeff());
  }
  const auto claim_numbers = [&](const char* model, int expected, int measured) {
    page.claim(course::say("numbers in a row, @", model), double(measured), "1",
               is(double(expected), "(7): l and a of two bodies", course::absolute(0)));
  };
  claim_numbers("bodies in the plane", 2 * (2 + 1), stored<PlaneBody>);
  claim_numbers("bodies in space", 2 * (3 + 3), stored<SpaceBody>);
  page.claim("share of zeros in J of the chain", zeros, "1",
             is(share_of_zeros(links), "counted by pins: 4 entries for the first, 8 for every further one",
                course::absolute(1e-12)));
  page.claim("JV by (8) against the whole matrix, largest difference", difference, "m/s",
             is(1e-14 * (1 + set.length), "zeros add nothing", course::at_most()));
}

}  // namespace byhand::lesson01
