// SPDX-License-Identifier: MIT-0
#include <catch2/catch_test_macros.hpp>
#include <cmath>
#include <numbers>

#include "format_values.h"
#include "harness.h"
#include "judge/describe.h"
#include "judge/random.h"
#include "judge/session.h"
#include "judge/tests.h"
#include "remarks.h"
#include "scene.h"

using namespace judge;
using namespace judge::step_by_price;
using grade::number;

namespace {

// The errors of the steps add up, and grow on their way: what the task allows.
double allowed(double tolerance) {
  return 1000 * tolerance;
}

enum Function { told_tolerance, flies, passes };  // see harness.h

// More questions than any test needs; after them nothing pulls any more, so that it ends soon.
constexpr int patience = 15'000;

// The number of questions so far, against time.
grade::Plot plot(const Path& path) {
  grade::Curve yours{"yours", {}, {}};
  for (const Evaluation& evaluation : path.evaluations) {
    yours.x.push_back(evaluation.t);
    yours.y.push_back(static_cast<double>(yours.x.size()));
  }
  return {"Where the questions go", "time [s]", "questions so far", {yours}};
}

constexpr const char* not_near_enough =
    "There were not too many questions; the end is not near enough. Is the better of the two "
    "answers "
    "the one that is kept, and does the estimate look at the velocity, too?";

struct Flight {
  Path path;
  double off = 0, questions = 0;
  double tolerance = 0;
};

Flight watch(Student& student, const Scene& scene, double tolerance, Function function,
             double most = patience) {
  student.call(told_tolerance, {tolerance}, 0);
  int asked = 0;
  const Acceleration counted = [&](const Vec& x, const Vec& v, double t) {
    return ++asked > most ? Vec{} : scene.acceleration(x, v, t);
  };
  const Path path = student.watch(scene.start, scene.duration, 1, counted, function);
  return {path, 0, double(asked), tolerance};
}

Flight fly(Student& student, const Scene& scene, double tolerance) {
  Flight flight = watch(student, scene, tolerance, flies);
  flight.off = distance(flight.path.states.back(), scene.end);
  return flight;
}

std::vector<std::string> looks_like(const Flight& flight) {
  if (flight.questions == 0) return {"it never asked for the acceleration"};
  if (!is_finite(flight.path.states.back())) return {"the end is not finite"};
  if (flight.questions <= patience) return {};
  return {"after " + number(patience) + " questions the judge let nothing pull any more"};
}

// @param evenly  what says that no step was chosen, where a right flight's are of many lengths
void check_flight(const Scene& scene, const Flight& flight, double most, const std::string& why,
                  const std::string& hint, const Signs& signs = {}, const Signs& evenly = {}) {
  const double bound = allowed(flight.tolerance);
  grade::Finding finding;
  finding.held = flight.off <= bound && flight.questions <= most && evenly.empty();
  finding.asked = scene.name + ", with a tolerance of " + number(flight.tolerance, 17);
  finding.input = describe(scene.start) + ", duration = " + number(scene.duration, 17);
  finding.expected =
      "at " + describe(scene.end, 9) + ", for at most " + number(most) + " questions";
  finding.got = "at " + describe(flight.path.states.back(), 9) + ", for " +
                number(flight.questions) + " questions";
  finding.error = number(flight.off, 3) + " m or m/s, and " + number(flight.questions / most, 3) +
                  " times the questions";
  finding.tolerance = number(bound) + " m and m/s, and " + number(most) + " questions";
  finding.tolerance_from = "a thousand times the tolerance, as the task says; " + why;
  if (!finding.held) {
    if (flight.questions > 0) finding.plot = plot(flight.path);
    const Signs seen =
        either(asks_the_same(flight.path), clock_stands(flight.path, scene.duration));
    const Signs others = either(signs, goes_past_the_end(flight.path, scene.duration));
    const Signs ended = either(looks_like(flight), evenly);
    finding.diagnoses = either(seen, either(ended, others));
    if (finding.diagnoses == ended && flight.questions > 0) finding.hint = hint;
  }
  check(finding);
}

// The way that a comet flies from so long after the start until its pass.
double way_left(const Scene& scene, double since) {
  if (!(since > 0 && since < scene.duration)) return INFINITY;
  const State there = truth_past_a_sun(scene.start, since, scene.mu, scene.acceleration);
  return way_to_pass(there, scene.acceleration(there.x, there.v, scene.start.t + since));
}

Flight pass(Student& student, const Scene& scene, double tolerance) {
  Flight flight = watch(student, scene, tolerance, passes, patience_for_a_pass);
  flight.off = way_left(scene, flight.path.states.back().x.x - scene.start.t);
  return flight;
}

void check_pass(const Scene& scene, const Flight& flight) {
  constexpr double most = questions_of_a_pass;
  const double time = flight.path.states.back().x.x, bound = allowed(flight.tolerance);
  grade::Finding finding;
  finding.held = std::abs(flight.off) <= bound && flight.questions <= most;
  finding.asked = "when the comet is nearest to the sun: " + scene.name + ", with a tolerance of " +
                  number(flight.tolerance, 17);
  finding.input = describe(scene.start) + ", duration = " + number(scene.duration, 17);
  finding.expected = "a time at which x . v is zero, for at most " + number(most) + " questions";
  finding.got = number(time, 12) + " s, for " + number(flight.questions) + " questions";
  finding.error =
      (std::isfinite(flight.off) ? number(std::abs(flight.off), 3) + " m of its way"
                                 : "further than can be told") +
      (most > 0 ? ", and " + number(flight.questions / most, 3) + " times the questions" : "");
  finding.tolerance = number(bound) + " m, and " + number(most) + " questions";
  finding.tolerance_from =
      "a thousand times the tolerance, and as many questions, as the task says";
  if (!finding.held) {
    const Given given{scene.start.t,
                      scene.duration,
                      time,
                      flight.off,
                      way_left(scene, time),
                      flight.questions / most,
                      flight.questions > patience_for_a_pass};
    finding.diagnoses = why_not_the_pass(given, flight.path, bound);
    if (flight.questions > 0)
      finding.hint =
          "In which step does x . v turn from below zero to above? From where that step begins, a "
          "shorter one leads to any moment within it.";
    if (flight.questions > 0) finding.plot = plot(flight.path);
  }
  check(finding);
}

// Under a force that the driver evaluates: of many flights nobody counts the questions.
void arrives(Student& student, const Scene& scene, const harness::Force& force, double tolerance) {
  student.call(told_tolerance, {tolerance}, 0);
  const State end = student.run(scene.start, scene.duration, 1, 1, force, flies).states.back();
  grade::Finding finding =
      off_by(distance(end, scene.end),
             {allowed(tolerance), "a thousand times the tolerance, as the task says"}, " m or m/s");
  finding.asked = scene.name + ", with a tolerance of " + number(tolerance, 17);
  finding.input = describe(scene.start) + ", duration = " + number(scene.duration, 17);
  finding.expected = "at " + describe(scene.end, 9);
  finding.got = "at " + describe(end, 9);
  if (!finding.held) {
    finding.hint =
        "Is the start, the duration or the tolerance so small or so large here that a line of "
        "yours does something of its own?";
    if (!is_finite(end)) finding.diagnoses = {"the end is not finite"};
    if (distance(end, {scene.start.x, scene.start.v}) == 0)
      finding.diagnoses = {"it ends where it began"};
  }
  check(finding);
}

}  // namespace

