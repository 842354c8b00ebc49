// SPDX-License-Identifier: MIT-0
/// @file
/// Lets every method try a scene, with 1, 2, 3 and more steps in each frame, until it is good
/// enough.
#pragma once
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numeric>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <vector>

#include "choose/entrants.h"
#include "frames/recorded.h"
#include "integrate/dopri5.h"
#include "measure/error.h"
#include "scenes/linear_drag.h"
#include "scenes/orbit.h"
#include "scenes/pendulum.h"
#include "scenes/spring.h"
#include "scenes/toss.h"

/// The bounds that a method has to meet.
struct Bounds {
  double hz = 60;            ///< frames a second
  double seconds = 10;       ///< how long the scene is watched
  double error = 0.01;       ///< largest error, as a share of how far the motion gets
  double energy = INFINITY;  ///< largest relative change of the energy
  double reach = 0;          ///< how far the motion gets, if errors are told in metres [m]

  long frames() const { return std::lround(seconds * hz); }
};

inline constexpr long most_steps = 1 << 20;  ///< in one run
inline constexpr long most_substeps = 1024;  ///< in one frame

/// The result of one run.
struct Attempt {
  long substeps = 0;     ///< steps in each frame; 0 if they do not end with the frames
  double tolerance = 0;  ///< of an adaptive method, as a share of how far the motion gets
  double error = 0;      ///< share of how far the motion gets
  double energy = 0;     ///< relative change, where energy is kept
  bool good(const Bounds& bounds) const { return error <= bounds.error && energy <= bounds.energy; }
};

/// The result of a method in the contest.
struct Entry {
  std::string name;                         ///< "exact step", or what the book calls the method
  const measure::Method* method = nullptr;  ///< never null
  Attempt last{};             ///< the first that is good enough; if none is, the nearest miss
  Attempt before{};           ///< with one step less; none if its `substeps` are zero
  bool good = false;          ///< whether `last` meets the bounds
  long tried = 0;             ///< steps in a frame at which the doubling ended
  double evaluations = 0;     ///< in a second of play, for `last`
  double microseconds = NAN;  ///< in a frame, for a thousand bodies, as recorded; NaN if it isn't
  double uneven = 0;          ///< the error of `last` in frames as uneven as recorded ones
  std::vector<Attempt> on_the_way{};  ///< what the doubling tried
};

/// Returns whether the scene's energy ought to stay what it is.
template <class Scene>
bool keeps_energy(const Scene& scene) {
  if constexpr (requires { scene.energy(scene.start().x, scene.start().v); }) {
    if constexpr (requires { scene.damping(); }) return scene.damping() == 0;
    return true;
  }
  return false;
}

/// The ends of frames, with the start before the first of them [s].
inline std::vector<double> even_frames(const Bounds& bounds) {
  std::vector<double> ends;
  for (long n = 0; n <= bounds.frames(); ++n) ends.push_back(double(n) / bounds.hz);
  return ends;
}

/// The ends of as many frames that are as uneven as those of `frames::recorded`, with a mean of
/// `hz` [s].
inline std::vector<double> uneven_frames(const Bounds& bounds) {
  const auto& frames = frames::recorded;
  const double sum = std::accumulate(frames.begin(), frames.end(), 0.0);
  std::vector<double> ends{0};
  for (long n = 0; n < bounds.frames(); ++n) {
    const double length = frames[std::size_t(n) % frames.size()];
    ends.push_back(ends.back() + length * double(frames.size()) / (sum * bounds.hz));
  }
  return ends;
}

/// The true places of a scene at the ends of frames, and the farthest of them from the origin.
template <class Vec>
struct Truth {
  std::vector<double> ends;  ///< of the frames, and the start before them [s]
  std::vector<Vec> x;
  double size = 0;
};

/// The truth of a scene at the ends of frames.
template <class Scene>
auto truth_of(const Scene& scene, const std::vector<double>& ends) {
  Truth<std::decay_t<decltype(scene.start().x)>> truth{ends, {}, 0};
  for (const double end : ends) {
    truth.x.push_back(scene.exact(end).x);
    truth.size = std::max(truth.size, measure::length(truth.x.back()));
  }
  return truth;
}

