#include "lessons/05_contact/hanging_cradle.hpp"

#include "lessons/pictures/boxes.hpp"

namespace byhand::contact {
namespace {

constexpr double rod_length = 1, bob_radius = 0.12,
                 first_angle = 0.6;  // of a rod, of a ball [m]; of the first rod [rad]

}  // namespace

HangingCradle::HangingCradle(int balls, double air, double h) : h_(h) {
  auto& scene = simulation_.scene;
  scene.set_contact_rows(ContactRows::points);
  for (int i = 0; i < balls; ++i) {
    const Linear<PlaneBody> hook((2 * bob_radius + air) * i, 0);
    const auto [sin, cos] = sin_cos(i == 0 ? -first_angle : 0.0);
    const int world = scene.add_body(hook, fixed<PlaneBody>());
    const int body = scene.add_body(Linear<PlaneBody>(hook + rod_length * Linear<PlaneBody>(sin, -cos)),
                                    byhand::ball<PlaneBody>(1, bob_radius));
    scene.set_shape(body, Ball<PlaneBody>{bob_radius}, {0, 1});
    scene.add(NormalisedDistance<PlaneBody>{{world, body}, rod_length});
  }
  simulation_.method = {.solver = Direct{}, .bounce_threshold = 0.05};
}

void HangingCradle::advance(double time) {
  while (simulation_.time < time - 0.5 * h_) simulation_.step(h_);
}

void HangingCradle::draw(renderer::Canvas& canvas, const renderer::Rectangle& frame,
                         const std::string& name) const {
  using renderer::Point;
  const auto& pose = simulation_.scene.bodies().pose;
  const double right = pose[pose.size() - 2].position.x();
  canvas.clip(frame);
  canvas.look(renderer::fit({-0.9, -1.2, right + 1.8, 1.28}, frame, 4));
  canvas.line({-0.2, 0}, {right + 0.2, 0}, {renderer::palette::ink, 4});
  for (std::size_t i = 0; i < pose.size(); i += 2)
    canvas.rod(pose[i].position, pose[i + 1].position,
               {renderer::palette::constraint, {renderer::palette::ink, 0}}, 3);
  pictures::draw(canvas, pictures::shapes_of(simulation_.scene));
  canvas.clip({});
  canvas.look_at_page();
  canvas.text({frame.x + 10, frame.top() - 20}, name,
              {.size = 22, .anchor = renderer::Anchor::left, .bold = true});
}

}  // namespace byhand::contact
