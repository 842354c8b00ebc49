// SPDX-License-Identifier: MIT-0
/// @file
/// A seventh thing, which touches, switches and couples: a wheel and the chassis above it, over a
/// kerb.
#pragma once
#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "../cast.h"
#include "choose/entrants.h"
#include "integrate/dopri5.h"
#include "measure/record.h"
#include "measure/run.h"
#include "shelf/damper.h"
#include "shelf/soft_constraint.h"

// [wheel]
/// One corner of a small car: heights of a chassis and of a wheel above their places of rest [m].
/// The tyre pushes and never pulls.
struct Corner {
  double met = 0.5;      ///< when the tyre meets the kerb [s]
  double damper = 1500;  ///< between the two [N s/m]

  static constexpr double chassis = 250, wheel = 30;          // [kg]
  static constexpr double spring = 20'000, tyre = 200'000;    // [N/m]
  static constexpr double kerb = 0.1, climbed_in = 0.03;      // [m], [s]
  static constexpr double weight = 9.81 * (chassis + wheel);  // [N]

  /// The height of the road under the tyre [m].
  double road(double t) const { return kerb * std::clamp((t - met) / climbed_in, 0.0, 1.0); }

  /// The force of the tyre, beyond the one that carries the weight [N].
  double push(double wheel_at, double t) const {
    return std::max(0.0, tyre * (road(t) - wheel_at) + weight) - weight;
  }

  /// The acceleration, with a damper between the two [m/s^2].
  Eigen::Vector2d operator()(const Eigen::Vector2d& x, const Eigen::Vector2d& v, double t) const {
    const double between = spring * (x[1] - x[0]) + damper * (v[1] - v[0]);
    return {between / chassis, (push(x[1], t) - between) / wheel};
  }
  // [wheel]

  /// Hands the derivatives of the acceleration on.
  template <class Add>
  void jacobian(const Eigen::Vector2d& x, const Eigen::Vector2d&, double t, Add&& add) const {
    const double touches = tyre * (road(t) - x[1]) + weight > 0 ? tyre : 0;
    add(0, 0, -spring / chassis, -damper / chassis);
    add(0, 1, spring / chassis, damper / chassis);
    add(1, 0, spring / wheel, damper / wheel);
    add(1, 1, -(spring + touches) / wheel, -damper / wheel);
  }

  /// At rest on the road.
  scenes::State<Eigen::Vector2d> start() const { return {{0, 0}, {0, 0}}; }
};

/// Symplectic Euler that divides the relative velocity of the two for the damper between them.
struct DamperDivided {
  static constexpr std::string_view name = "damper divided";

  /// One step.
  void operator()(Eigen::Vector2d& x, Eigen::Vector2d& v, double t, double h,
                  const Corner& corner) const {
    const Eigen::Vector2d at_rest(0, 0);
    v = v + h * corner(x, at_rest, t);
    shelf::damper(v[0], v[1], h, corner.damper, 1 / Corner::chassis, 1 / Corner::wheel);
    x = x + h * v;
  }
};

/// Symplectic Euler for the tyre, and a soft constraint for spring and damper together.
struct StrutSoft {
  static constexpr std::string_view name = "soft constraint";

  /// One step.
  void operator()(Eigen::Vector2d& x, Eigen::Vector2d& v, double t, double h,
                  const Corner& corner) const {
    constexpr double lightness = 1 / Corner::chassis + 1 / Corner::wheel;
    const double omega = std::sqrt(Corner::spring * lightness);
    const double zeta = corner.damper * lightness / (2 * omega);
    v[1] = v[1] + h * corner.push(x[1], t) / Corner::wheel;
    double impulse = 0;
    shelf::soft_constraint(v[0], v[1], impulse, 1.0, x[1] - x[0], 1 / Corner::chassis,
                           1 / Corner::wheel, shelf::softness(h, omega, zeta), std::multiplies());
    x = x + h * v;
  }
};

inline constexpr double strong = 4;        ///< times the damper
inline constexpr double kerb_watched = 2;  ///< [s]
inline constexpr int kerb_moments = 20;    ///< at which a frame may meet the kerb

