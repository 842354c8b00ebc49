// SPDX-License-Identifier: MIT-0
#include <catch2/catch_test_macros.hpp>

#include "format_values.h"
#include "harness.h"
#include "integrate/dopri5.h"
#include "judge/describe.h"
#include "judge/diagnose.h"
#include "judge/random.h"
#include "judge/session.h"
#include "judge/tests.h"
#include "scene.h"

using namespace judge;
using namespace judge::any_table;

namespace {

double hundredths(Random& random, int low, int high) {
  return random.whole(low, high) / 100.0;
}

// Its weights add up to one, as in every method that is of use.
ButcherTable draw(Random& random, std::size_t stages, int least = -30) {
  ButcherTable table{"the method of a table with " + std::to_string(stages) + " stages", {}, {}};
  double left = 1;
  for (std::size_t i = 0; i < stages; ++i) {
    table.parts.emplace_back();
    for (std::size_t j = 0; j < i; ++j) table.parts[i].push_back(hundredths(random, least, 60));
    table.weights.push_back(i + 1 < stages ? hundredths(random, 10, 50) : left);
    left -= table.weights[i];
  }
  return table;
}

ButcherTable dormand_prince() {
  using W = integrate::Dopri5Weights;
  return {"Dormand and Prince's method",
          {{},
           {W::a21},
           {W::a31, W::a32},
           {W::a41, W::a42, W::a43},
           {W::a51, W::a52, W::a53, W::a54},
           {W::a61, W::a62, W::a63, W::a64, W::a65}},
          {W::a71, 0, W::a73, W::a74, W::a75, W::a76}};
}

std::string described(const std::vector<double>& row) {
  std::string text = "(";
  for (const double value : row) text += (text == "(" ? "" : ", ") + grade::number(value, 17);
  return text + ")";
}

// A student who has been given a table, and a finding that says which: without it no case can be
// tried again at home.
class Given {
 public:
  Given(Student& student, const ButcherTable& table) {
    std::vector<double> numbers{static_cast<double>(table.parts.size())};
    std::string rows;
    for (const auto& row : table.parts) {
      numbers.insert(numbers.end(), row.begin(), row.end());
      rows += (rows.empty() ? "" : " ") + described(row);
    }
    numbers.insert(numbers.end(), table.weights.begin(), table.weights.end());
    rows += ", weights " + described(table.weights);
    student.call(0, numbers, 0);
    session().given = ", rows " + rows;
  }
  ~Given() { session().given.clear(); }
};

grade::Finding compare(Student& student, const ButcherTable& table, const Scene& scene,
                       const std::string& hint) {
  const Method method = method_of(table);
  const auto by = [&](const Method& other) {
    return watch(other, scene.start, scene.h, scene.steps, scene.acceleration);
  };
  const Path yours = student.watch(scene.start, scene.h, scene.steps, scene.acceleration, 1);
  const Path right = by(method);
  const State &got = yours.states.back(), &expected = right.states.back();

  grade::Finding finding = off_by(distance(got, expected), scene.tolerance);
  finding.asked = scene.asked;
  finding.input = describe(scene.start) + ", h = " + grade::number(scene.h, 17);
  finding.expected = describe(expected);
  finding.got = describe(got);
  if (!finding.held) {
    finding.hint = hint;
    finding.diagnoses = diagnose(yours, method, by);
  }
  return finding;
}

// Five coarse steps under a force that doesn't change with time: what is wrong with the clock alone
// is seen by the other tests.
void follows(Student& student, const ButcherTable& table, Random& random) {
  constexpr int steps = 5;
  Scene scene{random.start(), random.between(0.12, 0.25), steps, {}, {}, {}};
  const harness::Force wild = random.wild();
  scene.acceleration = [=](const Vec& x, const Vec& v, double) { return wild(x, v, 0); };
  const Path right = run(method_of(table), scene.start, scene.h, steps, steps, scene.acceleration);
  scene.tolerance = rounding(steps, 1 + distance(right.states.back(), State{}));
  scene.asked = "where " + std::to_string(steps) + " steps of " + table.name +
                " end, under a force that doesn't change with time";
  check(compare(student, table, scene,
                "The number of stages is the number of rows, from one to as many as a table has. "
                "Start each step with nothing in hand."));
}

// Steps two bodies by turns, at one time, and the first of them again at another.
void moves_two(Student& student, const ButcherTable& table, Random& random) {
  double t = random.anywhere(harness_bounds::time);
  const Gentle push{random.vector(-3, 3)};
  const Start bodies[] = {Scene::anywhere(random), Scene::anywhere(random)};
  double h = random.anywhere(harness_bounds::h);
  for (const int body : {0, 1, 0}) {
    Scene scene{bodies[body], h, 1, push, {}, "a step of " + table.name};
    scene.start.t = t;
    scene.tolerance = rounding_of_a_step(table, scene.start, h);
    scene.asked += ", among those of two bodies and of many tables by turns";
    grade::Finding finding =
        compare(student, table, scene,
                "Which number of the table is so large, so small, or so equal to another that a "
                "line of yours does something of its own?");
    if (!finding.held) {
      Student fresh;
      const Given again(fresh, table);
      if (compare(fresh, table, scene, "").held)
        finding.diagnoses.push_back(
            "in a program that has just begun this step is right: what is remembered?");
    }
    check(finding);
    h = random.anywhere(harness_bounds::h);
    if (body == 1) t = random.anywhere(harness_bounds::time);
  }
}

}  // namespace

TEST_CASE("a table that nobody has published is followed to rounding",
          "[3-runge-kutta/any-table][3 points]") {
  Student student;
  Random random;
  const ButcherTable table = draw(random, 4, 1);
  const Given given(student, table);
  is_method(student, method_of(table),
            "A stage may go along every slope before it, and each of the sums starts at the start "
            "of the step.",
            1);
}

TEST_CASE("each stage asks once, at the time that its row adds up to",
          "[3-runge-kutta/any-table][2 points]") {
  Student student;
  Random random;
  const ButcherTable table = draw(random, 3, 1);
  const Given given(student, table);
  evaluates(student, method_of(table), 3, 0,
            "Once for each row. The clock of a stage is t plus h times the sum of that row.", 1);
}

TEST_CASE("with Kutta's table of three rows half the step divides the error by eight",
          "[3-runge-kutta/any-table][2 points]") {
  Student student;
  const Given given(
      student, {"Kutta's method of order 3", {{}, {0.5}, {-1, 2}}, {1.0 / 6, 4.0 / 6, 1.0 / 6}});
  has_order(student, 3, 256,
            "The third row goes back along the first slope and twice as far along the second.", 1);
}

TEST_CASE("a short table after Dormand and Prince's finds nothing of it left",
          "[3-runge-kutta/any-table][2 points]") {
  Student student;
  Random random;
  std::vector<ButcherTable> tables{draw(random, 2), dormand_prince(), draw(random, 3)};
  for (const double rows : harness_bounds::rows.asked())
    tables.push_back(draw(random, static_cast<std::size_t>(rows)));
  for (const ButcherTable& table : tables) {
    const Given given(student, table);
    follows(student, table, random);
  }
}

TEST_CASE("any table is followed, whatever its rows and its weights add up to",
          "[3-runge-kutta/any-table][1 point]") {
  Student student;
  Random random;
  constexpr int tables = 120;
  for (int n = 0; n < tables; ++n) {
    const ButcherTable table = of_any_numbers(random);
    const Given given(student, table);
    moves_two(student, table, random);
  }
}