TEST_CASE("a comet costs a fifth of what equal steps cost for the same error",
          "[3-runge-kutta/step-by-price][2 points]") {
  Student student;
  Random random;
  const Scene scene = comet(random);
  const Flight flight = fly(student, scene, 1e-5);
  const double error = flight.off > 1e-5 ? std::min(flight.off, allowed(1e-5)) : 1e-5;
  const double equal = equal_steps(scene, error);
  check_flight(
      scene, flight, std::floor(equal / 5),
      "RK4 in equal steps asks " + number(equal) + " times to end " + number(error, 2) + " off",
      flight.questions > std::floor(equal / 5) ? "Far from the sun the steps should be a hundred "
                                                 "times longer than near it. Do they grow "
                                                 "again after the pass, and soon?"
                                               : not_near_enough,
      either(asks_too_little(flight.path), spread_evenly(flight.path, scene.duration)));
}

TEST_CASE("ten thousand times the accuracy costs at most ten times the questions",
          "[3-runge-kutta/step-by-price][2 points]") {
  Student student;
  Random random;
  const Scene scene = comet(random);
  const Flight rough = fly(student, scene, 1e-3);
  check_flight(scene, rough, patience, "it should end",
               "How far two answers are apart says how wrong a step was. Keep it only if that is "
               "at most the tolerance.",
               {}, spread_evenly(rough.path, scene.duration));
  const Flight fine = fly(student, scene, 1e-7);
  const bool deaf = fine.off == rough.off && fine.questions == rough.questions;
  check_flight(
      scene, fine, 10 * rough.questions,
      "with a tolerance of 1e-3 it asked " + number(rough.questions) + " times",
      fine.questions > 10 * rough.questions
          ? "Does the step depend on the tolerance? With a method of low order each further digit "
            "costs too much."
          : not_near_enough,
      deaf ? Signs{"this is the very flight that it made with a tolerance of 1e-3"} : Signs{},
      spread_evenly(fine.path, scene.duration));
}

