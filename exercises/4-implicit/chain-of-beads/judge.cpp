// SPDX-License-Identifier: MIT-0
#include <algorithm>
#include <catch2/catch_test_macros.hpp>
#include <cmath>

#include "format_values.h"
#include "judge/random.h"
#include "judge/session.h"
#include "judge/tests.h"

using namespace judge;

namespace {

using grade::number;
using Column = std::vector<double>;

struct Beads {
  Column x, v;
};

struct Chain {
  Beads start;
  Column k;
  double h = 0;

  // How stiff the springs are beside the step: h^2 k up to this.
  static Chain draw(Random& random, std::size_t count, double stiff) {
    Chain chain;
    chain.h = random.between(0.01, 0.04);
    for (std::size_t i = 0; i < count; ++i) {
      chain.start.x.push_back(random.between(-0.3, 0.3));
      chain.start.v.push_back(random.between(-1, 1));
      chain.k.push_back(random.between(0.1, 1) * stiff / (chain.h * chain.h));
    }
    return chain;
  }

  std::size_t count() const { return k.size(); }

  Beads after_one(Student& student, const Beads& from) const {
    Column n{static_cast<double>(count()), h};
    for (const Column* column : {&from.x, &from.v, &k}) {
      n.insert(n.end(), column->begin(), column->end());
    }
    const Column end = student.call(0, n, 2 * count());
    const auto middle = end.begin() + static_cast<std::ptrdiff_t>(count());
    return {{end.begin(), middle}, {middle, end.end()}};
  }

  double stretch(const Beads& beads, std::size_t i) const {
    return beads.x[i] - (i > 0 ? beads.x[i - 1] : 0);
  }

  double acceleration(const Beads& beads, std::size_t i) const {
    const double left = k[i] * stretch(beads, i);
    return (i + 1 < count() ? k[i + 1] * stretch(beads, i + 1) : 0) - left;
  }

  double energy(const Beads& beads) const {
    double sum = 0;
    for (std::size_t i = 0; i < count(); ++i) {
      sum += (k[i] * stretch(beads, i) * stretch(beads, i) + beads.v[i] * beads.v[i]) / 2;
    }
    return sum;
  }

  // By how much the end misses the two lines of backward Euler at a bead [m/s].
  double miss(const Beads& end, std::size_t i) const {
    const double moved = (end.x[i] - start.x[i]) / h - end.v[i];
    const double kicked = start.v[i] + h * acceleration(end, i) - end.v[i];
    return std::max(std::abs(moved), std::abs(kicked));
  }

  // Each of an end's numbers is a double, so that its lines cannot be met better than to the
  // rounding of what they add up.
  Tolerance tolerance(const Beads& end) const {
    const auto largest = [](const Column& column) {
      double most = 0;
      for (const double value : column) most = std::max(most, std::abs(value));
      return most;
    };
    const double place = largest(end.x) + largest(start.x) + h * largest(end.v);
    const double stiffest = largest(k);
    return rounding(largest(start.v) + largest(end.v) + place / h + 4 * h * stiffest * place);
  }

  std::string described() const {
    std::string text = std::to_string(count()) + " beads, h = " + number(h, 17);
    if (count() > 6) return text + ", and stiffnesses drawn from the seed";
    for (std::size_t i = 0; i < count(); ++i) {
      text += "; bead " + std::to_string(i) + ": x = " + number(start.x[i], 17) +
              ", v = " + number(start.v[i], 17) + ", k = " + number(k[i], 17);
    }
    return text;
  }
};

std::size_t worst(const Chain& chain, const Beads& end) {
  std::size_t found = 0;
  for (std::size_t i = 0; i < chain.count(); ++i) {
    if (!std::isfinite(chain.miss(end, i))) return i;
    if (chain.miss(end, i) > chain.miss(end, found)) found = i;
  }
  return found;
}

std::string who_misses(const Chain& chain, const Beads& end, double within) {
  std::size_t count = 0, first = 0;
  for (std::size_t i = chain.count(); i-- > 0;) {
    if (chain.miss(end, i) <= within) continue;
    ++count;
    first = i;
  }
  return "the lines are missed at " + std::to_string(count) + " of " +
         std::to_string(chain.count()) + " beads, first at bead " + std::to_string(first);
}

std::vector<std::string> recognised(const Chain& chain, const Beads& end, double within) {
  bool still = true, borrowed = true, at_rest = true, moved = true;
  Beads change = end;
  for (std::size_t i = 0; i < chain.count(); ++i) change.x[i] = end.v[i] - chain.start.v[i];
  for (std::size_t i = 0; i < chain.count(); ++i) {
    const double kick = chain.h * chain.acceleration(chain.start, i);
    const double back = chain.h * chain.h * chain.acceleration(change, i);
    still = still && change.x[i] == 0;
    borrowed = borrowed && std::abs(change.x[i] - kick) <= within;
    at_rest = at_rest && std::abs(change.x[i] - kick - back) <= within;
    moved = moved && std::abs((end.x[i] - chain.start.x[i]) / chain.h - end.v[i]) <= within;
  }
  if (still) return {"no velocity changes"};
  if (borrowed) return {"the accelerations are those of the start: nothing is solved"};
  if (at_rest) return {"on the right of a system for the change belongs a(x + h v), not a(x)"};
  if (!moved) return {"the beads do not move with their new velocities"};
  return {who_misses(chain, end, within)};
}

void meets_its_lines(Student& student, const Chain& chain, const std::string& hint) {
  const Beads end = chain.after_one(student, chain.start);
  const std::size_t i = worst(chain, end);
  const Tolerance tolerance = chain.tolerance(end);
  grade::Finding finding = off_by(chain.miss(end, i), tolerance, " m/s");
  finding.asked = "one step of a chain, and whether the slope at its end leads back to the start";
  finding.input = chain.described();
  finding.expected = "at bead " + std::to_string(i) + " the velocity " +
                     number(chain.start.v[i] + chain.h * chain.acceleration(end, i)) +
                     ", which is v_old + h a with the accelerations at your end";
  finding.got = "the velocity " + number(end.v[i]) + ", at the place " + number(end.x[i]);
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
  bool falls = true;
  for (int n = 1; n <= steps && falls; ++n) {
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
    finding.plot = {"Energy", "time [s]", "energy [J]", {yours}};
  }
  check(finding);
}

TEST_CASE("a hundred thousand beads take a step in the time that there is",
          "[4-implicit/chain-of-beads][3 points]") {
  Student student;
  Random random;
  for (int n = 0; n < 2; ++n) {
    meets_its_lines(student, Chain::draw(random, 100000, random.between(1000, 2500)),
                    "Elimination touches one row below each row. Do you visit others, or iterate "
                    "until it looks right?");
  }
}