/// A corner that meets the kerb at one moment of a frame, and where it should be at the ends of
/// frames.
struct Kerb {
  Corner corner;
  std::vector<Eigen::Vector2d> truth;
};

/// The places at the ends of frames, by Dormand-Prince.
inline std::vector<Eigen::Vector2d> places_of(const Corner& corner) {
  const auto norm = [](const Eigen::Vector2d& error) { return error.norm(); };
  std::vector<Eigen::Vector2d> all{corner.start().x};
  auto path = integrate::dopri5_path(all[0], corner.start().v, 0.0, 1e-3, corner);
  for (int n = 1; n <= std::lround(kerb_watched / frame); ++n) {
    if (!integrate::dopri5_adaptive(path, n * frame, corner, norm, 1e-11))
      throw std::runtime_error("there is no truth for the kerb");
    all.push_back(path.position(n * frame));
  }
  return all;
}

/// All moments of a frame at which the tyre may meet the kerb; worked out once.
/// @param damper  [N s/m]
inline const std::vector<Kerb>& kerbs(double damper = Corner().damper) {
  static std::map<double, std::vector<Kerb>> known;
  auto& all = known[damper];
  for (int n = int(all.size()); n < kerb_moments; ++n) {
    const Corner corner{.met = 0.5 + (n + 0.5) / kerb_moments * frame, .damper = damper};
    all.push_back({corner, places_of(corner)});
  }
  return all;
}

/// The largest error of the wheel and the chassis at the end of a frame, both together, at the
/// worst of all moments [m]; infinite from ten metres on.
template <class Step>
double worst_over_kerb(const Step& step, int in_a_frame, double damper = Corner().damper) {
  const double h = frame / in_a_frame;
  double worst = 0;
  for (const auto& [corner, truth] : kerbs(damper)) {
    auto memory = measure::start(step, corner.start(), h, corner);
    long taken = 0;
    for (std::size_t seen = 1; seen < truth.size(); ++seen) {
      for (int n = 0; n < in_a_frame; ++n, ++taken)
        measure::advance(step, memory, double(taken) * h, h, corner);
      const auto now = measure::to_state(step, memory, double(taken) * h, h, corner);
      const double error = (now.x - truth[seen]).norm();
      if (!(error < 10)) return INFINITY;
      worst = std::max(worst, error);
    }
  }
  return worst;
}

inline void over_a_kerb(measure::Record& record) {
  auto& table = record.table("kerb", {{"method"},
                                      {"steps a frame", "", measure::whole},
                                      {"evaluations a second", "", measure::whole},
                                      {"error", "m"}});
  const auto add = [&](std::string_view name, const auto& step, double asked) {
    for (const int in_a_frame : {1, 2, 3, 4, 6, 8, 12, 16, 24}) {
      table.add({std::string(name), double(in_a_frame), in_a_frame * asked / frame,
                 worst_over_kerb(step, in_a_frame)});
    }
  };
  for (const measure::Method* method : entrants)
    add(method->name, *method, evaluations_per_step(*method));
  add(DamperDivided::name, DamperDivided(), 1);
  add(StrutSoft::name, StrutSoft(), 1);
  record.number("kerb-height", 100 * Corner::kerb, measure::whole, "cm");
  record.number("kerb-moments", kerb_moments, measure::whole);
  const auto number = [&](const char* name, const auto& step, int in_a_frame) {
    record.number(name, 100 * worst_over_kerb(step, in_a_frame), 2, "cm");
  };
  record.number("kerb-divided-strong",
                100 * worst_over_kerb(DamperDivided(), 1, strong * Corner().damper), 2, "cm");
  number("kerb-verlet-one", method::velocity_verlet, 1);
  number("kerb-symplectic-one", method::symplectic_euler, 1);
  number("kerb-divided-one", DamperDivided(), 1);
  number("kerb-divided-two", DamperDivided(), 2);
  record.number("kerb-verlet-two", 1000 * worst_over_kerb(method::velocity_verlet, 2), 2, "mm");
  record.number("kerb-verlet-four", 1000 * worst_over_kerb(method::velocity_verlet, 4), 2, "mm");
  record.number("kerb-rk4-one", 1000 * worst_over_kerb(method::rk4, 1), 2, "mm");
}
