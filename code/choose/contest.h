// SPDX-License-Identifier: MIT-0
/// @file
/// Lets every method try a scene, with 1, 2, 3 and more steps in each frame, until it is good
/// enough.
#pragma once
#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <vector>

#include "choose/adaptive.h"
#include "choose/attempt.h"
#include "choose/entrants.h"
#include "choose/entry.h"
#include "choose/timed_as.h"
#include "scenes/linear_drag.h"

/// Evaluations a second with so many steps in a frame.
template <class Scene>
double cost_of(const measure::Method& method, const Question<Scene>& question, long substeps) {
  const double steps = question.bounds.hz * double(substeps);
  return steps * double(price(method, question.scene(), 1 / steps));
}

// [enter]
/// Doubles the steps until the bounds are met, or there would be too many.
template <class Scene>
Entry enter(const measure::Method& method, const Question<Scene>& question) {
  const Bounds& bounds = question.bounds;
  Entry entry{.name = std::string(method.name), .method = &method};
  const long most = std::clamp(most_steps / bounds.frames(), 1L, most_substeps);
  for (long substeps = 1; !entry.good; substeps = std::min(2 * substeps, most)) {
    const Attempt now = attempt(method, question, substeps, INFINITY);
    entry.on_the_way.push_back(now);
    entry.good = now.good(bounds);
    if (substeps == 1 || entry.good || nearer(now, entry.last, bounds)) entry.last = now;
    if (substeps == most) break;
  }
  entry.tried = entry.good ? entry.last.substeps : most;
  return entry;
}

/// Tries every smaller number of steps that costs less than `cheapest`, and ends with the first
/// that is good enough.
template <class Scene>
void fill_in(Entry& entry, const Question<Scene>& question, double cheapest) {
  const measure::Method& method = *entry.method;
  const auto cost = [&](long substeps) { return cost_of(method, question, substeps); };
  for (long substeps = 1; substeps < entry.tried && cost(substeps) < cheapest; ++substeps) {
    const Attempt now = attempt(method, question, substeps, 1);
    if (!now.good(question.bounds)) continue;
    entry.last = now;
    entry.good = true;
    break;
  }
  const long before = entry.last.substeps - 1;
  if (entry.good && before > 0) entry.before = attempt(method, question, before, INFINITY);
  entry.evaluations = cost(entry.last.substeps);
}
// [enter]

/// Adds what is not searched for: the price in time, and the error in uneven frames.
template <class Scene>
void complete(Entry& entry, const Question<Scene>& question) {
  const long substeps = entry.last.substeps;
  if (const char* thing = timed_as(question.scene()))
    entry.microseconds = double(substeps) * step_time(thing, in_a_loop, *entry.method);
  for (const auto& phase : question.phases) {
    const double error = uneven_error(*entry.method, phase, substeps);
    if (!(error <= entry.uneven)) entry.uneven = error;
  }
}

/// The contest of all methods for an answer to one question.
template <class Scene>
Contest contest_for(const Question<Scene>& question) {
  const Scene& scene = question.scene();
  Contest found;
  found.keeps_energy = keeps_energy(scene);
  for (const measure::Method* exact : exact_steps_of(scene)) {
    found.exact.push_back(enter(*exact, question));
    found.exact.back().name = "exact step";
    fill_in(found.exact.back(), question, INFINITY);
  }
  for (const measure::Method* method : entrants_on(scene)) {
    found.methods.push_back(enter(*method, question));
    Entry& entry = found.methods.back();
    if (entry.good) fill_in(entry, question, INFINITY);
  }
  const double cheapest = cheapest_of(found.methods);
  for (Entry& entry : found.methods) {
    if (!entry.good) fill_in(entry, question, cheapest);
  }
  found.sort(question.bounds);
  return found;
}

/// The contest against a truth that is worked out for it.
template <class Scene>
Contest contest(const Scene& scene, const Bounds& bounds) {
  return contest_for(Question<Scene>{bounds, {{scene, truth_of(scene, even_frames(bounds))}}});
}

/// The remark of `choose` on a scene whose exact step is in no header.
template <class Scene>
std::string exact_elsewhere(const Scene&) {
  if constexpr (!std::is_same_v<Scene, scenes::LinearDrag<>>) return "";
  return "Where gravity and this drag are all that acts, there is an exact step: its lines are on "
         "the page\n"
         "Pick a method (pick-a-method.html), under the air. linear_damping_exact is another, "
         "exact in the velocity alone.\n"
         "For drag that grows with the square of the speed take shelf/quadratic_drag.h.";
}

/// The remark on a scene in which whoever does nothing is within the bounds.
template <class Scene>
std::string hardly_moves(const Question<Scene>& question) {
  const auto& truth = question.phases.front().truth;
  double farthest = 0;
  for (const auto& x : truth.x)
    farthest = std::max(farthest, measure::length(x - truth.x.front()) / truth.size);
  if (farthest > question.bounds.error) return "";
  return "In this time nothing moves farther than " + format_number(farthest) +
         " of its distance from the origin. That is less than the error\n"
         "that is asked for: standing still is good enough. Ask for more --seconds, or a smaller "
         "--error.";
}

/// The question about a scene whose runs begin at several phases, with what is true of each.
/// @param scenes  the same scene, from each phase
/// @param bounds  what is asked for
/// @param tell  how far it has got
template <class Scene>
Question<Scene> question_of(const std::vector<Scene>& scenes, const Bounds& bounds,
                            const Tell& tell) {
  Question<Scene> question{bounds, {}, tell};
  for (const Scene& scene : scenes) {
    if (tell) tell("the truth to compare with");
    Phase<Scene> phase{scene, truth_of(scene, even_frames(bounds)),
                       truth_of(scene, uneven_frames(bounds))};
    question.phases.push_back(phase);
  }
  if (question.phases.front().truth.size == 0)
    throw std::invalid_argument("nothing leaves the origin, so no error is a share of the motion");
  for (auto& phase : question.phases)  // errors are shares of one size
    phase.truth.size = phase.uneven.size = question.phases.front().truth.size;
  return question;
}

/// The contest with all that `choose` tells besides: prices in time, errors in uneven frames, and
/// adaptive steps.
template <class Scene>
Contest full_contest_for(const Question<Scene>& question) {
  Contest found = contest_for(question);
  for (Entry& entry : found.exact) complete(entry, question);
  for (Entry& entry : found.methods) complete(entry, question);
  found.sort(question.bounds);
  found.remarks = {exact_elsewhere(question.scene()), hardly_moves(question)};
  found.undisturbed.push_back(enter_adaptive(question));
  return found;
}

/// The same, for a scene from its start.
template <class Scene>
Contest full_contest(const Scene& scene, const Bounds& bounds, const Tell& tell = {}) {
  return full_contest_for(question_of(std::vector{scene}, bounds, tell));
}
