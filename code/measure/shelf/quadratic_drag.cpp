// SPDX-License-Identifier: MIT-0
#include "shelf/quadratic_drag.h"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "integrate/rk4.h"
#include "measure/shelf_card.h"

namespace measure::shelf_cards {
namespace {

using Eigen::Vector2d;
using Long2 = Eigen::Matrix<long double, 2, 1>;

const auto norm = [](const auto& v) { return v.norm(); };

// A fall or a rise in so many steps of RK4 that its own error is less than a rounding of a double.
struct Fine {
  long double x = 0, v;

  Fine(double start, double a, double k, double h) : v(start) {
    const auto force = [a, k](long double, long double speed, long double) {
      return a - k * std::abs(speed) * speed;
    };
    const int steps = 400 + int(3000 * h * k * std::abs(start));
    const long double part = static_cast<long double>(h) / steps;
    for (int n = 0; n < steps; ++n) integrate::rk4(x, v, 0.0L, part, force);
  }
};

Promise line() {
  double off = 0;
  for (const double a : {-9.81, 0.0, 9.81}) {
    for (const double reach : {0.001, 0.5, 2.5, 18.0}) {
      for (const double start : {-40.0, -1.0, 0.0, 1.0, 40.0}) {
        const double h = 1 / 60.0, k = reach / (h * 40);
        const Fine fine(start, a, k, h);
        double x = 0, v = start;
        shelf::quadratic_drag_fall(x, v, a, k, h);
        const double way = h * (std::abs(start) + h * std::abs(a)) / (1 + reach);
        if (way > 0) off = std::max(off, std::abs(x - double(fine.x)) / way);
        off = std::max(off, std::abs(v - double(fine.v)) / 40);
      }
    }
  }
  return {
      "along a line it is where fine steps of RK4 take it, up and down, to 1e-12 of the way, for h "
      "k "
      "v up to 18",
      off < 1e-12, off};
}

// A ball that is served at 50 m/s, against a wind of 5 m/s, after a second.
template <class Vec, class Real, class Step>
Vec served(int steps, const Step& step) {
  Vec x(0, 2.5), v(50, 0);
  for (int n = 0; n < steps; ++n) step(x, v, Real(1) / Real(steps));
  return x;
}

Vector2d by_shelf(int steps) {
  return served<Vector2d, double>(steps, [](Vector2d& x, Vector2d& v, double h) {
    shelf::quadratic_drag(x, v, Vector2d(0, -9.81), Vector2d(-5, 0), 0.02, h, norm);
  });
}

Vector2d truly_served() {
  const auto force = [](const Long2&, const Long2& v, long double) {
    const Long2 through = v - Long2(-5, 0);
    return Long2(Long2(0, -9.81L) - (0.02L * through.norm()) * through);
  };
  return served<Long2, long double>(
             2000, [&](Long2& x, Long2& v, long double h) { integrate::rk4(x, v, 0.0L, h, force); })
      .cast<double>();
}

Promise order() {
  const Vector2d there = truly_served();
  const double order = std::log2((by_shelf(60) - there).norm() / (by_shelf(120) - there).norm());
  return {"in any direction, with gravity and wind, it has order 2 to 0.02",
          std::abs(order - 2) < 0.02, order, 4};
}

Promise tennis() {
  const double off = (by_shelf(60) - truly_served()).norm();
  return {"a tennis ball at 50 m/s is less than 0.2 mm off after a second, in steps of 1/60 s",
          off < 2e-4, off, 2, "m"};
}

Promise coasting() {
  double off = 0;
  Vector2d first(0, 0);
  for (const int rate : {15, 30, 60, 120, 240}) {
    Vector2d x(0, 0), v(30, 40);
    for (int n = 0; n < rate; ++n)
      shelf::quadratic_drag(x, v, Vector2d(0, 0), Vector2d(0, 0), 0.3, 1.0 / rate, norm);
    if (rate == 15) first = x;
    off = std::max(off, (x - first).norm() / first.norm());
  }
  return {
      "what nothing pushes ends a second in the same place at 15, 30, 60, 120 and 240 Hz, to 1e-14 "
      "of the way",
      off < 1e-14, off};
}

Promise last_speed() {
  double off = 0;
  for (const double last : {5.0, 2.0, 0.6}) {
    const double h = 1 / 60.0, k = 9.81 / (last * last);
    Vector2d x(0, 0), v(0, 0);
    for (int n = 0; n < 6000; ++n)
      shelf::quadratic_drag(x, v, Vector2d(0, -9.81), Vector2d(0, 0), k, h, norm);
    off = std::max(off, std::abs((-v.y() / last - 1) / (k * 9.81 * h * h / 8) - 1));
  }
  return {
      "it ends too fast by a share of k |a| h^2 / 8, to a tenth of that, for last speeds from 0.6 "
      "to "
      "5 m/s at 60 Hz",
      off < 0.1, off};
}

Promise always_a_number() {
  bool finite = true;
  for (double reach = 1e-6; reach < 1e30; reach *= 10) {
    Vector2d x(0, 0), v(300, 400);
    double place = 0, speed = 500;
    for (int n = 0; n < 20; ++n) {
      const double h = 1 / 60.0, k = reach / (500 * h);
      shelf::quadratic_drag(x, v, Vector2d(0, -9.81), Vector2d(5, 0), k, h, norm);
      shelf::quadratic_drag_fall(place, speed, -9.81, k, h);
    }
    finite = finite && x.allFinite() && v.allFinite() && std::isfinite(place + speed);
  }
  double x = 0, v = 2.5 * 60;
  const auto force = [](double, double speed, double) { return -std::abs(speed) * speed; };
  for (int n = 0; n < 20; ++n) integrate::rk4(x, v, 0.0, 1 / 60.0, force);
  return {
      "both stay numbers for h k v from 1e-6 to 1e29, where RK4 is none after 20 steps with 2.5",
      finite && !std::isfinite(v), finite ? Cell("finite") : Cell("not finite")};
}

}  // namespace

ShelfCard quadratic_drag() {
  return {"quadratic_drag",
          {line(), order(), tennis(), coasting(), last_speed(), always_a_number()}};
}

}  // namespace measure::shelf_cards
