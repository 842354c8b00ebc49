// SPDX-License-Identifier: MIT-0
#include <catch2/catch_test_macros.hpp>

#include "format_values.h"
#include "judge/describe.h"
#include "judge/random.h"
#include "judge/session.h"
#include "judge/tests.h"
#include "judge/waves.h"

using namespace judge;

namespace {

using grade::number;

constexpr double spare = 0.1;
constexpr int runs = 4;

struct Scene {
  Acceleration acceleration;
  Start start;
  double duration;
  Vec end;     // where it is without any error [m]
  int fewest;  // steps of Euler's method that end within the wanted error
  double wanted;

  double error(int steps) const {
    const Path path = run(euler, start, duration / steps, steps, steps, acceleration);
    return length(path.states.back().x - end);
  }
};

// One in which the error of a quarter of the steps is four times as large, within a hundredth, so
// that a good guess can be made from shorter runs.
Scene draw(Random& random) {
  for (;;) {
    const harness::Force force = random.wild();
    const Waves gusts{random, 0.5, 3, 3};
    Scene scene{[=](const Vec& x, const Vec& v, double t) { return force(x, v, t) + gusts(x, t); },
                random.start(),
                random.between(0.8, 1.6),
                {},
                0,
                0};
    scene.start.t = 0;
    scene.end =
        truth(scene.start, scene.duration / 512, 512, 512, scene.acceleration).states.back().x;
    scene.fewest = random.whole(600, 1200);
    scene.wanted = scene.error(scene.fewest);
    const double quarter = scene.error(scene.fewest / 4) * (scene.fewest / 4) / scene.fewest;
    if (std::abs(quarter / scene.wanted - 1) < 0.01) return scene;
  }
}

struct Answer {
  int steps = 0;
  std::size_t evaluations = 0;
  double error = INFINITY;
};

// The harness takes the wanted error as the time at the start, and the duration as h.
Answer ask(Student& student, const Scene& scene) {
  const Start start{scene.start.x, scene.start.v, scene.wanted};
  const Path path = student.watch(start, scene.duration, 1, scene.acceleration);
  Answer answer;
  const double steps = path.states.back().x.x;
  if (steps >= 1 && steps <= 100000) {
    answer.steps = static_cast<int>(steps);
    answer.error = scene.error(answer.steps);
  }
  answer.evaluations = path.evaluations.size();
  return answer;
}

grade::Plot plot(const Scene& scene, const Answer& answer) {
  grade::Curve yours{"yours", {}, {}}, all{"Euler's method", {}, {}}, wanted{"wanted", {}, {}};
  for (int steps = 16; steps <= 8 * scene.fewest; steps *= 2) {
    all.x.push_back(steps);
    all.y.push_back(scene.error(steps));
    wanted.x.push_back(steps);
    wanted.y.push_back(scene.wanted);
  }
  if (answer.steps > 0) {
    yours.x = {answer.steps * 0.97, answer.steps * 1.03};
    yours.y = {answer.error, answer.error};
  }
  grade::Plot plot{"Error and steps", "steps", "error at the end [m]", {yours, all, wanted}};
  plot.logarithmic = true;
  return plot;
}

std::vector<std::string> recognise(const Scene& scene, const Answer& answer) {
  const double ratio = static_cast<double>(answer.steps) / scene.fewest;
  const double push = length(scene.acceleration(scene.start.x, scene.start.v, 0));
  std::vector<std::string> found;
  if (std::abs(ratio - 2) < 0.15) {
    found.push_back(
        "twice the steps: two runs, one with half the steps of the other, differ by "
        "the error of the finer one");
  }
  if (std::abs(ratio - 0.5) < 0.04) {
    found.push_back("half the steps that it takes");
  } else if (ratio > 0.3 && ratio < 0.5) {
    found.push_back(
        "between a third and a half of the steps that it takes: did you let the error "
        "fall with the square of the step?");
  }
  if (std::abs(answer.steps - push * scene.duration * scene.duration / 2 / scene.wanted) < 2) {
    found.push_back("this is right for a push that never changes");
  }
  if ((answer.steps & (answer.steps - 1)) == 0 && answer.steps > 1) {
    found.push_back("a power of two: the fewest steps lie between this and its half");
  }
  return found;
}

enum Asked { error, steps, price };

// An answer that is far too large would reach any error, and excuse any price.
bool sensible(const Scene& scene, const Answer& answer) {
  return answer.error <= scene.wanted && answer.steps <= 2 * scene.fewest + 100;
}

bool holds(Asked what, const Scene& scene, const Answer& answer) {
  const bool few = answer.steps <= (1 + spare) * scene.fewest;
  const bool cheap = answer.evaluations <= static_cast<std::size_t>(runs * answer.steps);
  return sensible(scene, answer) && (what != steps || few) && (what != price || cheap);
}

std::string expected(Asked what, const Scene& scene) {
  const std::string within = "an error of at most " + number(scene.wanted) + " m";
  if (what == error) return within;
  if (what == price) return within + ", and at most 4 evaluations for each step of the answer";
  return within + " in at most a tenth more than " + std::to_string(scene.fewest) + " steps";
}

void affords(Student& student, Random& random, Asked what, const std::string& hint) {
  const Scene scene = draw(random);
  const Answer answer = ask(student, scene);
  grade::Finding finding;
  finding.held = holds(what, scene, answer);
  finding.asked =
      "the number of steps of Euler's method for a wanted error, under a force that only the judge "
      "knows";
  finding.input = describe(scene.start) + ", duration = " + number(scene.duration, 17) +
                  " s, wanted = " + number(scene.wanted, 17) + " m";
  finding.expected = expected(what, scene);
  finding.got = std::to_string(answer.steps) + " steps, which end with an error of " +
                number(answer.error) + " m, found with " + std::to_string(answer.evaluations) +
                " evaluations";
  finding.error = number(100.0 * (answer.steps - scene.fewest) / scene.fewest, 3) +
                  " % more steps than the fewest; " +
                  number(static_cast<double>(answer.evaluations) / std::max(1, answer.steps), 3) +
                  " evaluations for each";
  finding.tolerance = "0 to 10 %, and 4 evaluations";
  finding.tolerance_from =
      "the task; at a quarter of these steps the error is in proportion to the step within 1 %";
  if (!finding.held) {
    finding.hint = what == price && !sensible(scene, answer)
                       ? "See first that the number of steps is right."
                       : hint;
    finding.diagnoses = recognise(scene, answer);
    finding.plot = plot(scene, answer);
  }
  check(finding);
}

}  // namespace

TEST_CASE("the thing ends within the wanted error", "[2-euler/steps-you-can-afford][4 points]") {
  Student student;
  Random random;
  for (int n = 0; n < 3; ++n) {
    affords(student, random, error,
            "Trust two runs only if the finer has about as many steps as your answer, and leave a "
            "margin.");
  }
}

TEST_CASE("no more than a tenth of the steps could be spared",
          "[2-euler/steps-you-can-afford][3 points]") {
  Student student;
  Random random;
  for (int n = 0; n < 3; ++n) {
    affords(student, random, steps,
            "The error is in proportion to the step. From one error that you know, which number of "
            "steps has the wanted one?");
  }
}

TEST_CASE("finding out costs no more than four runs", "[2-euler/steps-you-can-afford][3 points]") {
  Student student;
  Random random;
  affords(student, random, price,
          "Stop doubling as soon as the answer is in sight. You need not run it to know it.");
}
