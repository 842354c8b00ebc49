// SPDX-License-Identifier: MIT-0
#include <algorithm>
#include <cmath>

#include "format_values.h"
#include "judge/describe.h"
#include "judge/random.h"
#include "judge/session.h"
#include "judge/tests.h"

namespace judge {
namespace {

using grade::number;

// Enough steps to let even a damping of a tenth show on which side of its limit a method is.
constexpr int steps_until = 20000, every = 100;
constexpr double margin = 0.02, bounded = 100, exploded = 1000;

double growth(const Path& path) {
  double largest = 0;
  for (const State& state : path.states) {
    const double now = distance(state, State{});
    if (!std::isfinite(now)) return INFINITY;
    largest = std::max(largest, now);
  }
  return largest / distance(path.states.front(), State{});
}

// What stands still, or goes nowhere, does not blow up either: through the middle, or to it, is
// half the way at least.
bool moves(const Path& path) {
  const Vec from = path.states.front().x;
  return std::any_of(path.states.begin(), path.states.end(), [&](const State& state) {
    return length(state.x - from) >= length(from) / 2;
  });
}

// Returns whether what is NaN at last has become too large first.
bool grows_before(const Path& path, std::size_t broken) {
  return broken > 0 &&
         distance(path.states[broken - 1], State{}) > bounded * distance(path.states[0], State{});
}

grade::Plot plot(const Path& path) {
  grade::Curve yours{"yours", {}, {}};
  for (std::size_t n = 1; n < path.states.size(); ++n) {
    yours.x.push_back(path.time(n) - path.t);
    yours.y.push_back(length(path.states[n].x));
  }
  grade::Plot plot{"How far from rest", "time [s]", "distance [m]", {yours}};
  plot.logarithmic = true;
  return plot;
}

// omega is drawn: it must be h omega that counts.
void check_side(Student& student, double zeta, double limit, bool inside, const std::string& hint,
                int function) {
  Random random;
  const double omega = random.between(3, 9);
  const double h = limit * (inside ? 1 - margin : 1 + margin) / omega;
  const Start start = random.start();
  const harness::Force force{harness::Force::spring, {omega, zeta}};
  const Path path = student.run(start, h, steps_until, every, force, function);
  const double grown = growth(path);

  grade::Finding finding;
  const std::size_t broken = first_not_finite(path);
  const bool breaks = inside && broken < path.states.size();
  const bool stands = inside && !breaks && !moves(path);
  finding.held = inside ? grown <= bounded && !stands : !(grown <= exploded);
  finding.asked = std::to_string(steps_until) + " steps of " + number(h * omega, 5) + "/omega on " +
                  describe(force) + ": 2 % " + (inside ? "below" : "above") + " the limit of " +
                  number(limit);
  finding.input = describe(start) + ", h = " + number(h, 17);
  finding.expected = inside ? "it moves, and stays bounded" : "it blows up";
  finding.got = "it grew to " + number(grown, 3) + " times the start";
  finding.error = stands ? "it does not move" : inside ? "it blew up" : "it stayed bounded";
  if (breaks) {
    finding.got = "after step " + std::to_string(broken * every) + " it is not a finite number";
  }
  finding.tolerance = inside ? "a growth of 100" : "a growth of 1000";
  finding.tolerance_from = inside ? "so close to the limit the right method sways by less"
                                  : "so far over the limit the right method grows by far more";
  if (!finding.held) {
    finding.hint = hint;
    if (stands) finding.diagnoses = {"the spring stays near where it was let go"};
    if (breaks && !grows_before(path, broken)) {
      finding.error = "it is not a number";
      finding.diagnoses.emplace_back("up to there it had not grown much: is there a 0 / 0?");
    }
    finding.plot = plot(path);
  }
  check(finding);
}

}  // namespace

void is_stable_until(Student& student, double zeta, double limit, const std::string& hint,
                     int function) {
  check_side(student, zeta, limit, true, hint, function);
  check_side(student, zeta, limit, false, hint, function);
}

}  // namespace judge
