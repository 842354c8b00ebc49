// SPDX-License-Identifier: MIT-0
#include "live/examine.h"

#include <algorithm>
#include <cmath>
#include <string_view>
#include <tuple>

#include "measure/methods/euler.h"
#include "measure/methods/runge_kutta.h"
#include "measure/methods/verlet.h"

namespace live {
namespace {

using State = scenes::State<Vec3>;

// Place, velocity and time all count, and nothing is in a line with anything else.
class Trial final : public Force {
  Vec3 operator()(const Vec3& x, const Vec3& v, double t) const override {
    return (-4 - 0.3 * x.squaredNorm()) * x - 0.5 * v + t * t * Vec3(0.3, -0.2, 0.1);
  }
};

State after(Own& own, double h, int steps) {
  const Trial trial;
  own.start({{1, 0.3, -0.2}, {-0.4, 0.8, 0.1}}, h, trial);
  for (int n = 0; n < steps; ++n) own.step(n * h, h, trial);
  return own.now(steps * h, h, trial);
}

double apart(const State& a, const State& b) {
  return std::hypot((a.x - b.x).norm(), (a.v - b.v).norm());
}

constexpr double seconds = 2;  // of a run

State true_end() {
  constexpr int steps = 8192;
  OwnOf<measure::Rk4> true_enough;
  return after(true_enough, seconds / steps, steps);
}

// How well a method does, by two runs of steps that are short.
struct Fit {
  double order = NAN, error = NAN;
};

Fit fit_of(Own& own, const State& end) {
  constexpr int steps = 128;
  const double coarse = apart(after(own, seconds / steps, steps), end);
  const double fine = apart(after(own, seconds / (2 * steps), 2 * steps), end);
  return {coarse > fine ? std::log2(coarse / fine) : NAN, fine};
}

class Constant final : public Force {
  Vec3 push_;
  Vec3 operator()(const Vec3&, const Vec3&, double) const override { return push_; }

 public:
  explicit Constant(const Vec3& push) : push_(push) {}
};

// From rest, or pushed by nothing: how far along its way a step gets.
double share(Own& own, const Vec3& velocity, const Vec3& push) {
  constexpr double h = 0.1;
  const Constant constant(push);
  own.start({Vec3::Zero(), velocity}, h, constant);
  own.step(0, h, constant);
  const auto [x, v] = own.now(h, h, constant);
  return push.isZero() ? x.dot(velocity) / (h * velocity.squaredNorm())
                       : v.dot(push) / (h * push.squaredNorm());
}

void for_each_known(auto&& act) {
  std::apply([&](const auto&... known) { (act(known), ...); },
             std::tuple_cat(list::EulerFamily{}, list::RungeKuttaKin{}, list::VerletFamily{}));
}

}  // namespace

Examined examine(const Stand& stand) {
  constexpr double h = 0.1, alike = 1e-12;
  constexpr int steps = 3;
  const std::unique_ptr<Own> own = stand.make();
  const State yours = after(*own, h, steps);
  const State end = true_end();
  const Fit fit = fit_of(*own, end);
  Examined found{.order = fit.order,
                 .right_order = NAN,
                 .off = NAN,
                 .is = "",
                 .apart = alike,
                 .drifts = share(*own, {0.4, 0.8, -0.5}, Vec3::Zero()),
                 .kicks = share(*own, Vec3::Zero(), {0.3, -0.2, 0.1})};
  for_each_known([&]<class Step>(const Step&) {
    OwnOf<Step> known;
    if (Step::function == stand.method) {
      const Fit right = fit_of(known, end);
      found.right_order = right.order;
      found.off = fit.error / right.error;
    }
    const State other = after(known, h, steps);
    const double off = apart(yours, other) / std::hypot(other.x.norm(), other.v.norm());
    if (off < found.apart) found.apart = off, found.is = Step::name.data();
  });
  return found;
}

}  // namespace live
