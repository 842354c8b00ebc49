// SPDX-License-Identifier: MIT-0
/// @file
/// How right a float can be: the shuttle's turn in both precisions.
#pragma once
#include <algorithm>
#include <cmath>

#include "level.h"
#include "measure/methods.h"
#include "measure/record.h"
#include "measure/run.h"

/// The shuttle in another precision.
template <class Real>
scenes::Orbit<Real> shuttle_in() {
  return {.eccentricity = Real(shuttle.eccentricity),
          .semi_major = Real(shuttle.semi_major),
          .mu = Real(shuttle.mu)};
}

/// The shuttle in float, its planet far away from the origin.
struct FarShuttle : scenes::Orbit<float> {
  Vec planet{0, 0};

  Vec operator()(const Vec& x, const Vec& v, float t) const {
    return scenes::Orbit<float>::operator()(Vec(x - planet), v, t);
  }
};

inline constexpr float far_away = 10'000;  ///< [m]

/// The largest error of one turn around a planet far along the first axis, in float [m].
template <class Step>
double error_far_away(const Step& step, long rate) {
  const FarShuttle scene{shuttle_in<float>(), {far_away, 0}};
  auto s = scene.start();
  s.x += scene.planet;
  double largest = 0;
  long n = 0;
  measure::run(step, scene, s, 1 / float(rate), 8 * rate, [&](float, const auto& now) {
    const Eigen::Vector2d truth =
        shuttle.exact(double(n++) / double(rate)).x + Eigen::Vector2d(far_away, 0);
    largest = std::max(largest, (now.x.template cast<double>() - truth).norm());
  });
  return largest;
}

/// The largest error of one turn, stepped in `Real` and compared with the truth in double [m].
template <class Real, class Step>
double error_of_a_turn(const Step& step, long rate) {
  const auto scene = shuttle_in<Real>();
  auto s = scene.start();
  double largest = 0;
  long n = 0;
  measure::run(step, scene, s, Real(1) / Real(rate), 8 * rate, [&](Real, const auto& now) {
    const auto truth = shuttle.exact(double(n++) / double(rate)).x;
    const double error = (now.x.template cast<double>() - truth).norm();
    if (!(error <= largest)) largest = error;
  });
  return largest;
}

// [add]
/// Adds a little to a lot, and keeps in `lost` what did not fit.
template <class Vec>
void add(Vec& sum, const Vec& little, Vec& lost) {
  const Vec more = little + lost;
  const Vec before = sum;
  sum = sum + more;
  lost = more - (sum - before);
}
// [add]

/// What a step of RK4 adds to the position and to the velocity.
template <class Vec, class Real, class Acceleration>
scenes::State<Vec> rk4_adds(const Vec& x, const Vec& v, Real t, Real h, Acceleration&& a) {
  const Real half = h / 2, sixth = h / 6;
  const Vec a1 = a(x, v, t);
  const Vec v2 = v + half * a1, a2 = a(Vec(x + half * v), v2, t + half);
  const Vec v3 = v + half * a2, a3 = a(Vec(x + half * v2), v3, t + half);
  const Vec v4 = v + h * a3, a4 = a(Vec(x + h * v3), v4, t + h);
  return {sixth * (v + Real(2) * v2 + Real(2) * v3 + v4),
          sixth * (a1 + Real(2) * a2 + Real(2) * a3 + a4)};
}

/// The largest error of one turn in float, by RK4 with compensated sums [m].
inline double compensated_error(long rate) {
  const auto scene = shuttle_in<float>();
  auto s = scene.start();
  scenes::Orbit<float>::Vec lost_x{0, 0}, lost_v{0, 0};
  double largest = 0;
  for (long n = 0; n <= 8 * rate; ++n) {
    const auto truth = shuttle.exact(double(n) / double(rate)).x;
    largest = std::max(largest, (s.x.cast<double>() - truth).norm());
    const auto more = rk4_adds(s.x, s.v, float(n) / float(rate), 1 / float(rate), scene);
    add(s.x, more.x, lost_x);
    add(s.v, more.v, lost_v);
  }
  return largest;
}

inline void floor_of_float(measure::Record& record) {
  auto& table = record.table("floor", {{"steps per second", "", measure::whole},
                                       {"symplectic Euler", "m"},
                                       {"symplectic Euler float", "m"},
                                       {"velocity Verlet", "m"},
                                       {"velocity Verlet float", "m"},
                                       {"RK4", "m"},
                                       {"RK4 float", "m"},
                                       {"RK4 compensated", "m"}});
  for (long rate = 30; rate <= 30 * 256; rate *= 2) {
    table.add({double(rate), error_of_a_turn<double>(measure::symplectic_euler, rate),
               error_of_a_turn<float>(measure::symplectic_euler, rate),
               error_of_a_turn<double>(measure::velocity_verlet, rate),
               error_of_a_turn<float>(measure::velocity_verlet, rate),
               error_of_a_turn<double>(measure::rk4, rate),
               error_of_a_turn<float>(measure::rk4, rate), compensated_error(rate)});
  }
  const double rounded = error_of_a_turn<float>(measure::velocity_verlet, 240);
  record.number(
      "float-verlet-240",
      100 * std::abs(rounded / error_of_a_turn<double>(measure::velocity_verlet, 240) - 1), 1, "%");
  record.number("float-far", 100 * error_far_away(measure::rk4, 60), 1, "cm");
  record.number("float-fastest", table.rows.back()[0].value, measure::whole, "Hz");
  const auto best =
      std::min_element(table.rows.begin(), table.rows.end(),
                       [](const auto& a, const auto& b) { return a[6].value < b[6].value; });
  record.number("float-best", 1e6 * (*best)[6].value, 2, "µm");
  record.number("float-best-rate", (*best)[0].value, measure::whole);
}
