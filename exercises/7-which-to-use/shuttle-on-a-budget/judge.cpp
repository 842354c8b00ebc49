// SPDX-License-Identifier: MIT-0
#include <algorithm>
#include <catch2/catch_test_macros.hpp>
#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include "format_values.h"
#include "harness.h"
#include "judge/describe.h"
#include "judge/orbit_energy.h"
#include "judge/session.h"
#include "judge/tests.h"
#include "judge/waves.h"

using namespace judge;
using grade::number;

namespace {

constexpr int budget = 1200;
constexpr int flights = 17;  // of which the one in the middle counts

// An orbit around a planet that is a little flat, among moons that tug.
struct Flight {
  Start start;
  double mu, flatness, seconds;
  Waves moons;

  static Flight draw(Random& random, double turns) {
    const Orbit orbit = Orbit::draw(random, random.between(0.78, 0.82));
    const double flatness = random.between(0.001, 0.003);
    return {orbit.start,
            orbit.mu,
            flatness,
            turns * orbit.period(),
            {random, 0.02 * orbit.mu, 2, orbit.period()}};
  }

  Vec operator()(const Vec& x, const Vec&, double t) const {
    const double r2 = dot(x, x), r = std::sqrt(r2);
    return (-mu / (r2 * r) * (1 + flatness / r2)) * x + moons(x, t);
  }

  State by(const Method& method, int steps) const {
    return run(method, start, seconds / steps, steps, steps, *this).states.back();
  }

  std::string input() const {
    return describe(start) + ", " + number(seconds, 17) + " s; a pull of " + number(mu, 17) +
           " / r^2 (1 + " + number(flatness, 17) + " / r^2), and moons that only the judge knows";
  }
};

// A flight that is over, and how far off equal steps of the two methods end for the whole budget;
// Verlet asks once to begin.
struct Landing {
  Flight flight;
  State truth;
  Path path;
  double off, verlet, rk4;

  Landing(const Flight& flown, Student& student)
      : flight(flown),
        truth(truth_past_a_sun(flight.start, flight.seconds, flight.mu, flight)),
        path(student.watch(flight.start, flight.seconds, 1, flight)),
        off(distance(path.states.back(), truth)),
        verlet(distance(flight.by(velocity_verlet, budget - 1), truth)),
        rk4(distance(flight.by(judge::rk4, budget / 4), truth)) {}

