// SPDX-License-Identifier: MIT-0
/// @file
/// The lines of a card, a few at a time: each function measures one thing of a method.
#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "measure/card.h"
#include "measure/evaluations.h"
#include "measure/longest_stable_step.h"
#include "measure/method.h"
#include "measure/order.h"
#include "measure/stability.h"
#include "scenes/linear_drag.h"
#include "scenes/orbit.h"
#include "scenes/pendulum.h"
#include "scenes/spring.h"

/// The parts of a card.
namespace measure::card_lines {

/// A planet that comes in, passes its sun and goes out again, though not as far: without symmetry,
/// in which an order could look better than it is.
struct Passing : scenes::Orbit<> {
  static constexpr double early = 1;  ///< from the start to the pericentre [s]

  /// Before the pericentre.
  scenes::State<Vec> start() const { return exact(0); }
  /// The state at any time.
  /// @param t  time since the start [s]
  scenes::State<Vec> exact(double t) const { return Orbit::exact(t - early); }
};

/// The scene that is moved while the steps of a method for any acceleration are timed.
inline constexpr scenes::Orbit<> orbit;

/// A damped spring, which also asks for the velocity.
inline constexpr scenes::Spring<> damped{.omega = 2, .zeta = 0.25, .x0 = 1, .v0 = 0.5};

/// The same spring without its damper.
inline constexpr scenes::Spring<> undamped{.omega = 2, .x0 = 1, .v0 = 0.5};

/// Halvings from the step `h` on, as long as the errors stay above rounding, which may be two in
/// each step.
template <class Scene>
std::vector<Halving> clear_halvings(const Method& method, const Scene& scene, double h) {
  const double duration = 3;
  auto study = halvings(method, scene, h, duration, 10);
  const auto near_rounding = [duration](const Halving& row) {
    const double roundings = 2 * std::numeric_limits<double>::epsilon() * duration / row.h;
    return !(std::min(row.error.position, row.error.velocity) > roundings);
  };
  study.erase(std::find_if(study.begin() + 2, study.end(), near_rounding), study.end());
  return study;
}

/// Adds the orders in position and velocity that the last clear halving shows, as lines NAME and
/// NAME-velocity. A method that is right to rounding with the largest step is exact.
template <class Scene>
void orders(Card& card, const Method& method, const Scene& scene, const std::string& name,
            const std::string& where, double h = 1.0 / 8) {
  const auto study = clear_halvings(method, scene, h);
  const Error first = study.front().error;
  const bool exact = std::max(first.position, first.velocity) < 1e-12;
  const auto add = [&](const std::string& line, const std::string& of, double order) {
    card.rows.push_back({line, "Order", where + ", " + of, exact ? Cell("exact") : Cell(order), 2});
  };
  add(name, "position", study.back().position_order);
  add(name + "-velocity", "velocity", study.back().velocity_order);
}

/// The longest stable step of a linear scene, or "never", or "any step".
template <class Scene>
Cell limit(const Method& method, const Scene& scene) {
  const double longest = longest_stable_step(method, scene);
  if (longest == 0) return "never";
  return std::isinf(longest) ? Cell("any step") : Cell(longest);
}

/// Adds the limit on drag, c h.
template <class Scene>
void drag_limit(Card& card, const Method& method, const Scene& drag) {
  card.rows.push_back({"drag-limit", "Stable up to", "drag, ch", limit(method, drag)});
}

/// Adds the limits on springs, omega h.
inline void spring_limits(Card& card, const Method& method) {
  const auto add = [&](const std::string& name, const std::string& asked, double zeta) {
    card.rows.push_back(
        {name, "Stable up to", asked, limit(method, scenes::Spring<>{.zeta = zeta})});
  };
  add("spring-limit", "undamped spring, hω", 0);
  add("spring-limit-0.1", "spring with ζ = 0.1, hω", 0.1);
  add("spring-limit-0.5", "spring with ζ = 0.5, hω", 0.5);
  add("spring-limit-1", "spring with ζ = 1, hω", 1);
  add("spring-limit-2", "spring with ζ = 2, hω", 2);
}

/// The energies that a part of a run went through, the start being 1.
struct Energies {
  double least = INFINITY;  ///< also where one was not a number
  double most = 0;
  double last = 1;  ///< infinite or not a number, too

