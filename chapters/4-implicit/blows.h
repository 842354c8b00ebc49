// SPDX-License-Identifier: MIT-0
/// @file
/// The energy of a blow that is left in chapter 4, and how often each step is solved for it.
#pragma once
#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <string>

#include "../cast.h"
#include "integrate/bdf2.h"
#include "integrate/trapezoid.h"
#include "measure/energy.h"
#include "measure/methods.h"
#include "measure/record.h"
#include "net/nets.h"

/// Returns the share of the energy of an undamped spring that is left after a step of backward
/// Euler.
constexpr double left_in_a_step(double homega) {
  return 1 / (1 + homega * homega);
}

/// Returns the share of the energy of an undamped spring that is left after a second of BDF2.
inline double left_by_bdf2(const scenes::Spring<>& spring) {
  const auto energy = [&](double x, double v) { return spring.energy(x, v); };
  return 1 + measure::drift(measure::bdf2, spring, frame, 60, energy).last;
}

/// Returns the share that is left if the first step is that of another method.
/// @param first  takes it, as `first(x, v, t, h, scene)`
template <class First>
double left_by_bdf2(const scenes::Spring<>& spring, First first) {
  auto [x, v] = spring.start();
  integrate::Bdf2Previous<double> previous{x, v};
  const double given = spring.energy(x, v);
  const auto solve = measure::solver_of(spring);
  first(x, v, 0.0, frame, spring);
  for (int n = 1; n < 60; ++n) {
    if (!integrate::bdf2(x, v, previous, n * frame, frame, frame, spring, solve)) return NAN;
  }
  return spring.energy(x, v) / given;
}

/// When a step is solved well criterion.
struct StoppingCriterion {
  int most = 1;          ///< solves in a step
  double tolerance = 0;  ///< a change of the velocities that may be left [m/s]
};

inline constexpr StoppingCriterion one_solve{1}, two_solves{2};
inline constexpr StoppingCriterion until_close{8, 0.1};  ///< what the chapter advises

// [until]
/// The size of a change for Newton's method: of the last solve that a step may have, none.
inline auto change_within(int most) {
  return [most, solves = 0](const Eigen::VectorXd& change) mutable {
    return ++solves < most ? largest_change(change) : 0.0;
  };
}

/// Backward Euler, each step solved until the criterion holds.
inline auto backward_euler_solved(StoppingCriterion criterion) {
  return [criterion](MassSpringState& s, const auto& scene, auto& system) {
    return integrate::backward_euler_newton(s.x, s.v, 0.0, frame, scene, system,
                                            change_within(criterion.most), criterion.tolerance);
  };
}
// [until]

/// One solve of the trapezoid rule.
inline constexpr auto trapezoid_once = [](MassSpringState& s, const auto& scene, auto& system) {
  return integrate::trapezoid(s.x, s.v, 0.0, frame, scene, system);
};

/// Counts the steps of the trapezoid rule for which Newton's method converges, until it does not.
/// @param draw  of the blow; see with_random_velocities()
template <class Scene>
int trapezoid_steps(const Scene& scene, double speed, unsigned draw, int most) {
  MassSpringState s = with_random_velocities(scene, speed, draw);
  auto system = system_of(scene);
  int steps = 0;
  while (steps < most && integrate::trapezoid_newton(s.x, s.v, 0.0, frame, scene, system,
                                                     largest_change, newton_tolerance) > 0) {
    ++steps;
  }
  return steps;
}

/// Begins BDF2 in the first frame, and takes a step of it in each; for one blow.
/// @param step  called as `step(s, previous, scene, system)`; returns whether it was solved
template <class Step>
auto begun_by_itself(Step step) {
  using Previous = integrate::Bdf2Previous<Eigen::VectorXd>;
  return [step, previous = std::optional<Previous>()](MassSpringState& s, const auto& scene,
                                                      auto& system) mutable {
    if (!previous) previous = integrate::bdf2_start(s.x, s.v, 0.0, frame, scene);
    return step(s, *previous, scene, system);
  };
}

/// One solve of BDF2; for one blow.
inline auto bdf2_once() {
  return begun_by_itself([](MassSpringState& s, auto& previous, const auto& scene, auto& system) {
    return integrate::bdf2(s.x, s.v, previous, 0.0, frame, frame, scene, system);
  });
}

/// BDF2, each step solved until the criterion holds; for one blow.
inline auto bdf2_solved(StoppingCriterion criterion) {
  return begun_by_itself(
      [criterion](MassSpringState& s, auto& previous, const auto& scene, auto& system) {
        return integrate::bdf2_newton(s.x, s.v, previous, 0.0, frame, frame, scene, system,
                                      change_within(criterion.most), criterion.tolerance);
      });
}

/// The energy in a second after a blow.
struct EnergyAfterBlow {
  double most = 0;    ///< after any step, over that of the blow; infinite if one was not solved
  int frame = 0;      ///< after which it is that much
  double left = 0;    ///< at the end, over that of the blow
  double solves = 0;  ///< in a step, on average
};

/// @param step  called as `step(state, scene, system)`; gives how often it solved, 0 if in vain
template <class Scene, class Step>
EnergyAfterBlow after_blow(const Scene& scene, double speed, unsigned draw, Step step) {
  constexpr int frames = 60;
  EnergyAfterBlow found;
  const auto counted = [&](MassSpringState& s, const auto& net, auto& system) {
    const int solves = step(s, net, system);
    found.solves += double(solves) / frames;
    return solves > 0;
  };
  const auto all = energy_shares(scene, speed, frames, counted, draw);
  const auto most = std::max_element(all.begin() + 1, all.end());
  found.most = all.size() > frames ? *most : INFINITY;
  found.frame = int(most - all.begin());
  found.left = all.back();
  return found;
}

/// The methods that are solved in steps after a blow.
enum class Solved { backward_euler, bdf2 };

/// Returns it for one of the nets and one of the methods.
/// @param net  "rope" or "cloth"
EnergyAfterBlow after_blow(const std::string& net, Solved method, double speed, unsigned draw,
                           StoppingCriterion criterion);

inline constexpr unsigned three_draws[] = {1, 2, 3};  ///< of the blows that the figure shows

inline constexpr unsigned harsh_draw = 31;  ///< the harshest for cloth of the first 300

/// The largest of each after three blows; not which frame it was.
EnergyAfterBlow worst_of_three(const std::string& net, Solved method, double speed,
                               StoppingCriterion criterion);

/// Returns how often a second the beads of a rope that hangs swing sideways near its nail,
/// neighbours against each other, pulled by the weight of the whole rope.
inline double sideways_swings(const HangingRope<>& rope) {
  const double weight = (rope.count - 1) * rope.mass * rope.g;
  const double spacing = rope.length / (rope.count - 1);
  return std::sqrt(4 * weight / (rope.mass * spacing)) / (2 * std::numbers::pi);
}

/// Records a gentle blow, and what a second leaves of it.
void a_second(measure::Record& record);

/// Records harder and harder blows, solved once a step, twice and until it is criterion.
void hard_blows(measure::Record& record);

/// Records the change in each of Newton's iterations of one step.
void newton(measure::Record& record);