  std::size_t count() const { return path.evaluations.size(); }
  bool overdrawn() const { return count() > budget; }
};

grade::Plot evaluations(const Landing& landing) {
  grade::Curve steps{"yours", {}, {}};
  for (const Evaluation& asked : landing.path.evaluations) {
    steps.x.push_back((asked.t - landing.flight.start.t) / landing.flight.seconds);
    steps.y.push_back(length(asked.x));
  }
  return {"Where you asked", "share of the flight", "distance from the planet [m]", {steps}};
}

// A method in equal steps, for as many questions; the methods ask from once to four times a step,
// and some once to begin.
std::string equal_steps(const Landing& landing) {
  const State& end = landing.path.states.back();
  const int count = static_cast<int>(landing.count());
  for (const Method& method :
       {euler, symplectic_euler, velocity_verlet, midpoint, heun, judge::rk4}) {
    for (const int steps : {count, count - 1, count / 2, count / 4}) {
      if (steps < 1 || distance(landing.flight.by(method, steps), end) > 1e-7) continue;
      return "this is " + method.name + " in " + std::to_string(steps) + " equal steps";
    }
  }
  return "";
}

std::string how(const Landing& landing) {
  const std::vector<Evaluation>& asked = landing.path.evaluations;
  const std::string equal = equal_steps(landing);
  if (!equal.empty() || asked.empty()) return equal;
  const Flight& flight = landing.flight;
  const double last = std::ranges::max(asked, {}, &Evaluation::t).t - flight.start.t;
  if (last > (1 + 1e-9) * flight.seconds)
    return "the last question is for " + number(last - flight.seconds, 3) +
           " s after the end: does the flight end at its very second?";
  if (last < flight.seconds / 2)
    return "no question is for the second half of the flight; the moons move, and t says when";
  const auto same = [](const Evaluation& a, const Evaluation& b) { return a.t == b.t; };
  if (std::ranges::adjacent_find(asked, same) == asked.end())
    return "no two questions are for one time, as in velocity Verlet, which asks once a step and "
           "has order two; an orbit this smooth rewards a higher order";
  return "";
}

std::vector<std::string> recognise(const Landing& landing) {
  if (landing.overdrawn())
    return {"it asked " + std::to_string(landing.count()) + " times, where " +
            std::to_string(budget) + " are allowed"};
  std::vector<std::string> found{how(landing)};
  if (found[0].empty()) found.clear();
  if (landing.count() < budget / 2)
    found.emplace_back("more than half of the evaluations were never spent");
  return found;
}

// The distance that a landing may be off, and where that comes from.
struct Bound {
  std::function<double(const Landing&)> of;
  std::string from;
};

// The one that overdrew the budget, if there is one. Or the one in the middle, by its share of what
// it may be off: how much an orbit forgives is luck, and luck should not give marks.
Landing telling(std::vector<Landing> all, const Bound& bound) {
  const auto overdrawn =
      std::find_if(all.begin(), all.end(), [](const Landing& one) { return one.overdrawn(); });
  if (overdrawn != all.end()) return *overdrawn;
  const auto share = [&](const Landing& one) {
    const double off = one.off / bound.of(one);
    return std::isfinite(off) ? off : INFINITY;
  };
  const auto middle = all.begin() + flights / 2;
  std::nth_element(all.begin(), middle, all.end(), [&](const Landing& one, const Landing& other) {
    return share(one) < share(other);
  });
  return *middle;
}

void lands_within(const Bound& bound, const std::string& hint) {
  Student student;
  Random random;
  std::vector<Landing> all;
  const int drawn = flights - static_cast<int>(harness_bounds::turns.asked().size());
  for (const double turns : random.all_of(harness_bounds::turns, drawn))
    all.emplace_back(Flight::draw(random, turns), student);
  const Landing landing = telling(all, bound);
  const double most = bound.of(landing);
  const std::string spent = std::to_string(landing.count()) + " evaluations";
  grade::Finding finding;
  finding.held = landing.off <= most && !landing.overdrawn();
  finding.asked = std::to_string(flights) + " flights, each with at most " +
                  std::to_string(budget) + " evaluations; this is " +
                  (landing.overdrawn() ? "one that took more" : "the one in the middle");
  finding.input = landing.flight.input();
  finding.expected = describe(landing.truth) + ", to " + number(most, 3);
  finding.got = describe(landing.path.states.back()) + ", with " + spent;
  finding.error = number(landing.off, 3);
  finding.tolerance = number(most, 3) + ", and " + std::to_string(budget) + " evaluations";
  finding.tolerance_from = bound.from + "; here equal steps of RK4 are off by " +
                           number(landing.rk4, 3) + ", of velocity Verlet by " +
                           number(landing.verlet, 3);
  if (!finding.held) {
    finding.hint = hint;
    finding.plot = evaluations(landing);
    finding.diagnoses = recognise(landing);
  }
  check(finding);
}

Bound share_of_rk4(int times) {
  return {[=](const Landing& landing) { return landing.rk4 / times; },
          "1/" + std::to_string(times) + " of what RK4 in " + std::to_string(budget / 4) +
              " equal steps is off"};
}

}  // namespace

TEST_CASE("within the budget the shuttle lands as near as equal steps bring it",
          "[7-which-to-use/shuttle-on-a-budget][3 points]") {
  lands_within(
      {[](const Landing& landing) { return 1.001 * std::max(landing.verlet, landing.rk4); },
       "the farther of RK4 and velocity Verlet, both in equal steps for all of the "
       "budget; and a thousandth for the order of the sums"},
      "Take RK4, and divide the flight into equal steps for a start.");
}

TEST_CASE("the shuttle lands twenty times nearer than RK4 in equal steps",
          "[7-which-to-use/shuttle-on-a-budget][3 points]") {
  lands_within(share_of_rk4(20),
               "Take short steps where the planet is near, and long ones where it is far.");
}

TEST_CASE("the shuttle lands eighty times nearer than RK4 in equal steps",
          "[7-which-to-use/shuttle-on-a-budget][4 points]") {
  lands_within(share_of_rk4(80),
               "A circle of radius r takes a time in proportion to r^(3/2). And is all of "
               "the budget spent?");
}