  /// Looks at one more.
  void see(double energy) {
    if (!(energy >= least)) least = energy;
    if (!(energy <= most)) most = energy;
    last = energy;
  }
};

/// The first and the last thousand of a million steps of an undamped spring, h omega = 0.1.
inline std::array<Energies, 2> first_and_last(const Method& method) {
  constexpr long steps = 1'000'000, shown = 1000;
  const scenes::Spring<> spring;
  const auto start = spring.start();
  auto s = start;
  std::array<Energies, 2> seen;
  long n = 0;
  run(method, spring, s, 0.1, steps, [&](double, const auto& now) {
    const double energy = spring.energy(now.x, now.v) / spring.energy(start.x, start.v);
    if (n <= shown) seen[0].see(energy);
    if (n >= steps - shown) seen[1].see(energy);
    ++n;
  });
  return seen;
}

/// Adds what happens to the energy of an undamped spring.
///
/// It is kept if the last of a million steps go as high and as low as the first, to a hundredth of
/// the swing between.
inline void energy(Card& card, const Method& method) {
  const std::string about = "Energy of an undamped spring, hω = 0.1";
  const auto add = [&](const std::string& name, const std::string& asked, Cell measured,
                       int digits = 3, const std::string& unit = "1") {
    card.rows.push_back({name, about, asked, std::move(measured), digits, unit});
  };
  const auto [first, last] = first_and_last(method);
  const double rounding = 1e-9;  // a few in each step
  const double allowed = 0.01 * (first.most - first.least) + rounding;
  if (std::abs(last.most - first.most) < allowed && std::abs(last.least - first.least) < allowed) {
    const double off = std::max(first.most - 1, 1 - first.least);
    add("energy", "in a million steps", "kept");
    add("energy-off", "off by at most", off < rounding ? Cell("rounding") : Cell(100 * off), 2,
        off < rounding ? "1" : "%");
    return;
  }
  const double radius = spectral_radius(method, scenes::Spring<>(), 0.1);
  add("energy", "in the long run", radius > 1 ? "grows" : "falls");
  add("energy-step", "change per step", 100 * (radius * radius - 1), 3, "%");
  add("energy-thousand", "change in a thousand steps", 100 * (first.last - 1), 3, "%");
}

/// Adds how far a thing falls in ten steps from rest, by which the methods of engines are told
/// apart.
inline void fall(Card& card, const Method& method) {
  const scenes::LinearDrag<> vacuum{.c = 0};
  const double h = 0.1;
  const double depth = -after(method, vacuum, vacuum.start(), h, 10).x;
  card.rows.push_back({"fall", "Ten steps of free fall", "depth in units of gh², exact: 50",
                       depth / (vacuum.g * h * h)});
}

/// Adds the evaluations of the acceleration in one step.
template <class Scene>
void evaluations(Card& card, const Method& method, const Scene& scene) {
  card.rows.push_back({"evaluations", "Cost of a step", "evaluations of the acceleration",
                       double(evaluations_per_step(method, scene, 0.01)), whole});
}

/// A scene that counts how often it is asked for its acceleration, and for its Jacobian.
template <class Scene>
struct CountedJacobian : Counted<Scene> {
  using Counted<Scene>::Counted;
  mutable long solves = 0;  ///< how often it was asked for its Jacobian

  /// The Jacobian of the scene.
  template <class Vec, class Time, class Add>
  void jacobian(const Vec& x, const Vec& v, Time t, Add&& add) const {
    ++solves;
    Scene::jacobian(x, v, t, add);
  }
};

/// Adds the least and most evaluations and solves of an implicit method, on ten seconds of a
/// pendulum at sixty steps a second.
inline void solves(Card& card, const Method& method) {
  const CountedJacobian<scenes::Pendulum<>> pendulum{scenes::Pendulum<>{}};
  auto memory = start(method, pendulum.start(), 1 / 60.0, pendulum);
  long least[2] = {1000, 1000}, most[2] = {0, 0};
  for (int n = 0; n < 600; ++n) {
    pendulum.evaluations = pendulum.solves = 0;
    advance(method, memory, n / 60.0, 1 / 60.0, pendulum);
    const long counts[2] = {pendulum.evaluations, pendulum.solves};
    for (int i = 0; i < 2; ++i) {
      least[i] = std::min(least[i], counts[i]);
      most[i] = std::max(most[i], counts[i]);
    }
  }
  const auto add = [&](const std::string& name, const std::string& asked, int i) {
    const std::string range = std::to_string(least[i]) + " to " + std::to_string(most[i]);
    card.rows.push_back({name, "Cost of a step", asked,
                         least[i] == most[i] ? Cell(double(most[i])) : Cell(range), whole});
  };
  add("evaluations", "evaluations of the acceleration", 0);
  add("solves", "linear systems solved", 1);
}

}  // namespace measure::card_lines
