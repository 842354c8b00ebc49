// SPDX-License-Identifier: MIT-0
#include <algorithm>
#include <catch2/catch_test_macros.hpp>

#include "format_values.h"
#include "harness.h"
#include "judge/describe.h"
#include "judge/random.h"
#include "judge/session.h"
#include "judge/tests.h"
#include "scene.h"

using namespace judge;
using scene::Scene;

namespace {

using grade::number;

constexpr double spare = 0.1;
constexpr int runs = 4;
constexpr int most_steps = 100'000;  // that the judge runs

struct Answer {
  double said = 0;
  int steps = 0;  // 0 if it said no number that can be run
  double error = INFINITY;
  std::vector<Evaluation> asked;

  std::size_t evaluations() const { return asked.size(); }
};

// The harness takes the wanted error as the time at the start, and the duration as h.
Answer ask(Student& student, const Scene& scene) {
  const Start start{scene.start.x, scene.start.v, scene.wanted};
  const Path path = student.watch(start, scene.duration, 1, scene.acceleration);
  Answer answer;
  answer.said = path.states.back().x.x;
  if (answer.said >= 1 && answer.said <= most_steps) {
    answer.steps = static_cast<int>(answer.said);
    answer.error = scene.error(answer.steps);
  }
  answer.asked = path.evaluations;
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

// The steps of the finest run of Euler's method that was made: where two questions are nearest in
// time. 0 if there is none.
int finest_run(const Scene& scene, const Answer& answer) {
  double shortest = INFINITY;
  for (std::size_t n = 1; n < answer.asked.size(); ++n) {
    const double apart = answer.asked[n].t - answer.asked[n - 1].t;
    if (apart > 0) shortest = std::min(shortest, apart);
  }
  return static_cast<int>(std::min(1e6, std::round(scene.duration / shortest)));
}

// The diagnosis of first questions that are no run of Euler's method.
std::string another_method(const Scene& scene, const Answer& answer) {
  const auto [x, v, none] = scene.start;
  const Evaluation &second = answer.asked[1],
                   &third = answer.asked[std::min<std::size_t>(2, answer.asked.size() - 1)];
  const auto is_at = [](const Evaluation& question, const Vec& place) {
    return length(question.x - place) <= 1e-9 * (1 + length(place));
  };
  const double h = second.t;
  if (!is_at(second, x + h * v))
    return "the second question is not where a step of Euler's method leads: x takes the old v";
  const Vec after = v + h * scene.acceleration(x, v, 0);
  const bool goes_on = third.t == 2 * h, asks_again = h > 0 && third.t == h && &third != &second;
  if ((goes_on && !is_at(third, x + h * v + h * after)) || asks_again)
    return "the third question is not where a second step of Euler's method leads: your first run "
           "is by another method, whose error says nothing about Euler's";
  return "";
}

std::vector<std::string> what_is_wrong(const Scene& scene, const Answer& answer) {
  if (answer.steps == 0)
    return {"the judge runs 1 to " + std::to_string(most_steps) + " steps, and " +
            std::to_string(scene.fewest) + " would do"};
  if (answer.evaluations() < 2) return {"it asked for the acceleration once at most"};
  if (length(answer.asked.front().x - scene.start.x) > 0)
    return {"the first question is not at the start, and every run begins there"};
  const int finest = finest_run(scene, answer);
  if (finest == 0) return {"every question is for one time; the push changes with the time"};
  if (const std::string other = another_method(scene, answer); !other.empty()) return {other};
  const auto at_the_end = [&](const Evaluation& asked) {
    return asked.t > scene.duration * (1 - 1e-9);
  };
  if (std::ranges::any_of(answer.asked, at_the_end))
    return {"a step begins where the run ends, at " + number(scene.duration) +
            " s: a step too many, so that no run ends where it should"};
  const auto same_time = [](const Evaluation& a, const Evaluation& b) { return a.t == b.t; };
  if (std::adjacent_find(answer.asked.begin(), answer.asked.end(), same_time) != answer.asked.end())
    return {};  // another method, whose steps can't be told like this
  const std::string many = std::to_string(finest), of_yours = "the finest of your runs, in " + many;
  if (finest > 2 * answer.steps)
    return {of_yours + " steps, cost more than the replay itself, which takes " +
            std::to_string(answer.steps)};
  if (finest * 8 < answer.steps)
    return {of_yours + " steps, is too coarse to tell how the error goes on"};
  return {};
}

enum Asked { error, steps, price, both };

// A number that is far too large would reach any error, and excuse any price.
bool will_do(const Scene& scene, const Answer& answer) {
  return answer.error <= scene.wanted && answer.steps < 3 * scene.fewest;
}

bool holds(Asked what, const Scene& scene, const Answer& answer) {
  const bool few = answer.steps <= (1 + spare) * scene.fewest;
  const bool cheap = answer.evaluations() <= static_cast<std::size_t>(runs * answer.steps);
  return will_do(scene, answer) && (few || what == error || what == price) &&
         (cheap || what == error || what == steps);
}

std::string expected(Asked what, const Scene& scene) {
  const std::string within = "an error of at most " + number(scene.wanted) + " m, in ";
  const std::string fewest = std::to_string(scene.fewest) + " steps";
  if (what == both)
    return within + fewest +
           ", or up to a tenth more, and at most 4 evaluations for each step of the answer";
  if (what == steps) return within + fewest + ", or up to a tenth more";
  const std::string rough = within + "less than three times " + fewest;
  return what == error ? rough : rough + ", and at most 4 evaluations for each step of the answer";
}

std::string described(const Answer& answer) {
  const std::string found = ", found with " + std::to_string(answer.evaluations()) + " evaluations";
  if (answer.steps == 0) return number(answer.said, 10) + " steps" + found;
  return std::to_string(answer.steps) + " steps, which end with an error of " +
         number(answer.error) + " m" + found;
}

std::string distance(const Scene& scene, const Answer& answer) {
  const double more = 100 * (answer.said - scene.fewest) / scene.fewest;
  return number(std::abs(more), 3) + (more >= 0 ? " % more" : " % fewer") +
         " steps than it takes; " +
         number(static_cast<double>(answer.evaluations()) / std::max(1.0, answer.said), 3) +
         " evaluations for each of them";
}

void affords(Student& student, const Scene& scene, Asked what, const std::string& hint) {
  const Answer answer = ask(student, scene);
  grade::Finding finding;
  finding.held = holds(what, scene, answer);
  finding.asked =
      "the number of steps of Euler's method for a wanted error, under a force that only the judge "
      "knows";
  finding.input = describe(scene.start) + ", duration = " + number(scene.duration, 17) +
                  " s, wanted = " + number(scene.wanted, 17) + " m";
  finding.expected = expected(what, scene);
  finding.got = described(answer);
  finding.error = distance(scene, answer);
  finding.tolerance = what == steps || what == both ? "0 to 10 %" : "0 to 200 %";
  if (what == price || what == both) finding.tolerance += ", and 4 evaluations";
  finding.tolerance_from =
      "the task; at a quarter of these steps the error is in proportion to the step within 1 %";
  if (!finding.held) {
    finding.hint = what == price && !will_do(scene, answer)
                       ? "See first that the number of steps is right."
                       : hint;
    finding.diagnoses = what_is_wrong(scene, answer);
    Student fresh;
    if (holds(what, scene, ask(fresh, scene)))
      finding.diagnoses = {"in a program that has just begun this is right: what is remembered?"};
    finding.plot = plot(scene, answer);
  }
  check(finding);
}

}  // namespace

TEST_CASE("the thing ends within the wanted error, in less than three times the fewest steps",
          "[2-euler/steps-you-can-afford][3 points]") {
  Student student;
  Random random;
  for (const double duration : random.all_of(harness_bounds::duration, 2)) {
    affords(student, scene::draw(random, {duration}), error,
            "Trust two runs only if the finer has about as many steps as your answer, and leave a "
            "margin.");
  }
}

TEST_CASE("the steps are the fewest that will do, or up to a tenth more",
          "[2-euler/steps-you-can-afford][3 points]") {
  Student student;
  Random random;
  for (int n = 0; n < 3; ++n) {
    affords(student, scene::draw(random, {random.between(harness_bounds::duration)}), steps,
            "The error is in proportion to the step. From one error that you know, which number of "
            "steps has the wanted one?");
  }
}

TEST_CASE("finding out steps that will do costs no more than four runs",
          "[2-euler/steps-you-can-afford][3 points]") {
  Student student;
  Random random;
  affords(student, scene::draw(random, {random.between(harness_bounds::duration)}), price,
          "Stop doubling as soon as the answer is in sight. You need not run it to know it.");
}

TEST_CASE("the steps are right from hundreds to thousands, at rest or fast, and by turns",
          "[2-euler/steps-you-can-afford][1 point]") {
  Random random;
  constexpr int scenes = 12;
  const std::vector<Scene> all = scene::all_kinds(random, scenes);
  for (std::size_t n = 0; n < all.size(); n += 2) {
    Student student;  // one for two that last equally long
    for (const Scene& scene : {all[n], all[n + 1]})
      affords(student, scene, both,
              "The same search does for few steps and for many, for a weak push and for a thing at "
              "rest. Which of these numbers is so small or so large that a line of yours does "
              "something of its own?");
  }
}
