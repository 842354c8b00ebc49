// SPDX-License-Identifier: MIT-0
/// @file
/// What each method of the level makes of a thing, with 1, 2, 3 and more steps in a frame.
#pragma once
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <memory>
#include <type_traits>
#include <vector>

#include "7-which-to-use/folded.h"
#include "7-which-to-use/level.h"
#include "choose/cost.h"
#include "live/implicit.h"
#include "live/run.h"
#include "measure/length.h"
#include "measure/methods/damping.h"
#include "measure/methods/euler.h"
#include "measure/methods/runge_kutta.h"
#include "measure/methods/spring.h"
#include "measure/methods/verlet.h"

namespace live {

/// The methods of the level, and at the end those that are not for every scene.
inline constexpr std::tuple methods{
    Method{"euler", measure::euler},
    Method{"symplectic_euler", measure::symplectic_euler},
    Method{"velocity_verlet", measure::velocity_verlet},
    Method{"yoshida4", measure::yoshida4},
    Method{"midpoint", measure::midpoint},
    Method{"rk4", measure::rk4},
    Method{"dopri5", measure::dopri5},
    Method{"trapezoid", trapezoid},
    Method{"backward_euler", backward_euler},
    Method{"bdf2", bdf2},
    Method{"linear_damping_implicit_last", measure::linear_damping_implicit_last},
    Method{"backward_euler_spring", measure::backward_euler_spring},
    Method{"spring_folded", measure::spring_folded},
    Method{"constant_acceleration", measure::constant_acceleration}};

/// Returns whether a method is for such scenes; the last four are not for all of them.
template <class Scene, class Step>
constexpr bool is_for(const Step&) {
  using namespace measure;
  if constexpr (std::is_same_v<Step, LinearDampingImplicitLast>) {
    return !std::is_same_v<Scene, scenes::Toss> && requires(const Scene scene) { scene.damping(); };
  } else if constexpr (std::is_same_v<Step, BackwardEulerSpring> ||
                       std::is_same_v<Step, SpringFolded>) {
    return requires(const Scene scene) { scene.omega, scene.zeta; };
  } else if constexpr (std::is_same_v<Step, ConstantAcceleration>) {
    return std::is_same_v<Scene, scenes::Toss>;
  } else {
    return true;
  }
}

/// Returns whether every machine finds the same bits; not where a sine or an exponential is called.
template <class Step>
constexpr bool is_reproducible(const Step&) {
  return !std::is_same_v<Step, measure::SpringFolded>;
}

inline constexpr int of_the_truth = 32;  ///< steps that Dormand-Prince takes in a frame
inline constexpr double gone = 1000;     ///< nobody sees how far beyond [m]
inline constexpr double none = std::numeric_limits<double>::quiet_NaN();

/// The outcome of a method on a thing, for each number of steps; empty if it is not for such
/// things.
struct Outcome {
  std::vector<double> paths;   ///< places at the ends of frames, one run after the other [m]
  std::vector<double> errors;  ///< the largest at the end of a frame; infinite if it is gone [m]
  double evaluations = none;   ///< of a step of the method
  double in_place = none;      ///< the same of what stands in its place, if something does
  bool reproducible = true;

  /// Of a step of what was tried.
  double asks() const { return std::isnan(in_place) ? evaluations : in_place; }
};

/// The outcomes of all methods on one thing.
class Trial {
 public:
  virtual ~Trial() = default;
  /// Steps of a method that many bodies take, for their time.
  virtual double work(int which, int rounds) const = 0;

  double seconds = 0;
  /// The parameters of the thing, in the words of `choose`; NaN where it has none of this.
  double omega = none, zeta = none, angle = none, eccentricity = none, drag = none;
  std::vector<double> truth;
  std::vector<Outcome> outcomes;
};

/// The trial of one scene.
template <class Scene>
class TrialOf final : public Trial {
  using Vec = typename Scene::Vec;
  using Path = std::vector<Vec>;

