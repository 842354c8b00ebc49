// SPDX-License-Identifier: MIT-0
#include <catch2/catch_test_macros.hpp>

#include "format_values.h"
#include "harness.h"
#include "judge/random.h"
#include "judge/session.h"
#include "judge/tests.h"
#include "scene.h"

using namespace judge;
using namespace judge::verlet;
using namespace judge::verlet::pulls_for_a_curtain;

namespace {

using grade::number;

enum Function { stretch, plan };

constexpr int scenes = 4;  // in each test, so that no lucky guess passes

// A curtain of which a move costs so many times what a pull costs.
Curtain draw(Random& random, double frame, double least, double most) {
  Curtain curtain{random.whole(20, 40), frame, random.between(0.02, 0.08), 0,
                  random.between(0.1, 0.3)};
  curtain.move = curtain.pull * random.between(least, most);
  return curtain;
}

bool is_right_here(const Way& way, const Curtain& curtain) {
  const Split theirs = way.best(curtain);
  return curtain.price(theirs) <= curtain.price(right.best(curtain)) &&
         hung_up(curtain.links, curtain.frame, theirs) <= curtain.most;
}

// Scenes as they come, but that in each of the first one of the ways that are often right is not.
std::vector<Curtain> telling(Random& random, double least, double most) {
  std::vector<Curtain> curtains;
  for (const Way& way : often_right) {
    curtains.push_back(draw(random, 1.0 / 60, least, most));
    while (is_right_here(way, curtains.back()))
      curtains.back() = draw(random, 1.0 / 60, least, most);
  }
  while (curtains.size() < scenes) curtains.push_back(draw(random, 1.0 / 60, least, most));
  return curtains;
}

Curtain draw_anywhere(Random& random) {
  return {static_cast<int>(std::lround(random.anywhere(harness_bounds::links))),
          random.anywhere(harness_bounds::frame), random.anywhere(harness_bounds::most),
          random.anywhere(harness_bounds::move), random.anywhere(harness_bounds::pull)};
}

// The curtain with all numbers at the one end, and that with all at the other.
std::vector<Curtain> at_the_bounds() {
  const auto all = [](double (harness::Bounds::*end)() const) {
    return Curtain{static_cast<int>((harness_bounds::links.*end)()), (harness_bounds::frame.*end)(),
                   (harness_bounds::most.*end)(), (harness_bounds::move.*end)(),
                   (harness_bounds::pull.*end)()};
  };
  return {all(&harness::Bounds::smallest), all(&harness::Bounds::largest)};
}

// Checks that a judge can count substeps and iterations, and that there is one of each at least:
// else there is nothing to hang up.
void is_plan(const Curtain& curtain, double substeps, double iterations) {
  grade::Finding finding;
  constexpr double most = 1e6;
  finding.held = substeps >= 1 && iterations >= 1 && substeps <= most && iterations <= most;
  finding.asked = "a plan";
  finding.input = curtain.in_words();
  finding.expected = "at least one substep, and one iteration, and a million of each at most";
  finding.got = "substeps = " + number(substeps) + ", iterations = " + number(iterations);
  finding.error = "no plan";
  finding.tolerance = "none";
  finding.tolerance_from = "a frame has at least one step, and a link must be pulled";
  finding.hint = "Where does a number below one come from? From a root that was cut off?";
  check(finding);
}

Split plan_of(Student& student, const Curtain& curtain) {
  const std::vector<double> got = student.call(
      plan,
      {static_cast<double>(curtain.links), curtain.frame, curtain.most, curtain.move, curtain.pull},
      2);
  is_plan(curtain, got[0], got[1]);
  return {static_cast<int>(got[0]), static_cast<int>(got[1])};
}

// Plans of a dozen scenes more, since in one many mistakes have the same; and what there is to say
// of this plan alone.
std::vector<std::string> why(Student& student, const Curtain& curtain, const Split& yours) {
  Random random;
  for (const double rate : {24, 60, 120}) {
    for (const double most : {0.5, 2.0, 8.0, 12.0})
      plan_of(student, draw(random, 1 / rate, most / 2, most));
  }
  return why_wrong(curtain, yours);
}

// The price first, so that no plan takes the judge longer than the right one.
void is_cheap(Student& student, const Curtain& curtain, const Split& yours) {
  const Split best = right.best(curtain);
  const double price = curtain.price(yours), least = curtain.price(best);
  grade::Finding finding;
  finding.held = price <= least * (1 + 1e-12);
  finding.asked = "the cheapest plan that the rule allows";
  finding.input = curtain.in_words();
  finding.expected = "a price of at most " + number(least) + " us a link";
  finding.got = yours.in_words() + ": " + number(price) + " us a link";
  finding.error = number(100 * (price / least - 1), 3) + " % too dear";
  finding.tolerance = "none but rounding";
  finding.tolerance_from = "the judge tries every number of iterations up to that of the links";
  if (!finding.held) {
    finding.hint = "What is the price of n iterations, each with as few substeps as will do?";
    finding.diagnoses = why(student, curtain, yours);
  }
  check(finding);
}

void holds(Student& student, const Curtain& curtain, const Split& yours) {
  const double stretched = hung_up(curtain.links, curtain.frame, yours);
  grade::Finding finding;
  finding.held = stretched <= curtain.most;
  finding.asked = "a rope, hung up with your plan for a minute";
  finding.input = curtain.in_words() + ", " + yours.in_words();
  finding.expected = "stretched by at most " + number(curtain.most) + " m";
  finding.got = number(stretched) + " m";
  finding.error = number(stretched - curtain.most, 3) + " m too long";
  finding.tolerance = number(curtain.most) + " m";
  finding.tolerance_from =
      "what the curtain may stretch; the rule foretells a little more than the "
      "rope does, so that a plan by the rule holds";
  if (!finding.held) {
    finding.hint = "Is the number of substeps rounded up, and does the step count twice?";
    finding.diagnoses = why(student, curtain, yours);
  }
  check(finding);
}

// Checks a stretch by the rule, with n (n - 1); to hang up hundreds of ropes for a minute each
// would take too long.
void keeps_to_the_rule(Student& student, const Curtain& curtain, const Split& yours) {
  const double foretold = one_link_less(curtain, yours);
  grade::Finding finding =
      off_by(std::max(0.0, foretold - curtain.most), rounding(curtain.most), " m");
  finding.asked = "a plan that keeps to the rule";
  finding.input = curtain.in_words() + ", " + yours.in_words();
  finding.expected = "foretold to stretch by at most " + number(curtain.most) + " m";
  finding.got = number(foretold) + " m";
  if (!finding.held) {
    finding.hint = "Is the number of substeps rounded up, and does the step count twice?";
    finding.diagnoses = why(student, curtain, yours);
  }
  check(finding);
}

void check_plan(Student& student, const Curtain& curtain) {
  const Split yours = plan_of(student, curtain);
  is_cheap(student, curtain, yours);
  holds(student, curtain, yours);
}

}  // namespace

