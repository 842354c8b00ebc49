// SPDX-License-Identifier: MIT-0
/// @file
/// The forces that a test can ask for. The judge draws their constants from the seed; for a long
/// run the driver evaluates them, so that not every step costs a question.
#ifndef FORCE_H
#define FORCE_H
#include <array>
#include <cmath>

#include "given.h"

namespace harness {

struct Force {
  enum Kind {
    watched,  ///< by the judge itself, which sees where it is asked
    wild,     ///< smooth, bent, with drag and with wind that changes
    spring,   ///< a[0] omega [rad/s], a[1] zeta, pulling to the origin
    orbit,    ///< a[0] mu [m^3/s^2], pulling to the origin
    falling,  ///< a[0] gravity along -y [m/s^2], a[1] linear [1/s], a[2] quadratic drag [1/m]
  };

  Kind kind = watched;
  std::array<double, 8> a{};

  Vec operator()(const Vec& x, const Vec& v, double t) const {
    switch (kind) {
      case spring:
        return (-a[0] * a[0]) * x - (2 * a[1] * a[0]) * v;
      case orbit:
        return (-a[0] / (dot(x, x) * std::sqrt(dot(x, x)))) * x;
      case falling:
        return Vec{0, -a[0], 0} - (a[1] + a[2] * std::sqrt(dot(v, v))) * v;
      case wild:
        return bent(x) - (a[6] * std::sqrt(1 + dot(v, v))) * v + wind(t);
      case watched:
        break;
    }
    return {};
  }

 private:
  // Each axis has a stiffness of its own and feels the next one, so that no two can be swapped.
  Vec bent(const Vec& x) const {
    return {-a[0] * std::sin(a[1] * x.x + x.y), -a[2] * std::sin(x.y - a[3] * x.z),
            -a[4] * std::sin(x.z + a[5] * x.x)};
  }

  Vec wind(double t) const {
    return {std::cos(a[7] * t), std::sin(a[7] * t), std::cos(a[7] * t + 1)};
  }
};

}  // namespace harness
#endif
