// SPDX-License-Identifier: MIT-0
#include <catch2/catch_test_macros.hpp>

#include "../places.h"
#include "judge/random.h"
#include "scene.h"

using namespace judge;
using namespace judge::verlet;
using namespace judge::verlet::two_places;

namespace {

// A spark that falls, bounces and rises, by the lines of the student.
struct Fall {
  double top = 0, restitution = 0, g = 0, h = 0;

  static Fall draw() {
    Random random;
    return {random.between(1, 2), random.between(0.75, 0.9), random.between(8, 12), 0.002};
  }

  /// The heights to which it came, at first and after each bounce.
  std::vector<double> tops(Student& student, std::size_t count) const {
    std::vector<double> request{top, restitution, g, h, static_cast<double>(steps())};
    const std::vector<double> y = student.call(4, request, steps());
    std::vector<double> tops{top};
    for (std::size_t n = 1; n + 1 < y.size() && tops.size() < count; ++n) {
      if (y[n - 1] < y[n] && y[n] >= y[n + 1]) tops.push_back(y[n]);
    }
    return tops;
  }

  /// Time enough for three bounces.
  std::size_t steps() const { return static_cast<std::size_t>(6.5 * std::sqrt(2 * top / g) / h); }
};

}  // namespace

TEST_CASE("the next place is as far again and a push further", "[5-verlet/two-places][2 points]") {
  Student student;
  for (const Line& line : Line::draw_all(next_place)) {
    are_places({"next_place",
                line.in_words("x_previous"),
                line.tolerance(),
                "In the last step it went from x_previous to x. It goes as far again, and the push "
                "comes on top.",
                {}},
               line.by(student, next_place), {"position Verlet", {line.next()}});
  }
}

TEST_CASE("the place before the start is the one of Taylor's formula",
          "[5-verlet/two-places][2 points]") {
  Student student;
  for (const Line& line : Line::draw_all(place_before)) {
    are_places({"place_before",
                line.in_words("v"),
                line.tolerance(),
                "Put -h for h into the path of constant acceleration. Which sign does each term "
                "get?",
                {}},
               line.by(student, place_before), {"Taylor's formula", {line.before_start()}});
  }
}

TEST_CASE("five steps under a hidden force are those of position Verlet",
          "[5-verlet/two-places][1 point]") {
  Student student;
  is_method(student, position_verlet,
            "Both lines are in use here: the one at the start, the other in each step.", steps);
}

TEST_CASE("a spark that only falls passes through its true places",
          "[5-verlet/two-places][1 point]") {
  Random random;
  const Start start = random.start();
  const double g = random.between(5, 15), h = random.between(0.02, 0.05);
  constexpr int count = 40;
  Student student;
  const Path path = student.run(start, h, count, 1, {harness::Force::falling, {g, 0, 0}}, steps);
  Asked asked{std::to_string(count) + " steps of a spark that only gravity pulls, g = " +
                  grade::number(g, 17) + " m/s^2 along -y",
              describe(start) + ", h = " + grade::number(h, 17),
              {},
              "With the right start nothing is left out under a constant force. Where is yours "
              "after the first step?",
              {}};
  std::vector<Vec> yours;
  Places exact{"true", {}};
  for (int n = 1; n <= count; ++n) {
    const double t = n * h;
    asked.times.push_back(t);
    yours.push_back(path.states[static_cast<std::size_t>(n)].x);
    exact.x.push_back(start.x + t * start.v - Vec{0, g * t * t / 2, 0});
  }
  asked.tolerance = rounding(count, 1 + length(exact.x.back()));
  are_places(asked, yours, exact);
}

TEST_CASE("a spark below the floor bounces, and no other does", "[5-verlet/two-places][2 points]") {
  Student student;
  Random random;
  for (const double below :
       {random.between(0.05, 0.1), random.between(0.01, 0.02), -0.01, -0.3, 0.0}) {
    bounces(student, Spark::draw(random, below));
  }
  bounces(student, Spark::overtaken(random));
}

TEST_CASE("any spark below its floor bounces, however deep, however fast, on a floor at any height",
          "[5-verlet/two-places][1 point]") {
  Student student;
  Random random;
  constexpr int sparks = 400;
  for (int n = 0; n < sparks; ++n) bounces(student, Spark::anywhere(random));
}

TEST_CASE("after each bounce a spark comes as high as the restitution lets it",
          "[5-verlet/two-places][1 point]") {
  Student student;
  const Fall fall = Fall::draw();
  constexpr std::size_t bounces = 3;
  const std::vector<double> tops = fall.tops(student, bounces + 1);
  grade::Finding finding;
  finding.held = tops.size() == bounces + 1;
  finding.asked = "three bounces of a spark that is let go, with the first two functions as well";
  finding.input = "from " + grade::number(fall.top, 17) +
                  " m above the floor, restitution = " + grade::number(fall.restitution, 17) +
                  ", g = " + grade::number(fall.g, 17) + " m/s^2, h = " + grade::number(fall.h) +
                  " s";
  finding.expected = "each time the restitution squared of the height before";
  finding.got = "heights";
  for (const double top : tops) finding.got += " " + grade::number(top, 3);
  finding.got += " m";
  finding.error = std::to_string(tops.size() - 1) + " bounces";
  const double share = fall.restitution * fall.restitution, within = 0.03;
  for (std::size_t n = 1; finding.held && n < tops.size(); ++n) {
    const double off = tops[n] / tops[n - 1] / share - 1;
    finding.held = std::abs(off) <= within;
    finding.error =
        grade::number(100 * off, 3) + " % of the height, in bounce " + std::to_string(n);
  }
  finding.tolerance = "3 %";
  finding.tolerance_from =
      "a spark lands within a step, not at its end, and so with a velocity that is g h off at the "
      "most: 1 % of that of the lowest fall, and 2 % of its height";
  if (!finding.held) {
    finding.hint =
        "The height goes with the square of the velocity. Is each bounce the restitution times "
        "the velocity, and nothing else?";
  }
  check(finding);
}