/// The farthest from the origin that the motion gets.
template <class Scene>
double size_of(const Scene& scene, const Bounds& bounds) {
  return truth_of(scene, even_frames(bounds)).size;
}

/// The error or the change of the energy over its bound, the larger of the two: one or less is
/// good.
inline double miss(const Attempt& attempt, const Bounds& bounds) {
  const double worst = std::max(attempt.error / bounds.error, attempt.energy / bounds.energy);
  return worst < INFINITY ? worst : INFINITY;
}

/// Returns whether one attempt is nearer to good enough than the other.
inline bool nearer(const Attempt& one, const Attempt& other, const Bounds& bounds) {
  return miss(one, bounds) < miss(other, bounds);
}

/// Compares the state at the end of a frame with the truth, and keeps the worst: the error as a
/// share of `size`, which is how far the motion gets, and the change of the energy.
template <class Scene, class Vec>
void update_worst(Attempt& worst, const Scene& scene, const scenes::State<Vec>& now,
                  const Vec& truth, double size) {
  const double error = measure::length(now.x - truth) / size;
  if (!(error <= worst.error)) worst.error = error;
  if constexpr (requires { scene.energy(now.x, now.v); }) {
    if (!keeps_energy(scene)) return;
    const auto start = scene.start();
    const double first = scene.energy(start.x, start.v);
    const double change = std::abs(scene.energy(now.x, now.v) / first - 1);
    if (!(change <= worst.energy)) worst.energy = change;
  }
}

/// Runs the scene and compares it with the truth in every frame, which is when a player sees it.
/// Gives up as soon as it misses the bounds by more than `patience`.
template <class Scene, class Vec>
Attempt attempt(const measure::Method& method, const Scene& scene, const Bounds& bounds,
                const Truth<Vec>& truth, long substeps, double patience) {
  Attempt worst{.substeps = substeps};
  const double h = 1 / (bounds.hz * double(substeps));
  auto memory = measure::start(method, scene.start(), h, scene);
  long n = 0;  // steps taken
  for (std::size_t seen = 1; seen < truth.x.size(); ++seen) {
    try {
      for (; n < long(seen) * substeps; ++n)
        measure::advance(method, memory, double(n) * h, h, scene);
    } catch (const std::runtime_error&) {
      worst.error = INFINITY;  // an implicit step that could not be solved
      break;
    }
    update_worst(worst, scene, measure::to_state(method, memory, double(n) * h, h, scene),
                 truth.x[seen], truth.size);
    if (miss(worst, bounds) > patience) break;
  }
  return worst;
}

/// The largest error in uneven frames, each cut into as many equal steps. What is folded takes the
/// step that it was folded for, that of the mean frame.
template <class Scene, class Vec>
double uneven_error(const measure::Method& method, const Scene& scene, const Truth<Vec>& uneven,
                    long substeps) {
  Attempt worst;
  const double mean = uneven.ends.back() / double((uneven.ends.size() - 1) * std::size_t(substeps));
  auto memory = measure::start(method, scene.start(), uneven.ends[1] / double(substeps), scene);
  for (std::size_t seen = 1; seen < uneven.x.size(); ++seen) {
    const double begin = uneven.ends[seen - 1], end = uneven.ends[seen];
    const double h = (end - begin) / double(substeps);
    const double taken = &method == &method::spring_folded ? mean : h;
    try {
      for (long n = 0; n < substeps; ++n)
        measure::advance(method, memory, begin + double(n) * h, taken, scene);
    } catch (const std::runtime_error&) {
      return INFINITY;
    }
    update_worst(worst, scene, measure::to_state(method, memory, end, h, scene), uneven.x[seen],
                 uneven.size);
    if (!(worst.error < 1e3)) return INFINITY;
  }
  return worst.error;
}

/// Evaluations a second with so many steps in a frame.
template <class Scene>
double cost_of(const measure::Method& method, const Scene& scene, const Bounds& bounds,
               long substeps) {
  const double steps = bounds.hz * double(substeps);
  return steps * double(price(method, scene, 1 / steps));
}

