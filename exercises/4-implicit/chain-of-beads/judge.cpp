// SPDX-License-Identifier: MIT-0
#include <catch2/catch_test_macros.hpp>
#include <cmath>

#include "format_values.h"
#include "harness.h"
#include "judge/random.h"
#include "judge/session.h"
#include "judge/tests.h"
#include "remarks.h"

using namespace judge;
using namespace judge::chain_of_beads;

namespace {

using grade::number;

// The bead whose lines are missed furthest beside what rounding allows them.
std::size_t furthest_off(const Chain& chain, const Beads& end) {
  const double fastest = chain.fastest();
  std::size_t found = 0;
  double most = 0;
  for (std::size_t i = 0; i < chain.count(); ++i) {
    const double miss = chain.miss(end, i);
    if (!std::isfinite(miss)) return i;
    const double beside = miss == 0 ? 0 : miss / chain.tolerance(end, i, fastest).value;
    if (beside > most) found = i;
    most = std::max(most, beside);
  }
  return found;
}

void meets_its_lines(Student& student, const Chain& chain, const std::string& hint) {
  const Beads end = chain.after_one(student, chain.start);
  const std::size_t i = furthest_off(chain, end);
  const Tolerance tolerance = chain.tolerance(end, i, chain.fastest());
  grade::Finding finding = off_by(chain.miss(end, i), tolerance, " m/s");
  finding.asked = "one step of a chain, and whether the slope at its end leads back to the start";
  finding.input = chain.described();
  finding.expected =
      "at each bead x = x_old + h v and v = v_old + h a, all of it taken at your end";
  finding.got = "at bead " + std::to_string(i) + " x = " + number(end.x[i]) +
                ", v = " + number(end.v[i]) + "; there x_old + h v is " +
                number(chain.start.x[i] + chain.h * end.v[i]) + ", and v_old + h a is " +
                number(chain.start.v[i] + chain.h * chain.acceleration(end, i));
  finding.error += ", the most of all beads beside what it may be";
  if (!finding.held) {
    finding.hint = hint;
    finding.diagnoses = what_is_wrong(chain, end, chain.tolerance(end).value);
  }
  check(finding);
}

}  // namespace

TEST_CASE("short chains end where the slope of the end leads back to the start",
          "[4-implicit/chain-of-beads][3 points]") {
  Student student;
  Random random;
  for (const int count : {2, 3, random.whole(4, 6)}) {
    meets_its_lines(student,
                    Chain::draw(random, static_cast<std::size_t>(count), random.between(1, 10)),
                    "Write the matrix for two beads on paper, with k of its own for each spring. "
                    "The last bead has one spring, all others two.");
  }
}

TEST_CASE("a single bead is a spring", "[4-implicit/chain-of-beads][1 point]") {
  Student student;
  Random random;
  meets_its_lines(student, Chain::draw(random, 1, random.between(1, 10)),
                  "One bead is the first and the last: it has no neighbour, only the wall.");
}

TEST_CASE("a stiff chain loses energy in every step and never gains",
          "[4-implicit/chain-of-beads][2 points]") {
  Student student;
  Random random;
  const Chain chain = Chain::draw(random, 50, 100);
  Beads beads = chain.start;
  grade::Curve yours{"yours", {0}, {chain.energy(beads)}};
  constexpr int steps = 30;
  Chain before = chain;
  bool falls = true;
  for (int n = 1; n <= steps && falls; ++n) {
    before.start = beads;
    beads = chain.after_one(student, beads);
    falls = chain.energy(beads) < yours.y.back();
    yours.x.push_back(n * chain.h);
    yours.y.push_back(chain.energy(beads));
  }

  grade::Finding finding;
  finding.held = falls;
  finding.asked = std::to_string(steps) + " steps of a chain with h^2 k up to 100";
  finding.input = chain.described();
  finding.expected = "less energy after each step than before it";
  const std::size_t last = yours.y.size() - 1;
  finding.got = number(yours.y[last]) + " J after step " + std::to_string(last) + ", and " +
                number(yours.y[last - 1]) + " J before it";
  finding.error = number(yours.y[last] - yours.y[last - 1], 3) + " J gained";
  finding.tolerance = "none";
  finding.tolerance_from =
      "on springs backward Euler loses (v_new - v_old)^2 / 2 and the same of "
      "each stretch, far more than rounding while the chain still moves";
  if (!falls) {
    finding.hint =
        "What gains energy has its force from the start. Is every x and v of the force "
        "a new one?";
    finding.diagnoses = what_is_wrong(before, beads, before.tolerance(beads).value);
    finding.plot = {"Energy", "time [s]", "energy [J]", {yours}};
  }
  check(finding);
}

TEST_CASE("a hundred thousand beads take a step in the time that there is",
          "[4-implicit/chain-of-beads][3 points]") {
  Student student;
  Random random;
  constexpr auto most = static_cast<std::size_t>(harness_bounds::beads.largest());
  // A copy of a column for each bead is quick enough once or twice.
  for (int n = 0; n < 8; ++n) {
    meets_its_lines(student, Chain::draw(random, most, random.between(1000, 2500)),
                    "Elimination touches one row below each row. Do you visit others, or iterate "
                    "until it looks right?");
  }
}

TEST_CASE("any chain ends where its slope leads back, short or long, soft or stiff, at rest or not",
          "[4-implicit/chain-of-beads][1 point]") {
  Student student;
  Random random;
  const auto check = [&](const Chain& chain) {
    meets_its_lines(student, chain,
                    "Is a spring so soft or so hard here, a chain so long, or so much zero that a "
                    "line of yours does something of its own?");
  };
  constexpr int pairs = 150, long_ones = 5;
  for (int n = 0; n < pairs; ++n) {
    const auto count = static_cast<std::size_t>(random.whole(1, 6));
    const Chain one = Chain::anywhere(random, count);
    Chain other = Chain::anywhere(random, count);
    other.h = one.h;
    check(one);
    check(other);
  }
  for (int n = 0; n < long_ones; ++n) {
    for (const double most : {1e2, 1e3, 1e4, 2e4})
      check(Chain::anywhere(random, static_cast<std::size_t>(random.octaves(most / 10, most))));
  }
}
