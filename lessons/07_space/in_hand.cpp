// What a reader holds: the book of step 6, and the gyroscope.

#include "lessons/07_space/gyroscope.hpp"
#include "lessons/07_space/steps.hpp"
#include "lessons/07_space/thrown.hpp"
#include "lessons/pictures/faces.hpp"
#include "lessons/pictures/held_scene.hpp"
#include "lessons/scenes/top.hpp"
#include "solver/measure.hpp"

namespace byhand::space {
namespace {

const pictures::Seen<SpaceBody>& view() {
  static const auto seen = pictures::seen_from_aside(0.5, 0.35);
  return seen;
}

void add_arrow(Canvas& canvas, const Eigen::Vector3d& from, const Eigen::Vector3d& by, const char* name,
               Colour colour) {
  const Point begin = view() * from, end = view() * (from + by);
  if (canvas.camera().scale * (end - begin).norm() < 4) return;
  canvas.arrow(begin, end, {colour, 6});
  canvas.text(end, name, {.size = 30, .colour = colour, .halo = 5, .offset = 24 * (end - begin).normalized()});
}

/// The book on a ball joint in its middle, which carries its weight and leaves every turn free.
Simulation<SpaceBody> book_on_its_middle(const Setting& setting) {
  Scene<SpaceBody> scene;
  const int ground = scene.add_body(Linear<SpaceBody>(0, 0, 0), fixed<SpaceBody>());
  Velocity<SpaceBody> V = Velocity<SpaceBody>::Zero();
  V.tail<3>() = first_spin(setting, setting.wobble);
  const int book = scene.add_body(Linear<SpaceBody>(0, 0, 0), box<SpaceBody>(setting.mass, book_sides()), V);
  scene.set_shape(book, Box<SpaceBody>{book_sides()});
  scene.add(pin<SpaceBody>(scene.bodies(), ground, book, Linear<SpaceBody>(0, 0, 0)));
  Simulation<SpaceBody> simulation{std::move(scene), {Direct{}, Baumgarte{0.2}}};
  simulation.method.gyroscopic = Gyroscopic::implicit;
  return simulation;
}

void draw_book(Canvas& canvas, const Scene<SpaceBody>& scene, double momentum_at_first) {
  const Bodies<SpaceBody>& bodies = scene.bodies();
  pictures::Faces faces(view());
  pictures::add_book(faces, bodies.pose[1], book_sides());
  pictures::draw(canvas, faces);
  const Eigen::Vector3d momentum = angular_momentum(bodies);
  add_arrow(canvas, {0, 0, 0}, momentum / momentum_at_first, "Iω", palette::error);
}

std::string of_the_book(const Simulation<SpaceBody>& book) {
  const Pose<SpaceBody>& pose = book.scene.bodies().pose[1];
  const Eigen::Vector3d spin =
      rotate(inverse(pose.rotation), Linear<SpaceBody>(book.scene.bodies().velocity[1].tail<3>()));
  return say("Spin about the book's own x, y, z: @, @, @ rad/s; |Iω| = @ kg m²/s.", Value(spin.x(), 3),
             Value(spin.y(), 3), Value(spin.z(), 3), Value(angular_momentum(book.scene.bodies()).norm(), 4));
}

void draw_gyroscope(Canvas& canvas, const Scene<SpaceBody>& scene) {
  const Pose<SpaceBody>& pose = scene.bodies().pose[1];
  const Eigen::Vector3d own(0, 1, 0), axis = rotate(pose.rotation, own);
  const double rim = 0.03;  // half the wheel's thickness [m]
  pictures::Faces faces(view());
  faces.cylinder({}, {0, -0.6, 0}, {0, -0.02, 0}, 0.02, palette::fixed);
  faces.cylinder(pose, -arm * own, -rim * own, 0.012, palette::fixed);
  faces.cylinder(pose, rim * own, 0.15 * arm * own + rim * own, 0.012, palette::fixed);
  faces.cylinder(pose, -rim * own, rim * own, wheel, palette::body);
  pictures::draw(canvas, faces);
  // A spoke on the side that is seen shows the spin.
  const Eigen::Vector3d towards = Eigen::Vector3d(view().row(0)).cross(Eigen::Vector3d(view().row(1)));
  const Eigen::Vector3d face = pose.position + (axis.dot(towards) > 0 ? rim : -rim) * axis,
                        out = rotate(pose.rotation, Linear<SpaceBody>(wheel, 0, 0));
  canvas.line(view() * face, view() * (face + out), {palette::constraint, 5});
  add_arrow(canvas, pose.position, 0.35 * axis, "Iω", palette::error);
}

std::string of_the_gyroscope(const Simulation<SpaceBody>& top) {
  const Pose<SpaceBody>& pose = top.scene.bodies().pose[1];
  const Eigen::Vector3d axis = rotate(pose.rotation, Linear<SpaceBody>(0, 1, 0)),
                        omega = top.scene.bodies().velocity[1].tail<3>();
  const double above = without_rounding(degrees(std::asin(std::clamp(axis.y(), -1.0, 1.0))), 90);
  return say("The axle points @° @ the level; the wheel spins at @ rad/s.", Value(std::abs(above), 2),
             above < 0 ? "below" : "above", Value(omega.dot(axis), 3));
}

}  // namespace

course::Hold book_in_hand(const Setting& setting) {
  return {
      "book_in_hand",
      R"(The book turns about its middle, where a ball joint carries its weight. Pull it by an edge, stop it, let it
          go. The yellow end shows which way up it is; the arrow is Iω, which only the hand can change.)",
      [setting] {
        const double momentum = moments_of(setting).cwiseProduct(first_spin(setting, setting.wobble)).norm();
        return pictures::in_hand<SpaceBody>({.start = book_on_its_middle(setting),
                                             .h = setting.h(),
                                             .view = {-1.1, -1.1, 2.2, 2.2},
                                             .body = "book",
                                             .law = "Pull more gently.",
                                             .says = of_the_book,
                                             .seen = view(),
                                             .draw = [momentum](Canvas& canvas, const Scene<SpaceBody>& scene) {
                                               draw_book(canvas, scene, momentum);
                                             }});
      }};
}

course::Hold gyroscope_in_hand(const Setting& setting) {
  return {
      "gyroscope_in_hand",
      R"(The wheel on its axle, released level without a push: it nods and goes round. Pull the wheel down, and it
          goes sideways.)",
      [setting] {
        Simulation<SpaceBody> top{spinning_top(gyroscope_of(setting.mass), level, 0), {Direct{}, Baumgarte{0.2}}};
        top.method.gyroscopic = Gyroscopic::implicit;
        return pictures::in_hand<SpaceBody>({.start = std::move(top),
                                             .h = setting.h / 2,
                                             .view = {-0.75, -0.75, 1.5, 1.35},
                                             .body = "wheel",
                                             .law = "Pull more gently.",
                                             .says = of_the_gyroscope,
                                             .reach = wheel,
                                             .seen = view(),
                                             .draw = draw_gyroscope});
      }};
}

}  // namespace byhand::space