// [enter]
/// Doubles the steps until the bounds are met, or there would be too many.
template <class Scene, class Vec>
Entry enter(const measure::Method& method, const Scene& scene, const Bounds& bounds,
            const Truth<Vec>& truth) {
  Entry entry{.name = std::string(method.name), .method = &method};
  const long most = std::clamp(most_steps / bounds.frames(), 1L, most_substeps);
  for (long substeps = 1; !entry.good; substeps = std::min(2 * substeps, most)) {
    const Attempt now = attempt(method, scene, bounds, truth, substeps, INFINITY);
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
template <class Scene, class Vec>
void fill_in(Entry& entry, const Scene& scene, const Bounds& bounds, const Truth<Vec>& truth,
             double cheapest) {
  const measure::Method& method = *entry.method;
  const auto cost = [&](long substeps) { return cost_of(method, scene, bounds, substeps); };
  for (long substeps = 1; substeps < entry.tried && cost(substeps) < cheapest; ++substeps) {
    const Attempt now = attempt(method, scene, bounds, truth, substeps, 1);
    if (!now.good(bounds)) continue;
    entry.last = now;
    entry.good = true;
    break;
  }
  const long before = entry.last.substeps - 1;
  if (entry.good && before > 0) {
    entry.before = attempt(method, scene, bounds, truth, before, INFINITY);
  }
  entry.evaluations = cost(entry.last.substeps);
}
// [enter]

/// The thing of chapter 7's level that a scene is like, since times were recorded of these.
inline const char* timed_as(const scenes::Spring<>&) {
  return "suspension";
}
inline const char* timed_as(const scenes::Orbit<>&) {
  return "shuttle";
}
inline const char* timed_as(const scenes::Pendulum<>&) {
  return "lamp";
}
inline const char* timed_as(const scenes::LinearDrag<>&) {
  return "leaf";
}
inline const char* timed_as(const scenes::Toss&) {
  return "jump";
}

template <class Scene>
const char* timed_as(const Scene&) {
  return nullptr;  // nobody took the time of such a scene
}

/// Adds what is not searched for: the price in time, and the error in uneven frames.
template <class Scene, class Vec>
void complete(Entry& entry, const Scene& scene, const Truth<Vec>& uneven) {
  const long substeps = entry.last.substeps;
  if (const char* thing = timed_as(scene))
    entry.microseconds = double(substeps) * step_time(thing, in_a_loop, *entry.method);
  entry.uneven = uneven_error(*entry.method, scene, uneven, substeps);
}

/// The adaptive method, as it is called; its steps do not end with the frames.
inline constexpr measure::Method adaptive{
    "Dormand-Prince, adaptive", "dopri5_adaptive", "dopri5.h", {}, {}, {}};

/// The tolerances that it is tried with, as shares of how far the motion gets.
template <class Scene>
std::vector<double> tolerances(const Scene& scene) {
  double finest = 0;
  if constexpr (requires { scene.finest_tolerance(); }) finest = scene.finest_tolerance();
  std::vector<double> all;
  for (int half_decade = 2; half_decade <= 28; ++half_decade) {
    const double tolerance = std::pow(10, -half_decade / 2.0);
    if (tolerance >= finest) all.push_back(tolerance);
  }
  return all;
}

/// A run of the adaptive method, read in frames.
struct AdaptiveRun {
  Attempt worst;
  double evaluations = 0;  ///< in a second of play
};

/// Runs the scene with adaptive steps, and reads it at the ends of frames.
template <class Scene, class Vec>
AdaptiveRun adaptive_run(const Scene& scene, const Bounds& bounds, const Truth<Vec>& truth,
                         double tolerance) {
  const measure::Counted<Scene> counted{scene};
  const auto start = scene.start();
  const auto norm = [](const Vec& error) { return measure::length(error); };
  AdaptiveRun run{.worst = {.tolerance = tolerance}};
  auto path = integrate::dopri5_path(start.x, start.v, 0.0, 1 / bounds.hz, counted);
  for (std::size_t seen = 1; seen < truth.x.size(); ++seen) {
    const double end = truth.ends[seen];
    if (!integrate::dopri5_adaptive(path, end, counted, norm, tolerance * truth.size)) {
      run.worst.error = INFINITY;
      break;
    }
    const scenes::State<Vec> now{path.position(end), path.velocity(end)};
    update_worst(run.worst, scene, now, truth.x[seen], truth.size);
  }
  run.evaluations = double(counted.evaluations) / truth.ends.back();
  return run;
}

/// Tries every tolerance and keeps the cheapest that is good enough; if none is, the
/// nearest miss.
template <class Scene, class Vec>
Entry enter_adaptive(const Scene& scene, const Bounds& bounds, const Truth<Vec>& truth,
                     const Truth<Vec>& uneven) {
  Entry entry{.name = std::string(adaptive.name), .method = &adaptive};
  for (const double tolerance : tolerances(scene)) {
    const AdaptiveRun run = adaptive_run(scene, bounds, truth, tolerance);
    const bool good = run.worst.good(bounds), first = entry.evaluations == 0;
    const bool better = good != entry.good ? good
                        : good             ? run.evaluations < entry.evaluations
                                           : nearer(run.worst, entry.last, bounds);
    if (!first && !better) continue;
    entry.last = run.worst;
    entry.good = good;
    entry.evaluations = run.evaluations;
  }
  entry.uneven = adaptive_run(scene, bounds, uneven, entry.last.tolerance).worst.error;
  if (const char* thing = timed_as(scene))
    entry.microseconds =
        entry.evaluations / 6 / bounds.hz * step_time(thing, in_a_loop, method::dopri5);
  return entry;
}

/// A number in a few digits.
inline std::string format_number(double value, int digits = 2) {
  char text[32];
  std::snprintf(text, sizeof text, "%.*g", digits, value);
  return text;
}

/// An error without what is only rounding.
inline double without_rounding(double error) {
  return error < 1e-11 ? 0 : std::stod(format_number(error, 6));
}

/// Returns whether an entry is right in even frames alone.
inline bool is_for_even_frames(const Entry& entry, const Bounds& bounds) {
  return entry.good && !(entry.uneven <= bounds.error);
}

/// Good before not good, then cheap before dear, then what is right in uneven frames as well, then
/// right before nearly right; the nearest miss first among those that are not good. Of equals
/// velocity Verlet, which has place and velocity at the same time, and else by the alphabet.
inline bool better(const Entry& a, const Entry& b, const Bounds& bounds) {
  if (a.good != b.good) return a.good;
  const double missed = miss(a.last, bounds), other_missed = miss(b.last, bounds);
  if (!a.good && missed != other_missed) return missed < other_missed;
  if (a.evaluations != b.evaluations) return a.evaluations < b.evaluations;
  const bool shaky = is_for_even_frames(a, bounds), other_shaky = is_for_even_frames(b, bounds);
  if (shaky != other_shaky) return other_shaky;
  const double one = without_rounding(a.last.error), other = without_rounding(b.last.error);
  if (one != other) return one < other;
  const bool verlet = a.method == &method::velocity_verlet,
             other_verlet = b.method == &method::velocity_verlet;
  return verlet != other_verlet ? verlet : a.method->function < b.method->function;
}

/// All entries for a scene, the best first.
struct Contest {
  std::vector<Entry> exact;        ///< the exact steps, as exact_steps_of() has them
  std::vector<Entry> methods;      ///< what works with other forces added, too
  std::vector<Entry> undisturbed;  ///< adaptive steps, for what moves with nobody interfering
  bool keeps_energy = false;       ///< whether the scene's energy ought to stay what it is
  std::string remark{};            ///< what else is to be said of the scene; empty if nothing is

  void sort(const Bounds& bounds) {
    std::sort(methods.begin(), methods.end(),
              [&](const Entry& a, const Entry& b) { return better(a, b, bounds); });
  }
};

/// The entry of one of the methods that entered a contest.
inline const Entry& entry_of(const Contest& found, const measure::Method& method) {
  return *std::find_if(found.methods.begin(), found.methods.end(),
                       [&](const Entry& entry) { return entry.method == &method; });
}

/// The least that an entry within the bounds costs; infinite if there is none.
inline double cheapest_of(const std::vector<Entry>& entries) {
  double least = INFINITY;
  for (const Entry& entry : entries) {
    if (entry.good) least = std::min(least, entry.evaluations);
  }
  return least;
}

template <class Scene, class Vec>
Contest contest(const Scene& scene, const Bounds& bounds, const Truth<Vec>& truth) {
  Contest found;
  found.keeps_energy = keeps_energy(scene);
  for (const measure::Method* exact : exact_steps_of(scene)) {
    found.exact.push_back(enter(*exact, scene, bounds, truth));
    found.exact.back().name = "exact step";
    fill_in(found.exact.back(), scene, bounds, truth, INFINITY);
  }
  for (const measure::Method* method : entrants_on(scene)) {
    found.methods.push_back(enter(*method, scene, bounds, truth));
    Entry& entry = found.methods.back();
    if (entry.good) fill_in(entry, scene, bounds, truth, INFINITY);
  }
  const double cheapest = cheapest_of(found.methods);
  for (Entry& entry : found.methods) {
    if (!entry.good) fill_in(entry, scene, bounds, truth, cheapest);
  }
  found.sort(bounds);
  return found;
}

/// The contest against a truth that is worked out for it.
template <class Scene>
Contest contest(const Scene& scene, const Bounds& bounds) {
  return contest(scene, bounds, truth_of(scene, even_frames(bounds)));
}

/// The remark of `choose` on a scene whose exact step is in no header.
template <class Scene>
const char* remark_on(const Scene&) {
  if constexpr (!std::is_same_v<Scene, scenes::LinearDrag<>>) return "";
  return "Where gravity and this drag are all that acts, there is an exact step: its lines are on "
         "the page\n"
         "Pick a method (pick-a-method.html), under the air. linear_damping_exact is another, "
         "exact in the velocity alone.";
}

/// The contest with all that `choose` tells besides: prices in time, errors in uneven frames, and
/// adaptive steps.
template <class Scene>
Contest full_contest(const Scene& scene, const Bounds& bounds) {
  const auto truth = truth_of(scene, even_frames(bounds));
  auto uneven = truth_of(scene, uneven_frames(bounds));
  uneven.size = truth.size;  // errors are shares of one size
  Contest found = contest(scene, bounds, truth);
  for (Entry& entry : found.exact) complete(entry, scene, uneven);
  for (Entry& entry : found.methods) complete(entry, scene, uneven);
  found.sort(bounds);
  found.remark = remark_on(scene);
  found.undisturbed.push_back(enter_adaptive(scene, bounds, truth, uneven));
  return found;
}

/// Returns whether anything that goes on in frames, or is exact, meets the bounds.
inline bool is_met(const Contest& found) {
  return found.methods.front().good || (!found.exact.empty() && found.exact.front().good);
}

/// The cheapest by time of those within the bounds; null if nobody took a time of any.
inline const Entry* cheapest_by_time(const std::vector<Entry>& entries) {
  const Entry* best = nullptr;
  for (const Entry& entry : entries) {
    if (!entry.good || std::isnan(entry.microseconds)) continue;
    if (!best || entry.microseconds < best->microseconds) best = &entry;
  }
  return best;
}

/// A number above a bound, in as many digits as show that it is above, three at least.
inline std::string format_above(double value, double bound) {
  int digits = 3;
  while (digits < 17 && std::stod(format_number(value, digits)) <= bound) ++digits;
  return format_number(value, digits);
}

/// A share of the motion in the units of the answer: a share, or metres.
inline double in_reported_units(double share, const Bounds& bounds) {
  return bounds.reach > 0 ? share * bounds.reach : share;
}

/// The bound that an attempt missed, in words.
inline std::string shortcoming(const Attempt& attempt, const Bounds& bounds) {
  if (!(attempt.error < 10)) return "explodes";
  if (attempt.error > bounds.error)
    return "error " + format_above(in_reported_units(attempt.error, bounds),
                                   in_reported_units(bounds.error, bounds));
  return "energy off by " + format_above(attempt.energy, bounds.energy);
}

/// The reason why an entry did not win, or why it takes no step fewer.
inline std::string reason(const Entry& entry, const Bounds& bounds) {
  const Attempt& fails = entry.good ? entry.before : entry.last;
  if (fails.substeps == 0) return "one step is enough";
  const std::string many =
      std::to_string(fails.substeps) + (fails.substeps > 1 ? " steps" : " step");
  return shortcoming(fails, bounds) + (entry.good ? " in " : " even in ") + many;
}
