// SPDX-License-Identifier: MIT-0
#include <catch2/catch_test_macros.hpp>
#include <cmath>

#include "format_values.h"
#include "harness.h"
#include "judge/random.h"
#include "judge/session.h"
#include "judge/tests.h"
#include "slips.h"

using namespace judge;
using namespace judge::chain_of_beads;

namespace {

using grade::number;

void meets_its_lines(Student& student, const Chain& chain, const std::string& hint) {
  const Beads end = chain.after_one(student, chain.start);
  const std::size_t i = worst(chain, end);
  const Tolerance tolerance = chain.tolerance(end);
  grade::Finding finding = off_by(chain.miss(end, i), tolerance, " m/s");
  finding.asked = "one step of a chain, and whether the slope at its end leads back to the start";
  finding.input = chain.described();
  finding.expected =
      "at each bead x = x_old + h v and v = v_old + h a, all of it taken at your end";
  finding.got = "at bead " + std::to_string(i) + " x = " + number(end.x[i]) +
                ", v = " + number(end.v[i]) + "; there x_old + h v is " +
                number(chain.start.x[i] + chain.h * end.v[i]) + ", and v_old + h a is " +
                number(chain.start.v[i] + chain.h * chain.acceleration(end, i));
  finding.error += ", the most of all beads";
  if (!finding.held) {
    finding.hint = hint;
    finding.diagnoses = recognised(chain, end, tolerance.value);
  }
  check(finding);
}

}  // namespace

TEST_CASE("short chains end where the slope of the end leads back to the start",
          "[4-implicit/chain-of-beads][4 points]") {
  Student student;
  Random random;
  std::vector<Chain> chains;
  for (const int count : {2, 3, random.whole(4, 6)})
    chains.push_back(Chain::draw(random, static_cast<std::size_t>(count), random.between(1, 10)));
  for (const double h : harness_bounds::h.asked())
    chains.push_back(Chain::draw(random, 3, random.between(1, 10), h));
  for (const Chain& chain : chains) {
    meets_its_lines(student, chain,
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
    finding.diagnoses = recognised(before, beads, before.tolerance(beads).value);
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
