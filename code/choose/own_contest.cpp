// SPDX-License-Identifier: MIT-0
#include "choose/own_contest.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <string>
#include <vector>

#include "choose/own_scene.h"

namespace {

/// The least error that can be asked for where numbers are floats, as a share.
constexpr double least_in_float = 1e-6;

/// A phase is what the root of a prime has behind the point, in frames. No two of them have a
/// multiple that differs by a whole number, so that in no number of steps a frame do all fall on
/// the same part of a step.
constexpr std::array primes{2, 3, 5, 7, 11, 13, 17, 19, 23, 29, 31, 37, 41, 43, 47, 53};

/// How many of the phases show whether an answer is luck.
constexpr int few_phases = 5;

/// By this factor the error may exceed its bound in another phase before that is called luck.
constexpr double luck_factor = 1.5;

/// The scene from so many phases of a frame.
template <class Moved>
std::vector<OwnScene<Moved>> in_phases(const OwnForce& force, const Bounds& bounds,
                                       std::size_t many) {
  std::vector<OwnScene<Moved>> all;
  for (std::size_t n = 0; n < many; ++n) {
    const double root = std::sqrt(double(primes[n]));
    all.emplace_back(force, (root - std::floor(root)) / bounds.hz);
  }
  return all;
}

void require_possible_in_float(const Bounds& bounds) {
  if (bounds.error >= least_in_float) return;
  throw std::invalid_argument("the scene is in float, which keeps no error below " +
                              format_number(least_in_float) +
                              " of the motion; ask for a larger one, or write it in double");
}

/// Says so if the best is within the bounds by luck, and is not where frames begin at other
/// moments; else nothing.
template <class Moved>
std::string luck_of(const Entry& best, const OwnForce& force, const Bounds& bounds,
                    const Tell& tell) {
  if (!best.good) return "";
  Attempt worst;
  try {
    const auto question = question_of(in_phases<Moved>(force, bounds, few_phases), bounds, tell);
    worst = attempt(*best.method, question, best.last.substeps, INFINITY);
  } catch (const std::runtime_error&) {
    return "";  // the motion goes no farther than was asked
  }
  if (worst.error <= luck_factor * bounds.error) return "";
  return "where frames begin at another moment, the error of " +
         std::string(best.method->function) + " in " + steps(best.last.substeps) + " a frame is " +
         format_number(in_reported_units(worst.error, bounds)) +
         "; a force that switches within a step makes such luck: ask again with --phase";
}

template <class Moved>
Contest contest_of(const OwnForce& force, Bounds& bounds, const OwnAsked& asked, const Tell& tell) {
  if (asked.metres > 0) {
    bounds.reach = size_of(OwnScene<Moved>(force), bounds);
    bounds.error = asked.metres / bounds.reach;
  }
  if (force.in_float) require_possible_in_float(bounds);
  using Scenes = std::vector<OwnScene<Moved>>;
  const Scenes scenes = asked.phases ? in_phases<Moved>(force, bounds, primes.size())
                                     : Scenes{OwnScene<Moved>(force)};
  Contest found = full_contest_for(question_of(scenes, bounds, tell));
  if (force.in_float)
    found.remarks.push_back(
        "The acceleration is in float, as in the scene; the steps here are in double.");
  if (!asked.phases) found.warning = luck_of<Moved>(found.methods.front(), force, bounds, tell);
  return found;
}

}  // namespace

Contest own_contest(const OwnForce& force, Bounds& bounds, const OwnAsked& asked,
                    const Tell& tell) {
  if (force.numbers == 1) return contest_of<double>(force, bounds, asked, tell);
  if (force.numbers == 2) return contest_of<Eigen::Vector2d>(force, bounds, asked, tell);
  return contest_of<Eigen::VectorXd>(force, bounds, asked, tell);
}