 public:
  TrialOf(const Scene& scene, double watched)
      : scene_(scene), frames_(std::lround(watched / frame)) {
    seconds = double(frames_) * frame;
    if constexpr (requires { scene.omega; }) {
      omega = scene.omega;
      zeta = scene.zeta;
    } else if constexpr (requires { scene.length; }) {
      omega = std::sqrt(scene.g / scene.length);
      zeta = 0;
      angle = scene.angle;
    } else if constexpr (requires { scene.eccentricity; }) {
      eccentricity = scene.eccentricity;
    } else if constexpr (requires { scene.c; }) {
      drag = scene.c;
    }
    const Path right = path(measure::dopri5, of_the_truth);
    append(truth, right);
    std::apply([&](const auto&... method) { (outcomes.push_back(outcome(method, right)), ...); },
               methods);
  }

  double work(int which, int rounds) const override {
    double sum = 0;
    int place = 0;
    const auto if_asked = [&](const auto& method) {
      if (place++ == which) sum = move(method.step, rounds);
    };
    std::apply([&](const auto&... method) { (if_asked(method), ...); }, methods);
    return sum;
  }

 private:
  /// The places of a method at the start and at the end of each frame.
  template <class Step>
  Path path(Step step, int in_a_frame) const {
    const double h = frame / in_a_frame;
    auto memory = measure::start(step, scene_.start(), h, scene_);
    Path places{scene_.start().x};
    for (long n = 0; n < frames_ * in_a_frame;) {
      measure::advance(step, memory, double(n) * h, h, scene_);
      if (++n % in_a_frame == 0) {
        places.push_back(measure::to_state(step, memory, double(n) * h, h, scene_).x);
      }
    }
    return places;
  }

  // Of a method, or of what stands in its place and is for the same things.
  template <class Step>
  Outcome outcome(const Method<Step>& method, const Path& right) const {
    if constexpr (!is_for<Scene>(Step())) {
      return {};
    } else {
      Outcome found =
          with_what_stands<Vec>(method, [&](const auto& step) { return try_out(step, right); });
      if (is_stood_in_for<Vec>(method.name)) found.in_place = evaluations(StandIn());
      found.evaluations = evaluations(method.step);
      return found;
    }
  }

  template <class Step>
  Outcome try_out(Step step, const Path& right) const {
    Outcome outcome;
    outcome.reproducible = is_reproducible(step);
    for (const int in_a_frame : tried_in_a_frame) {
      const Path places = path(step, in_a_frame);
      append(outcome.paths, places);
      outcome.errors.push_back(largest_error(places, right));
    }
    return outcome;
  }

  static double largest_error(const Path& places, const Path& right) {
    double worst = 0;
    for (std::size_t n = 0; n < places.size(); ++n) {
      const double error = measure::length(Vec(places[n] - right[n]));
      if (!(error < gone)) return std::numeric_limits<double>::infinity();
      worst = std::max(worst, error);
    }
    return worst;
  }

  template <class Step>
  double evaluations(Step step) const {
    const CostCounted<Scene> billed{scene_};
    auto memory = measure::start(step, scene_.start(), frame, billed);
    // What a reader's step keeps, it asks for in the first one.
    if constexpr (std::is_same_v<Step, StandIn>) measure::advance(step, memory, 0.0, frame, billed);
    billed.evaluations = 0;
    measure::advance(step, memory, 0.0, frame, billed);
    return double(std::max(1L, billed.evaluations));
  }

  // One coordinate after the other, of each place.
  static void append(std::vector<double>& list, const Path& places) {
    for (const Vec& place : places) {
      if constexpr (std::is_same_v<Vec, double>) {
        list.push_back(place);
      } else {
        list.insert(list.end(), place.begin(), place.end());
      }
    }
  }

  template <class Step>
  double move(Step step, int rounds) const {
    if constexpr (!is_for<Scene>(Step())) {
      return none;
    } else if constexpr (std::is_same_v<Step, measure::SpringFolded>) {
      return move_all(folded_once(scene_), rounds);
    } else {
      return move_all(step, rounds);
    }
  }

  template <class Step>
  __attribute__((flatten)) double move_all(Step step, int rounds) const {
    std::vector bodies(in_a_loop, measure::start(step, scene_.start(), brief_step, scene_));
    for (int n = 0; n < rounds; ++n) {
      for (auto& memory : bodies)
        measure::advance(step, memory, n * brief_step, brief_step, scene_);
    }
    return measure::length(bodies.back()[0]);
  }

  Scene scene_;
  long frames_;
};

}  // namespace live
