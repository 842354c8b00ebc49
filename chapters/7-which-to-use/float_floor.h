// SPDX-License-Identifier: MIT-0
/// @file
/// The accuracy that a float can have: the shuttle's turn in both precisions.
#pragma once
#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "level.h"
#include "measure/many_starts.h"
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

/// A place or a velocity of it [m or m/s].
template <class Real>
using ShuttleVec = typename scenes::Orbit<Real>::Vec;

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
/// @param s  where it starts
/// @param since  how long after its nearest point [s]
template <class Real, class Step>
double error_of_a_turn(const Step& step, long rate, scenes::State<ShuttleVec<Real>> s,
                       double since) {
  double largest = 0;
  long n = 0;
  measure::run(step, shuttle_in<Real>(), s, Real(1) / Real(rate), 8 * rate,
               [&](Real, const auto& now) {
                 const auto truth = shuttle.exact(since + double(n++) / double(rate)).x;
                 const double error = (now.x.template cast<double>() - truth).norm();
                 if (!(error <= largest)) largest = error;
               });
  return largest;
}

/// The largest error of one turn from its nearest point [m].
template <class Real, class Step>
double error_of_a_turn(const Step& step, long rate) {
  return error_of_a_turn<Real>(step, rate, shuttle_in<Real>().start(), 0);
}

inline constexpr int places = 100;  ///< on its way, from which a turn is tried

/// The values of `measured(s, since)` for starts in float all along its way, in order of size.
/// @param measured  gets the start, and how long it is after the nearest point [s]
template <class Measured>
std::vector<double> along_its_way(Measured measured) {
  return measure::all_around(places, [&](double angle) {
    const double since = shuttle_turn * angle / (2 * std::numbers::pi);
    const auto exact = shuttle.exact(since);
    return measured(scenes::State<ShuttleVec<float>>{exact.x.cast<float>(), exact.v.cast<float>()},
                    since);
  });
}

/// The errors of a turn in float from all along its way, in order of size [m].
template <class Step>
std::vector<double> errors_along_its_way(const Step& step, long rate) {
  return along_its_way(
      [&](const auto& s, double since) { return error_of_a_turn<float>(step, rate, s, since); });
}

/// The shares by which float changes the error of a turn, from all along its way, in order of size.
template <class Step>
std::vector<double> changes_by_float(const Step& step, long rate) {
  return along_its_way([&](const auto& s, double since) {
    const double right = error_of_a_turn<double>(step, rate, shuttle.exact(since), since);
    return std::abs(error_of_a_turn<float>(step, rate, s, since) / right - 1);
  });
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

/// The increments of a step, of the position [m] and of the velocity [m/s].
template <class Vec>
struct Added {
  Vec x, v;
};

/// The increments of a step of RK4.
template <class Vec, class Real, class Acceleration>
Added<Vec> rk4_adds(const Vec& x, const Vec& v, Real t, Real h, Acceleration&& a) {
  const Real half = h / 2, sixth = h / 6;
  const Vec a1 = a(x, v, t);
  const Vec v2 = v + half * a1, a2 = a(Vec(x + half * v), v2, t + half);
  const Vec v3 = v + half * a2, a3 = a(Vec(x + half * v2), v3, t + half);
  const Vec v4 = v + h * a3, a4 = a(Vec(x + h * v3), v4, t + h);
  return {sixth * (v + Real(2) * v2 + Real(2) * v3 + v4),
          sixth * (a1 + Real(2) * a2 + Real(2) * a3 + a4)};
}

/// One turn in float, by RK4 with compensated sums; `observe(n, x)` before each step and at the
/// end.
template <class Observe>
void compensated_turn(scenes::State<ShuttleVec<float>> s, long rate, Observe observe) {
  const auto scene = shuttle_in<float>();
  ShuttleVec<float> lost_x{0, 0}, lost_v{0, 0};
  for (long n = 0; n <= 8 * rate; ++n) {
    observe(n, s.x);
    const auto more = rk4_adds(s.x, s.v, float(n) / float(rate), 1 / float(rate), scene);
    add(s.x, more.x, lost_x);
    add(s.v, more.v, lost_v);
  }
}

/// The largest error of such a turn [m].
inline double compensated_error(long rate) {
  double largest = 0;
  compensated_turn(shuttle_in<float>().start(), rate, [&](long n, const ShuttleVec<float>& x) {
    const auto truth = shuttle.exact(double(n) / double(rate)).x;
    largest = std::max(largest, (x.cast<double>() - truth).norm());
  });
  return largest;
}

/// The largest distance of such a turn from one in double that starts from the same floats [m].
inline double rounding_of_sums(const scenes::State<ShuttleVec<float>>& s, long rate) {
  const auto coarse = shuttle_in<float>();
  const scenes::Orbit<> fine{
      .eccentricity = coarse.eccentricity, .semi_major = coarse.semi_major, .mu = coarse.mu};
  const double h = 1 / float(rate);
  ShuttleVec<double> x = s.x.cast<double>(), v = s.v.cast<double>();
  double largest = 0;
  compensated_turn(s, rate, [&](long n, const ShuttleVec<float>& rounded) {
    largest = std::max(largest, (rounded.cast<double>() - x).norm());
    measure::rk4(x, v, double(n) * h, h, fine);
  });
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
  record.number("float-places", places, measure::whole);
  record.number("float-far", 100 * error_far_away(measure::rk4, 60), 1, "cm");
  record.number("float-fastest", table.rows.back()[0].value, measure::whole, "Hz");
}
