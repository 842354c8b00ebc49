// SPDX-License-Identifier: MIT-0
#include <algorithm>
#include <array>
#include <catch2/catch_test_macros.hpp>
#include <cmath>

#include "format_values.h"
#include "harness.h"
#include "judge/describe.h"
#include "judge/random.h"
#include "judge/session.h"
#include "judge/tests.h"
#include "leaf.h"

using namespace judge;
using namespace judge::leaf_in_the_wind;

namespace {

using grade::number;

// How far it strays from the truth, after each frame [m].
std::vector<double> strays(const Path& path, const Path& truth) {
  std::vector<double> away;
  for (std::size_t n = 0; n < truth.states.size(); ++n) {
    away.push_back(length(path.states[n].x - truth.states[n].x));
  }
  return away;
}

double furthest(const std::vector<double>& away) {
  double found = 0;
  for (const double now : away) found = std::isfinite(now) ? std::max(found, now) : INFINITY;
  return found;
}

// A leaf, and how far it and the leaf that asks at the start stray.
struct Drift {
  Leaf leaf;
  Path path;
  std::vector<double> yours, theirs;
};

Drift drift(Student& student, const Leaf& leaf) {
  const Path truth = leaf.truth(), path = leaf.by(student);
  return {leaf, path, strays(path, truth), strays(leaf.by(asking("", leaf.c, 0, 0)), truth)};
}

std::vector<std::string> recognised(const Drift& worst) {
  const double straight = length(worst.leaf.start.v) * worst.leaf.frames * worst.leaf.h;
  if (!worst.yours.empty() && !(furthest(worst.yours) < 100 * (1 + straight))) {
    return {"it explodes: with c h = " + number(worst.leaf.c * worst.leaf.h, 3) +
            ", what multiplies the old velocity has a size above 1"};
  }
  for (const Method& method : known(worst.leaf.c)) {
    const Path theirs = worst.leaf.by(method);
    const State &a = worst.path.states[1], &b = theirs.states[1];
    if (distance(a, b) <= rounding(1, 1 + distance(b, State{})).value) {
      return {"this is " + method.name};
    }
  }
  return {};
}

grade::Plot plot(const Drift& drift) {
  grade::Curve yours{"yours", {}, drift.yours}, theirs{"asking at the start", {}, drift.theirs};
  for (std::size_t n = 0; n < drift.yours.size(); ++n) {
    yours.x.push_back(static_cast<double>(n) * drift.leaf.h);
  }
  theirs.x = yours.x;
  return {"How far from the true path", "time [s]", "distance [m]", {yours, theirs}};
}

void asks_once(const Drift& drift) {
  const std::size_t asked = drift.path.evaluations.size();
  const auto allowed = static_cast<std::size_t>(drift.leaf.frames);
  grade::Finding finding;
  finding.held = asked <= allowed;
  finding.asked = std::to_string(allowed) + " frames with one question each";
  finding.input = describe(drift.leaf.start);
  finding.expected = "at most " + std::to_string(allowed) + " questions";
  finding.got = std::to_string(asked) + " questions";
  finding.error = std::to_string(asked) + " instead of " + std::to_string(allowed);
  finding.tolerance = "none";
  finding.tolerance_from = "questions are counted where they are answered";
  if (!finding.held) {
    finding.hint =
        "One question in a good place is worth two in bad ones. What holds the leaf is "
        "the division, and it asks nothing.";
    if (asked % allowed == 0)
      finding.diagnoses = {"it asks " + std::to_string(asked / allowed) + " times in each frame"};
  }
  check(finding);
}

// Both bounds, and four between them.
std::vector<double> all_drags(Random& random) {
  std::vector<double> all(harness_bounds::c.asked().begin(), harness_bounds::c.asked().end());
  while (all.size() < 6) all.push_back(random.whole(150, 300));
  return all;
}

void stays_near(Student& student, int per_second) {
  Random random;
  const Acceleration wind = draw_wind(random);
  double yours = 0, theirs = 0;
  Drift worst;
  for (const double c : all_drags(random)) {
    Start start = random.start();
    start.v = wind(start.x, {}, start.t);
    const Drift now = drift(student, {c, 1.0 / per_second, 2 * per_second, wind, start});
    asks_once(now);
    if (worst.yours.empty() || !(furthest(now.yours) <= yours)) worst = now;
    yours = std::max(yours, furthest(now.yours));
    theirs = std::max(theirs, furthest(now.theirs));
  }

  grade::Finding finding;
  finding.held = yours <= theirs / 10;
  finding.asked = "two seconds of six leaves at " + std::to_string(per_second) +
                  " frames a second, in a wind drawn from the seed";
  finding.input = "the leaf that strays furthest: " + describe(worst.leaf.start) +
                  ", c = " + number(worst.leaf.c) + "/s";
  finding.expected = "no leaf further from its path than " + number(theirs / 10, 4) + " m";
  finding.got = "one strays by " + number(yours, 4) + " m";
  finding.error = number(10 * yours / theirs, 3) + " times what is allowed";
  finding.tolerance = number(theirs / 10, 4) + " m";
  finding.tolerance_from = "the task; backward Euler that asks at the start strays by " +
                           number(theirs, 4) +
                           " m, in proportion to the frame, and a wind that "
                           "is neither old nor early leaves only the square of it";
  if (!finding.held) {
    finding.hint = "Where is the leaf in the middle of the frame, and when is that?";
    finding.diagnoses = recognised(worst);
    finding.plot = plot(worst);
  }
  check(finding);
}

void stops(Student& student, Random& random, double c) {
  const Vec calm = random.vector(-0.5, 0.5), thrown = random.vector(2, 5);
  Start start = random.start();
  start.v = calm + thrown;
  const Leaf leaf{c, 1.0 / 60, 30, [=](const Vec&, const Vec&, double) { return calm; }, start};
  const Path path = leaf.by(student);
  // What is left of the throw, along the throw; and how far it came in all, beyond the air.
  const auto left = [&](std::size_t n) {
    return dot(path.states[n].v - calm, thrown) / dot(thrown, thrown);
  };
  const Vec way = path.states.back().x - start.x - leaf.frames * leaf.h * calm;
  const double came = dot(way, thrown) / dot(thrown, thrown) * leaf.c;
  double least = 1;
  for (std::size_t n = 1; n < path.states.size(); ++n) least = std::min(least, left(n));
  const double rounded = rounding(leaf.frames, 1).value;
  const bool braked = left(1) <= 0.5, forward = least >= -rounded;

  grade::Finding finding;
  finding.held = braked && forward && std::abs(came - 1) <= 0.1;
  finding.asked = "30 frames of a leaf that is thrown into still or steady air";
  finding.input = describe(start) + ", air " + describe(calm, 17) + ", c = " + number(leaf.c) +
                  "/s, h = " + number(leaf.h, 17);
  finding.expected =
      "less than half of the throw left after a frame, nothing negative after any, and " +
      number(length(thrown) / leaf.c, 4) + " m in all";
  finding.got = number(left(1), 4) + " left after a frame, " + number(least, 4) +
                " at the least, and " + number(came * length(thrown) / leaf.c, 4) + " m in all";
  finding.error = !forward  ? "it is thrown back"
                  : !braked ? "it is hardly braked"
                            : number(std::abs(came - 1), 3) + " of the way";
  finding.tolerance = "a tenth of the way";
  finding.tolerance_from =
      "a true leaf comes v / c far; a division by 1 + c h and the exact "
      "formula both come as far, to rounding";
  if (!finding.held) {
    finding.hint =
        "In steady air only the drag is left. Which of the chapter's factors never "
        "turns negative, and what do all its steps add up to?";
    finding.diagnoses = recognised({leaf, path, {}, {}});
  }
  check(finding);
}

}  // namespace

TEST_CASE("at 60 frames a second one question a frame keeps the leaves near their paths",
          "[4-implicit/leaf-in-the-wind][4 points]") {
  Student student;
  stays_near(student, 60);
}

TEST_CASE("at 30 frames a second, too", "[4-implicit/leaf-in-the-wind][2 points]") {
  Student student;
  stays_near(student, 30);
}

TEST_CASE("a thrown leaf stops where it should, and is never thrown back",
          "[4-implicit/leaf-in-the-wind][4 points]") {
  Student student;
  Random random;
  stops(student, random, random.whole(150, 300));
  for (const double c : harness_bounds::c.asked()) stops(student, random, c);
}
