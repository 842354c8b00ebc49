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
#include "scene.h"

using namespace judge;
using namespace judge::leaf_in_the_wind;

namespace {

using grade::number;

// The distance of a leaf from the truth, after each frame [m].
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

Drift drift(const Leaf& leaf, const Path& path) {
  const Path truth = leaf.truth();
  return {leaf, path, strays(path, truth), strays(leaf.by(asking(leaf.c, 0, 0)), truth)};
}

std::vector<std::string> what_is_wrong(const Drift& worst) {
  const double straight = length(worst.leaf.start.v) * worst.leaf.frames * worst.leaf.h;
  if (!worst.yours.empty() && !(furthest(worst.yours) < 100 * (1 + straight))) {
    return {"it explodes: with c h = " + number(worst.leaf.c * worst.leaf.h, 3) +
            ", what multiplies the old velocity has a size above 1"};
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

// Judges all leaves together: one may have a wind in which hardly any frame is wrong.
void stay_near(const std::vector<Drift>& drifts, const std::string& asked,
               const std::function<std::vector<std::string>()>& remarks = {}) {
  double yours = 0, theirs = 0;
  Drift worst;
  for (const Drift& now : drifts) {
    asks_once(now);
    if (worst.yours.empty() || !(furthest(now.yours) <= yours)) worst = now;
    yours = std::max(yours, furthest(now.yours));
    theirs = std::max(theirs, furthest(now.theirs));
  }

  grade::Finding finding;
  finding.held = yours <= theirs / 10;
  finding.asked = asked;
  finding.input = "the leaf that strays furthest: " + describe(worst.leaf.start) +
                  ", c = " + number(worst.leaf.c, 17) + "/s, h = " + number(worst.leaf.h, 17);
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
    finding.diagnoses = what_is_wrong(worst);
    if (finding.diagnoses.empty() && remarks) finding.diagnoses = remarks();
    finding.plot = plot(worst);
  }
  check(finding);
}

void stays_near(Student& student, int per_second) {
  Random random;
  const Acceleration wind = draw_wind(random);
  std::vector<Drift> drifts;
  for (const double c : all_drags(random)) {
    Start start = random.start();
    start.v = wind(start.x, {}, start.t);
    const Leaf leaf{c, 1.0 / per_second, 2 * per_second, wind, start};
    drifts.push_back(drift(leaf, leaf.by(student)));
  }
  stay_near(drifts, "two seconds of six leaves at " + std::to_string(per_second) +
                        " frames a second, in a wind drawn from the seed");
}

constexpr int frames = 15;

// Two pairs of leaves: each shares the clock, and the first also the frame.
std::vector<Leaf> draw_park(Random& random, const Acceleration& wind) {
  const double times[] = {random.anywhere(start_time), random.anywhere(start_time)};
  const double h = random.anywhere(harness_bounds::h);
  std::vector<Leaf> leaves;
  for (const int pair : {0, 0, 1, 1}) {
    Start start{random.vector_anywhere(start_place), {}, times[pair]};
    start.v = wind(start.x, {}, start.t);
    leaves.push_back({random.anywhere(harness_bounds::c),
                      pair == 0 ? h : random.anywhere(harness_bounds::h), frames, wind, start});
  }
  return leaves;
}

void stay_near_by_turns(Student& student, Random& random) {
  const std::vector<Leaf> leaves = draw_park(random, draw_wind(random));
  const auto drifts = [&](const std::vector<Path>& paths) {
    std::vector<Drift> all;
    for (std::size_t i = 0; i < leaves.size(); ++i) all.push_back(drift(leaves[i], paths[i]));
    return all;
  };
  stay_near(drifts(by_turns(student, leaves)),
            std::to_string(frames) + " frames of four leaves, frame by frame by turns",
            [&]() -> std::vector<std::string> {
              double yours = 0, theirs = 0;
              for (const Leaf& leaf : leaves) {
                Student fresh;
                const Drift alone = drift(leaf, leaf.by(fresh));
                yours = std::max(yours, furthest(alone.yours));
                theirs = std::max(theirs, furthest(alone.theirs));
              }
              if (!(yours <= theirs / 10)) return {};
              return {
                  "alone in a program, none of these leaves strays: what is remembered of "
                  "another?"};
            });
}

void stops(Student& student, const Throw& scene) {
  const Leaf& leaf = scene.leaf;
  const Path path = leaf.by(student);
  const Vec thrown = scene.thrown(), all = scene.way();
  const double size = length(thrown), rounded = scene.rounded();
  const Vec along = size > 0 ? thrown / size : Vec{1, 0, 0};
  // The rest of the throw, along the throw; and the way in all, beyond the air.
  const auto left = [&](std::size_t n) { return dot(path.states[n].v - scene.calm, along); };
  const Vec way = path.states.back().x - leaf.start.x - leaf.frames * leaf.h * scene.calm;
  double least = size;
  for (std::size_t n = 1; n < path.states.size(); ++n) least = -larger(-least, -left(n));
  const bool braked = left(1) <= size / 2 + rounded, forward = least >= -rounded;
  const double off = length(way - all);

  grade::Finding finding;
  finding.held = braked && forward && off <= length(all) / 10 + scene.rounded_way();
  finding.asked =
      std::to_string(leaf.frames) + " frames of a leaf that is thrown into still or steady air";
  finding.input = describe(leaf.start) + ", air " + describe(scene.calm, 17) +
                  ", c = " + number(leaf.c, 17) + "/s, h = " + number(leaf.h, 17);
  finding.expected = "after a frame less than half left of the " + number(size, 4) +
                     " m/s of the throw, nothing negative after any, and " +
                     number(length(all), 4) + " m in all";
  finding.got = number(left(1), 4) + " m/s left after a frame, " + number(least, 4) +
                " m/s at the least, and " + number(length(way), 4) + " m in all";
  finding.error = !forward  ? "it is thrown back"
                  : !braked ? "it is hardly braked"
                            : number(off, 3) + " m of the way";
  finding.tolerance = "a tenth of the way";
  finding.tolerance_from =
      "a true leaf comes v / c far; a division by 1 + c h and the exact "
      "formula both come as far, to rounding";
  if (!finding.held) {
    finding.hint =
        "In steady air only the drag is left. Which of the chapter's factors never "
        "turns negative, and what do all its steps add up to?";
    finding.diagnoses = what_is_wrong({leaf, path, {}, {}});
  }
  check(finding);
}

}  // namespace

TEST_CASE("at 60 frames a second one question a frame keeps the leaves near their paths",
          "[4-implicit/leaf-in-the-wind][4 points]") {
  Student student;
  stays_near(student, 60);
}

TEST_CASE("at 30 frames a second one question a frame keeps the leaves near their paths, too",
          "[4-implicit/leaf-in-the-wind][2 points]") {
  Student student;
  stays_near(student, 30);
}

TEST_CASE("a thrown leaf stops where it should, and is never thrown back",
          "[4-implicit/leaf-in-the-wind][3 points]") {
  Student student;
  Random random;
  std::vector<double> drags{150.0 + random.whole(0, 150)};
  for (const double c : harness_bounds::c.asked()) drags.push_back(c);
  for (const double c : drags) stops(student, Throw::draw(random, c));
}

TEST_CASE("any leaf stops or stays near its path, at rest or thrown, in any air, others between",
          "[4-implicit/leaf-in-the-wind][1 point]") {
  Student student;
  Random random;
  constexpr int throws = 150, parks = 8;
  for (int n = 0; n < throws; ++n) stops(student, Throw::anywhere(random));
  for (int n = 0; n < parks; ++n) stay_near_by_turns(student, random);
}
