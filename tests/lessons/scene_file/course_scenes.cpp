#include "tests/lessons/scene_file/course_scenes.hpp"

#include "lessons/exact/conical_pendulum.hpp"
#include "lessons/scenes/balls.hpp"
#include "lessons/scenes/box_on_an_arm.hpp"
#include "lessons/scenes/box_on_contacts.hpp"
#include "lessons/scenes/box_pile.hpp"
#include "lessons/scenes/branches.hpp"
#include "lessons/scenes/bridge.hpp"
#include "lessons/scenes/card_house.hpp"
#include "lessons/scenes/chain.hpp"
#include "lessons/scenes/circle.hpp"
#include "lessons/scenes/dominoes.hpp"
#include "lessons/scenes/four_bar.hpp"
#include "lessons/scenes/incline.hpp"
#include "lessons/scenes/ragdoll.hpp"
#include "lessons/scenes/slack_chain.hpp"
#include "lessons/scenes/slider_crank.hpp"
#include "lessons/scenes/spherical_pendulum.hpp"
#include "lessons/scenes/top.hpp"
#include "lessons/scenes/units.hpp"

namespace byhand::test {
namespace {

constexpr double right_angle = radians(90);

HeavyTop top_of_the_chooser() {
  HeavyTop top;
  top.mass = 1;
  top.arm = 0.2;
  const double radius = 0.25;
  top.moment_along = top.mass * radius * radius / 2;
  top.moment_across = top.mass * (radius * radius / 4 + top.arm * top.arm);
  top.spin = 30;
  top.gravity = 9.81;
  return top;
}

}  // namespace

const std::vector<CourseScene>& course_scenes() {
  static const std::vector<CourseScene> all{
      // The chooser's, at the first values of their parameters.
      {"pendulum", "Simple pendulum", "A bob on a massless rod, let go from level.",
       [] { return SceneOfAnyModel(pendulum<PlaneParticle, NormalisedDistance>(right_angle, 1, 1)); }, 10},
      {"compound_pendulum", "Compound pendulum", "A uniform rod on a hinge, let go from level.",
       [] { return SceneOfAnyModel(hinged_rod<PlaneBody>(right_angle, 1, 1)); }, 10},
      {"double_pendulum", "Double pendulum", "Two bobs, let go from level: after some seconds chaos.",
       [] {
         return SceneOfAnyModel(rod_chain<PlaneParticle, NormalisedDistance>({2, 1, 1, 1, right_angle}));
       }},
      {"chain", "Chain of 50 links", "Links of 1 kg and 1 m, let go from level.",
       [] {
         return SceneOfAnyModel(pinned_chain<PlaneBody>({50, 1, 1, 1, right_angle}));
       }},
      {"four_bar", "Four-bar linkage", "A parallelogram of rods that swings as a simple pendulum does.",
       [] {
         return SceneOfAnyModel(four_bar({1, 2, 1, 1, radians(60)}));
       }},
      {"spherical_pendulum", "Spherical pendulum", "A bob that goes round the vertical and nods.",
       [] { return SceneOfAnyModel(spherical_pendulum<SpaceParticle>(radians(60), 2, 1, 1)); }},
      {"conical_pendulum", "Conical pendulum", "A bob that goes round the vertical at one height.",
       [] {
         const ConicalPendulum exact(radians(60), 1, 9.81);
         return SceneOfAnyModel(spherical_pendulum<SpaceParticle>(radians(60), exact.angular_velocity(), 1, 1));
       }},
      {"top", "Spinning top", "A disc on a stick that precesses at one lean.",
       [] {
         const HeavyTop top = top_of_the_chooser();
         return SceneOfAnyModel(spinning_top(top, radians(30), top.precession(radians(30))[0]));
       }},
      {"stack", "Stack of ten boxes", "Unit boxes of 1 kg, one upon the other.",
       [] {
         Scene<PlaneBody> scene = stack(10);
         kick(scene, 0);
         return SceneOfAnyModel(scene);
       },
       30},
      {"pyramid", "Pyramid of boxes", "A wall that narrows by half a box on either side: 55 boxes.",
       [] {
         Scene<PlaneBody> scene = pyramid(10);
         kick(scene, 0);
         return SceneOfAnyModel(scene);
       },
       30},
      {"incline", "Block on an incline", "It slides down 20° with μ = 0.5, and stops.",
       [] {
         return SceneOfAnyModel(box_on_incline(radians(20), 0.5, 2, {1, 0.2}, 1));
       },
       2},

      // Others of the lessons.
      {"circle", "A particle on a circle", "Without gravity, at 3 m/s: its rod shows how drift grows.",
       [] { return SceneOfAnyModel(particle_on_a_circle<PlaneParticle>(1, 3, 1)); }},
      {"article_pendulum", "The article's rod", "The pendulum with C = ½(d² − L²), equation (2).",
       [] { return SceneOfAnyModel(pendulum<PlaneParticle, Distance>(right_angle, 1, 1)); }},
      {"pendulum_in_space", "Compound pendulum in space", "A uniform rod on a ball joint.",
       [] { return SceneOfAnyModel(hinged_rod<SpaceBody>(right_angle, 1, 1)); }},
      {"chain_in_space", "Chain in space", "Ten links on ball joints.",
       [] {
         return SceneOfAnyModel(pinned_chain<SpaceBody>({10, 1, 1, 1, right_angle}));
       }},
      {"heavy_chain", "A heavy end", "Ten links of 1 kg that carry 100 kg.",
       [] {
         return SceneOfAnyModel(pinned_chain<PlaneBody>({10, 1, 1, 100, right_angle}));
       }},
      {"slack_chain", "A slack chain", "Bobs between two anchors, let go as a V.",
       [] { return SceneOfAnyModel(slack_chain<PlaneParticle>(16, 2, 1)); }},
      {"box_on_an_arm", "A box on an arm", "So little inertia on so long an arm couples the rows of its pin.",
       [] { return SceneOfAnyModel(box_on_an_arm(0.1, 1, right_angle)); }},
      {"box_on_contacts", "A box on four contacts", "More contacts than it takes to hold it.",
       [] { return SceneOfAnyModel(box_on_contacts(4)); }},
      {"bridge", "Hanging bridge", "Ten planks pinned between two anchors.",
       [] { return SceneOfAnyModel(bridge({})); }},
      {"tree", "A tree of links", "Fifteen links, each with two below it.",
       [] { return SceneOfAnyModel(pinned_tree<PlaneBody>(4)); }},
      {"star", "A star of links", "Twelve arms on one free hub.",
       [] { return SceneOfAnyModel(pinned_star<PlaneBody>(12)); }, 1},
      {"slider_crank", "Slider and crank", "A motor turns a crank, which moves a piston.",
       [] { return SceneOfAnyModel(slider_crank({})); }},
      {"three_arms", "Three arms", "A four-bar linkage with a third arm, which repeats what two say.",
       [] {
         return SceneOfAnyModel(four_bar({1, 2, 1, 1, radians(60), 3}));
       }},
      {"bouncing_ball", "Bouncing ball", "Dropped from 1 m with e = 0.8.",
       [] { return SceneOfAnyModel(bouncing_ball<PlaneBody>(1, 0.8)); }},
      {"cradle", "Newton's cradle", "Five balls without their strings; the first comes at 1 m/s.",
       [] { return SceneOfAnyModel(newtons_cradle<PlaneBody>(5)); }, 1},
      {"dominoes", "Dominoes", "Ten, of which the first is tipped.",
       [] { return SceneOfAnyModel(dominoes(10, 0.5, 1.5)); }},
      {"card_house", "House of cards", "Three storeys; friction alone holds them.",
       [] { return SceneOfAnyModel(card_house(3)); }},
      {"heavy_on_light", "Heavy on light", "A box of 1000 kg on one of 1 kg.",
       [] { return SceneOfAnyModel(stack(2, 1000)); }},
      {"heavy_on_light_in_space", "Heavy on light in space", "A cube of 1000 kg on one of 1 kg.",
       [] { return SceneOfAnyModel(stack<SpaceBody>(2, 1000)); }},
      {"pile", "A random pile", "Ten balls and boxes, dropped where they come.",
       [] { return SceneOfAnyModel(box_pile<PlaneBody>(7)); }},
      {"pile_in_space", "A random pile in space", "Ten balls and boxes, dropped where they come.",
       [] { return SceneOfAnyModel(box_pile<SpaceBody>(7)); }},
      {"incline_in_space", "Block on an incline in space", "It slides down 20° with μ = 0.3.",
       [] { return SceneOfAnyModel(box_on_incline<SpaceBody>(radians(20), 0.3)); }, 2},
      {"ragdoll", "A ragdoll", "Ten boxes, nine pins, two limits for each; it falls on the ground.",
       [] {
         Scene<PlaneBody> scene;
         add_ground(scene);
         add_ragdoll(scene, {0, 2});
         return SceneOfAnyModel(scene);
       }},
      {"cover_chain",
       "The cover's chain",
       "Ten bobs of 3 kg on rods of 2 m, let go at 20°; each step ends after ten sweeps.",
       [] {
         return SceneOfAnyModel(rod_chain<PlaneParticle>({10, 2, 3, 3, radians(20)}));
       },
       10,
       {GaussSeidel{.sweeps = 10, .warm_start = false}, Baumgarte{}}},
      {"thrown_book", "A thrown book", "It turns about its middle axis, and flips.",
       [] {
         return SceneOfAnyModel(free_top({1, 2, 3}, {0.01, 10, 0}));
       }},
  };
  return all;
}

}  // namespace byhand::test