TEST_CASE("in a wind that changes a flight arrives at the time that was asked for",
          "[3-runge-kutta/step-by-price][1 point]") {
  Student student;
  Random random;
  const double shortest = harness_bounds::duration.smallest(), longest = 3;
  const std::vector<double> durations{random.between(shortest, 1),
                                      random.between(shortest, longest), longest, shortest};
  for (const double duration : durations) {
    const harness::Force force = random.wild();
    const Scene scene = wind(force, random.start(), duration);
    const Flight flight = fly(student, scene, 1e-7);
    check_flight(scene, flight, patience, "it should end",
                 "Each stage has its own time, the clock moves on by the step that was taken, and "
                 "the last step ends where the flight does.",
                 either(late_at_the_end(flight.path.states.back(), scene.end),
                        asks_at_another_time(flight.path, scene.duration, force)));
    if (duration < longest) continue;
    is_at_most("the questions of the same flight with a tolerance of 1e-3", describe(scene.start),
               fly(student, scene, 1e-3).questions,
               {flight.questions - 1,
                "with a tolerance of 1e-7 it asked " + number(flight.questions) + " times"},
               "Steps that are chosen are longer where less accuracy is wanted.");
  }
}

TEST_CASE("a coasting probe costs next to nothing", "[3-runge-kutta/step-by-price][1 point]") {
  Student student;
  Random random;
  for (const Start& start : {random.start(), without_rounding(random)}) {
    const Scene scene = coast(start, harness_bounds::duration.largest());
    const Flight flight = fly(student, scene, 1e-6);
    check_flight(
        scene, flight, 12 * std::ceil(std::log2(scene.duration / 1e-6)),
        "so many take a first step of a microsecond that doubles every twelve questions",
        "Where the estimate is zero no step is too long, and there is nothing to divide by.",
        coasts_in_short_steps(flight.path, scene.duration));
  }
}

// The burn is short: an embedded pair may take a start between two stages for 200 times less than
// it is, and a wrong velocity is carried on for as long as the engine burns.
TEST_CASE("a step that meets an engine's start is taken back",
          "[3-runge-kutta/step-by-price][1 point]") {
  Student student;
  Random random;
  for (const double coasts : {random.between(10, 25), random.between(25, 37)}) {
    const double burns = random.between(1, 3);
    const Vec push = random.vector(0.5, 2);
    Scene scene{"an engine that starts after " + number(coasts, 17) + " s with " +
                    describe(push, 17) + " m/s^2",
                random.start(),
                coasts + burns,
                {},
                {}};
    const double on = scene.start.t + coasts;
    scene.acceleration = [=](const Vec&, const Vec&, double t) { return t < on ? Vec{} : push; };
    scene.end = {scene.start.x + scene.duration * scene.start.v + (burns * burns / 2) * push,
                 scene.start.v + burns * push};
    const Flight flight = fly(student, scene, 1e-4);
    check_flight(scene, flight, patience, "it should end",
                 "If a step is too wrong, x, v and the clock must be what they were before it, and "
                 "the next try shorter.",
                 jumps_over(flight.path, on), spread_evenly(flight.path, scene.duration));
  }
}

TEST_CASE("the moment of a comet's pass costs little more than the flight to it",
          "[3-runge-kutta/step-by-price][2 points]") {
  Student student;
  Random random;
  // To about the other side; soon after the start; late; and whenever it may be, but for so near
  // the pass that the planets may put it off until after the end.
  const double finest = harness_bounds::tolerance_of_pass.smallest(),
               roughest = harness_bounds::tolerance_of_pass.largest();
  const auto soon = [&] { return random.between(1.1, 1.4); };
  const auto late = [&] { return random.between(2.2, 2.9); };
  const auto any = [&] { return random.between(1.1, 2.9); };
  const auto comet_between = [&](const auto& one, const auto& other) {
    const double to = other(), from = one();
    return comet(random, from, to);
  };
  for (const auto& [scene, tolerance] :
       {std::pair{comet(random), finest}, std::pair{comet_between(soon, late), roughest},
        std::pair{comet_between(late, soon), random.octaves(finest, 1e-6)},
        std::pair{comet_between(any, any), random.octaves(1e-6, roughest)}}) {
    Scene later = scene;
    later.start.t = random.between(harness_bounds::time);
    check_pass(later, pass(student, later, tolerance));
  }
}

TEST_CASE("any flight ends where it should, from anywhere, however short and however near",
          "[3-runge-kutta/step-by-price][1 point]") {
  Student student;
  Random random;
  constexpr int coasts = 400, winds = 150;
  for (int n = 0; n < coasts; ++n) {
    const double tolerance = random.anywhere(harness_bounds::tolerance);
    const double duration = random.anywhere(harness_bounds::duration);
    arrives(student, coast(anywhere(random), duration), nothing, tolerance);
  }
  // What bends for long carries each error on too far.
  const double shortest = harness_bounds::duration.smallest();
  for (const double longest : {0.3, 3.0}) {
    for (int n = 0; n < winds; ++n) {
      const harness::Force force = random.wild();
      const double tolerance = random.anywhere(harness_bounds::tolerance);
      const double duration = random.octaves(shortest, longest);
      arrives(student, wind(force, anywhere(random), duration), force, tolerance);
    }
  }
}