TEST_CASE("the stretch is foretold within a seventh", "[5-verlet/pulls-for-a-curtain][2 points]") {
  Random random;
  Student student;
  struct Rope {
    int links;
    double frame;
  };
  std::vector<Rope> ropes;
  for (int n = 0; n < scenes; ++n)
    ropes.push_back({random.whole(20, 40), 1.0 / random.whole(30, 144)});
  for (const Curtain& curtain : at_the_bounds()) ropes.push_back({curtain.links, curtain.frame});
  for (const auto& [links, frame] : ropes) {
    const Split split{random.whole(4, 10), random.whole(1, links / 4)};
    const double measured = hung_up(links, frame, split);
    const double got =
        student.call(stretch,
                     {static_cast<double>(links), frame, static_cast<double>(split.substeps),
                      static_cast<double>(split.iterations)},
                     1)[0];
    grade::Finding finding = off_by(std::abs(got - measured),
                                    {measured / 7,
                                     "the rule holds within a seventh while the iterations are "
                                     "few beside the links: here a quarter at most"},
                                    " m");
    finding.asked = "how much too long a rope hangs";
    finding.input = "links = " + std::to_string(links) + ", frame = " + number(frame, 17) + ", " +
                    split.in_words();
    finding.expected = number(measured) + " m";
    finding.got = number(got) + " m";
    if (!finding.held) {
      finding.hint =
          "Which of the numbers count twice in the rule? And how long is a step, if the frame is "
          "split?";
    }
    check(finding);
  }
}

TEST_CASE("where a move is cheap the curtain holds at the least price",
          "[5-verlet/pulls-for-a-curtain][2 points]") {
  Random random;
  Student student;
  for (const Curtain& curtain : telling(random, 0.1, 0.9)) check_plan(student, curtain);
}

TEST_CASE("where a move costs many pulls the curtain holds at the least price",
          "[5-verlet/pulls-for-a-curtain][3 points]") {
  Random random;
  Student student;
  for (const Curtain& curtain : telling(random, 4, 12)) check_plan(student, curtain);
}

TEST_CASE("at every frame rate the curtain holds at the least price",
          "[5-verlet/pulls-for-a-curtain][2 points]") {
  Random random;
  Student student;
  for (const double rate : {24, 30, 90, 120}) {
    Curtain curtain = draw(random, 1 / rate, 0.5, 8);
    while (is_right_here({by_rule, shared}, curtain)) curtain = draw(random, 1 / rate, 0.5, 8);
    check_plan(student, curtain);
  }
  for (const Curtain& curtain : at_the_bounds()) check_plan(student, curtain);
}

TEST_CASE("any curtain keeps to the rule at the least price",
          "[5-verlet/pulls-for-a-curtain][1 point]") {
  Random random;
  Student student;
  constexpr int curtains = 300;
  for (int n = 0; n < curtains; ++n) {
    const Curtain curtain = draw_anywhere(random);
    const Split yours = plan_of(student, curtain);
    keeps_to_the_rule(student, curtain, yours);
    is_cheap(student, curtain, yours);
  }
}
