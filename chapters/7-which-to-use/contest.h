// SPDX-License-Identifier: MIT-0
/// @file
/// Lets every method try a scene, with 1, 2, 4 and more steps in each frame, until it is good
/// enough.
#pragma once
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <stdexcept>
#include <string>
#include <vector>

#include "level.h"

/// What is wanted of a method.
struct Bounds {
  double hz = 60;            ///< frames a second
  double seconds = 10;       ///< how long the scene is watched
  double error = 0.01;       ///< largest error, as a share of how far the motion gets
  double energy = INFINITY;  ///< largest relative change of the energy

  long frames() const { return std::lround(seconds * hz); }
};

inline constexpr long most_steps = 1 << 20;  ///< in one run
inline constexpr long most_substeps = 1024;  ///< in one frame

/// What one run came to.
struct Attempt {
  long substeps = 0;  ///< steps in each frame
  double error = 0;   ///< share of how far the motion gets
  double energy = 0;  ///< relative change, where energy is kept
  bool good(const Bounds& bounds) const { return error <= bounds.error && energy <= bounds.energy; }
};

/// How a method did in the contest.
struct Entry {
  std::string method, function;
  Attempt last{};          ///< the first that is good enough; if none is, the nearest miss
  Attempt before{};        ///< with half the steps; none if its `substeps` are zero
  bool good = false;       ///< whether `last` meets the bounds
  double evaluations = 0;  ///< in a second of play, for `last`
};

/// Whether the scene's energy ought to stay what it is.
template <class Scene>
bool keeps_energy(const Scene& scene) {
  if constexpr (requires { scene.energy(scene.start().x, scene.start().v); }) {
    if constexpr (requires { scene.damping(); }) return scene.damping() == 0;
    return true;
  }
  return false;
}

/// The farthest from the origin that the motion gets.
template <class Scene>
double size_of(const Scene& scene, const Bounds& bounds) {
  double farthest = 0;
  for (long n = 0; n <= bounds.frames(); ++n) {
    farthest = std::max(farthest, measure::length(scene.exact(double(n) / bounds.hz).x));
  }
  return farthest;
}

// [attempt]
/// Runs the scene and compares it with the truth in every frame, which is when a player sees it.
template <class Step, class Scene>
Attempt attempt(const Step& step, const Scene& scene, const Bounds& bounds, long substeps) {
  Attempt worst{.substeps = substeps};
  auto s = scene.start();
  const auto start = s;
  const bool keeps = keeps_energy(scene);
  long n = 0;
  const auto compare = [&](double t, const auto& now) {
    if (n++ % substeps != 0) return;
    const double error = measure::length(now.x - scene.exact(t).x);
    if (!(error <= worst.error)) worst.error = error;
    if constexpr (requires { scene.energy(now.x, now.v); }) {
      const double first = scene.energy(start.x, start.v);
      const double change = keeps ? std::abs(scene.energy(now.x, now.v) / first - 1) : 0;
      if (!(change <= worst.energy)) worst.energy = change;
    }
  };
  const double h = 1 / (bounds.hz * double(substeps));
  try {
    measure::run(step, scene, s, h, bounds.frames() * substeps, compare);
  } catch (const std::runtime_error&) {
    worst.error = INFINITY;  // an implicit step that could not be solved
  }
  worst.error /= size_of(scene, bounds);
  return worst;
}
// [attempt]

/// How far from good enough: one or less is good.
inline double miss(const Attempt& attempt, const Bounds& bounds) {
  const double worst = std::max(attempt.error / bounds.error, attempt.energy / bounds.energy);
  return worst < INFINITY ? worst : INFINITY;
}

