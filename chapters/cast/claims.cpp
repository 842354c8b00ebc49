// SPDX-License-Identifier: MIT-0
// The page of the cast says what the scenes do.
#include <algorithm>
#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <cmath>

#include "../cast_of_many.h"
#include "../play/drone.h"
#include "../play/hatch.h"
#include "../play/jumper.h"
#include "measure/methods.h"
#include "measure/run.h"

using Catch::Matchers::WithinAbs;
using Catch::Matchers::WithinRel;
using measure::rk4;

namespace {

/// The nearest and the farthest that an orbit comes to its centre, by short steps [m].
struct Reach {
  double nearest = INFINITY, farthest = 0;
};

template <class Scene>
Reach reach(const Scene& scene, double duration) {
  Reach found;
  auto s = scene.start();
  measure::run(rk4, scene, s, duration / 100'000, 100'000, [&](double, const auto& now) {
    found.nearest = std::min(found.nearest, now.x.norm());
    found.farthest = std::max(found.farthest, now.x.norm());
  });
  return found;
}

/// How often a spring passes its place of rest in a second; twice in a swing.
int passes(const scenes::Spring<>& spring) {
  int count = 0;
  auto s = spring.start();
  double before = s.x;
  measure::run(rk4, spring, s, 1e-5, 100'000, [&](double, const auto& now) {
    count += now.x * before < 0;
    before = now.x;
  });
  return count;
}

}  // namespace

TEST_CASE("Everybody who jumps is back on the ground after a second") {
  for (const auto& one : {jump, running_jump}) {
    CHECK_THAT(measure::after(rk4, one, one.start(), 0.001, 1020).x.y(), WithinAbs(0, 0.01));
  }
}

TEST_CASE("The leaf has its last speed, to a fiftieth, after two seconds") {
  const auto end = measure::after(rk4, leaf, leaf.start(), 0.001, 2000);
  CHECK_THAT(-end.v, WithinRel(leaf.g / leaf.c, 0.02));
  CHECK(-end.v < 0.99 * leaf.g / leaf.c);
}

TEST_CASE("The parachute brakes its diver to 6.3 metres a second in half a second") {
  const auto end = measure::after(rk4, parachute, scenes::State<double>{0, diving}, 0.0001, 5000);
  CHECK_THAT(end.v, WithinAbs(-6.3, 0.05));
}

TEST_CASE("The suspension swings three times a second, and the bar 95 times") {
  CHECK(passes(suspension) == 6);
  CHECK(passes(undamped_suspension) == 6);
  CHECK(passes(bar) / 2 == 95);
}

TEST_CASE("The camera is on its target in a fifth of a second and never passes it") {
  auto s = camera.start();
  measure::run(rk4, camera, s, 1e-4, 2000, [](double, const auto& now) { CHECK(now.x > 0); });
  CHECK(s.x < 0.01);
}

TEST_CASE(
    "The shuttle comes within four metres, that of the race within five, the comet within 3") {
  CHECK_THAT(reach(shuttle, shuttle_turn).nearest, WithinAbs(4, 1e-3));
  CHECK_THAT(reach(race_shuttle, shuttle_turn).nearest, WithinAbs(5, 1e-3));
  CHECK_THAT(reach(comet, comet_year).nearest, WithinAbs(3, 1e-2));
  CHECK_THAT(reach(comet, comet_year).farthest, WithinAbs(197, 1e-2));
}

TEST_CASE("The lamp swings in a little more than two seconds") {
  auto s = lamp.start();
  double back = 0, before = 0;  // when it turns round on the side where it began
  measure::run(rk4, lamp, s, 1e-4, 25'000, [&](double t, const auto& now) {
    if (before > 0 && now.v <= 0) back = t;
    before = now.v;
  });
  CHECK(back > 2);
  CHECK(back < 2.2);
}

TEST_CASE("Its own weight stretches the rope of springs by a hundredth") {
  // Spring n of 20, from below, carries n beads; the sum over all of them.
  double stretched = 0;
  for (int below = 1; below < rope_of_springs.count; ++below) {
    stretched += below * rope_of_springs.mass * rope_of_springs.g / rope_of_springs.k;
  }
  CHECK_THAT(stretched / rope_of_springs.length, WithinRel(0.01, 1e-9));
}

TEST_CASE("The drone, the hatch and the jump of the films are those of the cast") {
  const auto at = drone.start();
  const play::Drone filmed;
  CHECK(filmed.x.x == at.x.x());
  CHECK(filmed.x.y == at.x.y());
  CHECK(filmed.v.x == at.v.x());
  CHECK_THAT(filmed.v.y, WithinRel(at.v.y(), 1e-12));
  CHECK_THAT(play::Drone::pull({1, 0}, {}, 0).x, WithinRel(-drone.omega * drone.omega, 1e-11));
  play::Hand hand;
  hand.turn(1);
  CHECK_THAT(hand.tip.x, WithinAbs(std::cos(drone.omega * frame), 1e-14));
  CHECK_THAT(hand.tip.y, WithinAbs(std::sin(drone.omega * frame), 1e-14));

  CHECK(play::Hatch::omega == hatch.omega);
  CHECK(play::Hatch::zeta == hatch.zeta);
  CHECK(play::Hatch{}.x.y == hatch.x0);
  CHECK(play::Hatch{}.v.y == hatch.start().v);

  const play::Jumper jumper;
  CHECK(jumper.v.x == jump.start_velocity.x());
  CHECK(jumper.v.y == jump.start_velocity.y());
  CHECK(play::Jumper::gravity({}, {}, 0).y == jump(jump.start().x, jump.start().v, 0.0).y());
}
