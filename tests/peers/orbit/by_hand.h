// SPDX-License-Identifier: MIT-0
// The formulas written out for this one scene, in plain numbers: what there is to reach.
#pragma once
#include "orbit/state.h"

namespace orbit::by_hand {

struct Planet : State {
  using Shared = Nothing;
  explicit Planet(State s) : State(s) {}
  State state() const { return *this; }
};

struct SymplecticEuler : Planet {
  using Planet::Planet;
  void step(Nothing, double, double h) {
    const double p = pull(x * x + y * y);
    vx += h * (p * x);
    vy += h * (p * y);
    x += h * vx;
    y += h * vy;
  }
};

/// A planet whose acceleration is kept from one step to the next.
struct Accelerated : Planet {
  double ax = pull(x * x + y * y) * x;
  double ay = pull(x * x + y * y) * y;
  using Planet::Planet;
};

struct VelocityVerlet : Accelerated {
  using Accelerated::Accelerated;
  void step(Nothing, double, double h) {
    const double half_x = vx + h / 2 * ax;
    const double half_y = vy + h / 2 * ay;
    x += h * half_x;
    y += h * half_y;
    const double p = pull(x * x + y * y);
    ax = p * x;
    ay = p * y;
    vx = half_x + h / 2 * ax;
    vy = half_y + h / 2 * ay;
  }
};

struct Rk4 : Planet {
  using Planet::Planet;
  void step(Nothing, double, double h) {
    const double p1 = pull(x * x + y * y);
    const double ax1 = p1 * x, ay1 = p1 * y;
    const double vx2 = vx + h / 2 * ax1, vy2 = vy + h / 2 * ay1;
    const double x2 = x + h / 2 * vx, y2 = y + h / 2 * vy;
    const double p2 = pull(x2 * x2 + y2 * y2);
    const double ax2 = p2 * x2, ay2 = p2 * y2;
    const double vx3 = vx + h / 2 * ax2, vy3 = vy + h / 2 * ay2;
    const double x3 = x + h / 2 * vx2, y3 = y + h / 2 * vy2;
    const double p3 = pull(x3 * x3 + y3 * y3);
    const double ax3 = p3 * x3, ay3 = p3 * y3;
    const double vx4 = vx + h * ax3, vy4 = vy + h * ay3;
    const double x4 = x + h * vx3, y4 = y + h * vy3;
    const double p4 = pull(x4 * x4 + y4 * y4);
    const double ax4 = p4 * x4, ay4 = p4 * y4;
    x += h / 6 * (vx + 2 * (vx2 + vx3) + vx4);
    y += h / 6 * (vy + 2 * (vy2 + vy3) + vy4);
    vx += h / 6 * (ax1 + 2 * (ax2 + ax3) + ax4);
    vy += h / 6 * (ay1 + 2 * (ay2 + ay3) + ay4);
  }
};

/// Without the estimate of its error, which nobody asks for here.
struct Dopri5 : Accelerated {
  using Accelerated::Accelerated;
  void step(Nothing, double, double h) {
    const double vx2 = vx + h * (1.0 / 5 * ax), vy2 = vy + h * (1.0 / 5 * ay);
    const double x2 = x + h * (1.0 / 5 * vx), y2 = y + h * (1.0 / 5 * vy);
    const double p2 = pull(x2 * x2 + y2 * y2);
    const double ax2 = p2 * x2, ay2 = p2 * y2;
    const auto third = [h](double k1, double k2) { return h * (3.0 / 40 * k1 + 9.0 / 40 * k2); };
    const double vx3 = vx + third(ax, ax2), vy3 = vy + third(ay, ay2);
    const double x3 = x + third(vx, vx2), y3 = y + third(vy, vy2);
    const double p3 = pull(x3 * x3 + y3 * y3);
    const double ax3 = p3 * x3, ay3 = p3 * y3;
    const auto fourth = [h](double k1, double k2, double k3) {
      return h * (44.0 / 45 * k1 - 56.0 / 15 * k2 + 32.0 / 9 * k3);
    };
    const double vx4 = vx + fourth(ax, ax2, ax3), vy4 = vy + fourth(ay, ay2, ay3);
    const double x4 = x + fourth(vx, vx2, vx3), y4 = y + fourth(vy, vy2, vy3);
    const double p4 = pull(x4 * x4 + y4 * y4);
    const double ax4 = p4 * x4, ay4 = p4 * y4;
    const auto fifth = [h](double k1, double k2, double k3, double k4) {
      return h *
             (19372.0 / 6561 * k1 - 25360.0 / 2187 * k2 + 64448.0 / 6561 * k3 - 212.0 / 729 * k4);
    };
    const double vx5 = vx + fifth(ax, ax2, ax3, ax4), vy5 = vy + fifth(ay, ay2, ay3, ay4);
    const double x5 = x + fifth(vx, vx2, vx3, vx4), y5 = y + fifth(vy, vy2, vy3, vy4);
    const double p5 = pull(x5 * x5 + y5 * y5);
    const double ax5 = p5 * x5, ay5 = p5 * y5;
    const auto sixth = [h](double k1, double k2, double k3, double k4, double k5) {
      return h * (9017.0 / 3168 * k1 - 355.0 / 33 * k2 + 46732.0 / 5247 * k3 + 49.0 / 176 * k4 -
                  5103.0 / 18656 * k5);
    };
    const double vx6 = vx + sixth(ax, ax2, ax3, ax4, ax5), vy6 = vy + sixth(ay, ay2, ay3, ay4, ay5);
    const double x6 = x + sixth(vx, vx2, vx3, vx4, vx5), y6 = y + sixth(vy, vy2, vy3, vy4, vy5);
    const double p6 = pull(x6 * x6 + y6 * y6);
    const double ax6 = p6 * x6, ay6 = p6 * y6;
    const auto last = [h](double k1, double k3, double k4, double k5, double k6) {
      return h * (35.0 / 384 * k1 + 500.0 / 1113 * k3 + 125.0 / 192 * k4 - 2187.0 / 6784 * k5 +
                  11.0 / 84 * k6);
    };
    x += last(vx, vx3, vx4, vx5, vx6);
    y += last(vy, vy3, vy4, vy5, vy6);
    vx += last(ax, ax3, ax4, ax5, ax6);
    vy += last(ay, ay3, ay4, ay5, ay6);
    const double p = pull(x * x + y * y);
    ax = p * x;
    ay = p * y;
  }
};

/// Position and velocity packed into one vector of four, as books on differential equations have
/// it: y' = f(t, y).
template <class Vector4>
class Rk4Packed {
 public:
  using Shared = Nothing;
  explicit Rk4Packed(State s) : y_(s.x, s.y, s.vx, s.vy) {}
  void step(Nothing, double, double h) {
    const auto f = [](const Vector4& y) -> Vector4 {
      const double p = pull(y[0] * y[0] + y[1] * y[1]);
      return Vector4(y[2], y[3], p * y[0], p * y[1]);
    };
    const Vector4 k1 = f(y_);
    const Vector4 k2 = f(y_ + h / 2 * k1);
    const Vector4 k3 = f(y_ + h / 2 * k2);
    const Vector4 k4 = f(y_ + h * k3);
    y_ += h / 6 * (k1 + 2 * (k2 + k3) + k4);
  }
  State state() const { return {y_[0], y_[1], y_[2], y_[3]}; }

 private:
  Vector4 y_;
};

}  // namespace orbit::by_hand