// [enter]
/// Doubles the steps until the bounds are met.
template <class Step, class Scene>
Entry enter(const std::string& method, const std::string& function, const Step& step,
            const Scene& scene, const Bounds& bounds) {
  Entry entry{.method = method, .function = function};
  Attempt now;
  for (long substeps = 1; substeps <= most_substeps; substeps *= 2) {
    if (substeps > 1 && bounds.frames() * substeps > most_steps) break;
    entry.before = now;
    now = attempt(step, scene, bounds, substeps);
    entry.good = now.good(bounds);
    if (substeps == 1 || entry.good || miss(now, bounds) < miss(entry.last, bounds)) {
      entry.last = now;
    }
    if (entry.good) break;
  }
  const double steps = bounds.hz * double(entry.last.substeps);
  entry.evaluations = steps * double(price(step, scene, 1 / steps));
  return entry;
}
// [enter]

/// A number in a few digits.
inline std::string brief(double value, int digits = 2) {
  char text[32];
  std::snprintf(text, sizeof text, "%.*g", digits, value);
  return text;
}

/// An error without what is only rounding.
inline double without_rounding(double error) {
  return error < 1e-11 ? 0 : std::stod(brief(error, 6));
}

/// Good before not good, then cheap before dear, then right before nearly right; the nearest miss
/// first among those that are not good. Of equals velocity Verlet, which has place and velocity at
/// the same time, and else by the alphabet.
inline bool better(const Entry& a, const Entry& b, const Bounds& bounds) {
  if (a.good != b.good) return a.good;
  const double missed = miss(a.last, bounds), other_missed = miss(b.last, bounds);
  if (!a.good && missed != other_missed) return missed < other_missed;
  if (a.evaluations != b.evaluations) return a.evaluations < b.evaluations;
  const double one = without_rounding(a.last.error), other = without_rounding(b.last.error);
  if (one != other) return one < other;
  const bool verlet = a.function == "velocity_verlet",
             other_verlet = b.function == "velocity_verlet";
  return verlet != other_verlet ? verlet : a.function < b.function;
}

/// Calls `visit` with the exact step of a scene that has one.
template <class Scene, class Visit>
void with_exact_step(const Scene&, Visit) {}

template <class Visit>
void with_exact_step(const scenes::Spring<>&, Visit visit) {
  visit("exact step", "spring_exact", measure::spring_exact);
}

template <class Visit>
void with_exact_step(const Ball&, Visit visit) {
  visit("exact step", "constant_acceleration", measure::constant_acceleration);
}

/// All entries for a scene, the best first.
struct Contest {
  std::vector<Entry> exact;    ///< the exact step, if there is one
  std::vector<Entry> methods;  ///< what works with other forces added, too
  bool keeps_energy = false;   ///< whether the scene's energy ought to stay what it is
};

template <class Scene>
Contest contest(const Scene& scene, const Bounds& bounds) {
  Contest found;
  found.keeps_energy = keeps_energy(scene);
  const auto into = [&](std::vector<Entry>& entries) {
    return [&](const auto& method, const auto& function, const auto& step) {
      entries.push_back(enter(method, function, step, scene, bounds));
    };
  };
  with_exact_step(scene, into(found.exact));
  for_each_entrant_on(scene, into(found.methods));
  std::sort(found.methods.begin(), found.methods.end(),
            [&](const Entry& a, const Entry& b) { return better(a, b, bounds); });
  return found;
}

/// A number above a bound, in as many digits as show that it is above, three at least.
inline std::string above(double value, double bound) {
  int digits = 3;
  while (digits < 17 && std::stod(brief(value, digits)) <= bound) ++digits;
  return brief(value, digits);
}

/// Why fewer steps did not do.
inline std::string shortcoming(const Attempt& attempt, const Bounds& bounds) {
  if (!(attempt.error < 10)) return "explodes";
  if (attempt.error > bounds.error) return "error " + above(attempt.error, bounds.error);
  return "energy off by " + above(attempt.energy, bounds.energy);
}

/// Why an entry did not win, or what it would not have done without.
inline std::string reason(const Entry& entry, const Bounds& bounds) {
  const Attempt& fails = entry.good ? entry.before : entry.last;
  if (fails.substeps == 0) return "one step is enough";
  const std::string many =
      std::to_string(fails.substeps) + (fails.substeps > 1 ? " steps" : " step");
  return shortcoming(fails, bounds) + (entry.good ? " in " : " even in ") + many;
}
