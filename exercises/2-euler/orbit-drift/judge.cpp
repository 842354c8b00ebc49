// SPDX-License-Identifier: MIT-0
#include <algorithm>
#include <catch2/catch_test_macros.hpp>

#include "harness.h"
#include "judge/describe.h"
#include "judge/session.h"
#include "judge/tests.h"
#include "scene.h"

using namespace judge;

namespace {

using grade::number;

enum Function { step, steps_per_turn };

std::string flown(int steps) {
  if (steps < 1) return std::to_string(steps) + " steps, and nothing can be flown";
  if (steps > drone::most_steps) return std::to_string(steps) + " steps, and nobody flies so many";
  return std::to_string(steps) + " steps, in which the distance grows by " +
         number(drone::growth(steps), 8) + " of itself; in one step fewer by " +
         number(drone::growth(steps - 1), 8);
}

grade::Plot plot(const drone::Turn& turn, int steps) {
  grade::Curve yours{"yours", {}, {}}, limit{"as far as it may go", {}, {}};
  const Path path = drone::fly(std::clamp(steps, 1, drone::most_steps));
  for (const State& state : path.states) {
    yours.x.push_back(static_cast<double>(yours.x.size()) / steps);
    yours.y.push_back(length(state.x));
  }
  limit.x = {0, 1};
  limit.y = {1 + turn.growth, 1 + turn.growth};
  return {"How far out the drone is", "turns", "distance [radii]", {yours, limit}};
}

// Turns in so few steps that only the factor itself is right, and not what it is near when they are
// many; in more and more; and with all that may be asked.
std::vector<drone::Turn> drawn(Random& random) {
  std::vector<drone::Turn> turns{drone::Turn::draw(random, 12, 15)};
  for (const double least : {30.0, 100.0, 1000.0, 9000.0})
    turns.push_back(drone::Turn::draw(random, least, 2 * least));
  for (const double growth : harness_bounds::growth.asked())
    turns.push_back(drone::Turn::of(growth));
  return turns;
}

// Turns of all sizes, each beside another that wants a step more; now and then just within.
std::vector<drone::Turn> of_all_sizes(Random& random) {
  constexpr int pairs = 100;
  constexpr double nearest = 0.01;
  const double fewest = drone::Turn::of(harness_bounds::growth.largest()).fewest;
  const double most = drone::Turn::of(harness_bounds::growth.smallest()).fewest;
  std::vector<drone::Turn> turns;
  for (int n = 0; n < pairs; ++n) {
    const double drawn = std::exp(random.between(std::log(fewest + 1), std::log(most - 1)));
    for (const int more : {0, 1}) {
      const double share = random.octaves(nearest, 0.5);
      turns.push_back(drone::Turn::between(static_cast<int>(drawn) + more,
                                           random.whole(0, 1) == 1 ? share : 1 - share));
    }
  }
  return turns;
}

// A turn in so many steps stays within the growth, and one in a smaller number does not.
// @param fewer  that number, given the student's
template <class Fewer>
void keeps_within(Student& student, const std::vector<drone::Turn>& turns,
                  const std::string& spared, Fewer fewer, const std::string& hint) {
  const auto ask = [](Student& who, const drone::Turn& turn) {
    return static_cast<int>(who.call(steps_per_turn, {turn.growth}, 1)[0]);
  };
  for (const drone::Turn& turn : turns) {
    const int got = ask(student, turn);
    const bool within = drone::growth(got) <= turn.growth;
    grade::Finding finding;
    finding.held = within && got <= drone::most_steps && drone::growth(fewer(got)) > turn.growth;
    finding.asked = "the fewest steps of Euler's method around the circle";
    finding.input = named("growth", turn.growth);
    finding.expected =
        "a growth of at most " + number(turn.growth, 8) + ", and a larger one with " + spared;
    finding.got = flown(got);
    finding.error = within ? "steps that can be spared"
                           : number(drone::growth(got) - turn.growth, 3) + " of the distance";
    finding.tolerance = "none";
    finding.tolerance_from = "the growth is chosen so that rounding cannot decide";
    if (!finding.held) {
      finding.hint = hint;
      finding.diagnoses = drone::what_is_wrong(turn, got);
      if (got > 0) finding.plot = plot(turn, got);
    }
    check(finding);
  }
}

}  // namespace

TEST_CASE("five steps under a hidden force are Euler's", "[2-euler/orbit-drift][2 points]") {
  Student student;
  const std::string hint = "Both lines of the formula use the state at the start of the step.";
  is_method(student, euler, hint, step);
  is_method_everywhere(student, euler, hint, step);
}

TEST_CASE("the acceleration is asked for once a step, at its start",
          "[2-euler/orbit-drift][1 point]") {
  Student student;
  evaluates(student, euler, 1, 0, "Ask once, at (x, v, t), before you change any of them.", step);
}

TEST_CASE("an orbit gains the energy that Euler's method gives it",
          "[2-euler/orbit-drift][1 point]") {
  Student student;
  has_energy_of(student, euler, 0.2, 5, 400,
                "Under Euler's method the orbit widens, turn after turn. Does each line use the "
                "old x and v?",
                step);
}

TEST_CASE("in so many steps a turn grows no further than it may, and not in half as many",
          "[2-euler/orbit-drift][3 points]") {
  Student student;
  Random random;
  keeps_within(
      student, drawn(random), "half of the steps", [](int steps) { return steps / 2; },
      "By what does one step multiply the distance? By what do all steps of a turn?");
}

TEST_CASE("no step of the turn can be spared", "[2-euler/orbit-drift][2 points]") {
  Student student;
  Random random;
  keeps_within(
      student, drawn(random), "one step fewer", [](int steps) { return steps - 1; },
      "Try it: fly the turn in your number of steps, and in one fewer. The first must be within "
      "the growth, and the second beyond it.");
}

TEST_CASE("any growth is kept in the fewest steps, and one that is nearly the same in its own",
          "[2-euler/orbit-drift][1 point]") {
  Student student;
  Random random;
  keeps_within(
      student, of_all_sizes(random), "one step fewer", [](int steps) { return steps - 1; },
      "The same must hold for any growth. Is there one from which on a line of yours does "
      "something of its own?");
}
