// SPDX-License-Identifier: MIT-0
// Four methods on the drone of chapter 3, each of which asks for the acceleration equally often.
#include <algorithm>

#include "3-runge-kutta/toys.h"
#include "live/figure.h"
#include "live/run.h"
#include "measure/evaluations.h"
#include "measure/methods/euler.h"
#include "measure/methods/runge_kutta.h"

namespace live {
namespace {

using Vec = Eigen::Vector2d;

constexpr std::tuple methods{Method{"euler", measure::euler},
                             Method{"symplectic_euler", measure::symplectic_euler},
                             Method{"midpoint", measure::midpoint}, Method{"rk4", measure::rk4}};

/// What is shown of one method: where its drone is and where it should be, and how far apart they
/// are and have been at most.
struct Names {
  const char *x, *y, *true_x, *true_y, *error, *worst;
};
constexpr Names names_of[] = {
    {"euler x", "euler y", "euler true x", "euler true y", "euler error", "euler worst"},
    {"symplectic_euler x", "symplectic_euler y", "symplectic_euler true x",
     "symplectic_euler true y", "symplectic_euler error", "symplectic_euler worst"},
    {"midpoint x", "midpoint y", "midpoint true x", "midpoint true y", "midpoint error",
     "midpoint worst"},
    {"rk4 x", "rk4 y", "rk4 true x", "rk4 true y", "rk4 error", "rk4 worst"}};

// Time passes by one evaluation after the other. A method takes its step when it has all of those
// that the step needs.
class EqualCost final : public Figure {
  static constexpr std::size_t count = std::size(names_of);

  double method_ = 3, orbit_ = 0, rate_ = 16;
  long evaluations_ = 0;
  std::array<long, count> cost_{};
  std::array<std::unique_ptr<Run<Vec>>, count> runs_;
  std::array<double, count> worst_{};  // [m]

  std::vector<Setting> settings() override {
    return {{"method", &method_, names(methods)},
            {"orbit", &orbit_, {"circle", "ellipse"}},
            {"rate", &rate_}};
  }

  void start() override {
    evaluations_ = 0;
    worst_ = {};
    cost_ = std::apply(
        [](const auto&... method) {
          return std::array{measure::evaluations_per_step(method.step, drone, frame)...};
        },
        methods);
    for (std::size_t i = 0; i < count; ++i) {
      const double step = double(cost_[i]) / rate_;
      runs_[i] = orbit_ == 0 ? start_run(methods, double(i), drone, drone.start(), step)
                             : start_run(methods, double(i), ellipse, ellipse.start(), step);
    }
    show_state();
  }

  void step() override {
    ++evaluations_;
    for (std::size_t i = 0; i < count; ++i) {
      if (evaluations_ % cost_[i] != 0) continue;
      runs_[i]->step();
      worst_[i] = std::max(worst_[i], error(*runs_[i]));
    }
  }

  Vec place(double t) const { return orbit_ == 0 ? drone.exact(t).x : ellipse.exact(t).x; }

  double error(const Run<Vec>& run) const { return (run.now.x - place(run.t())).norm(); }

  void show_state() override {
    show("t", double(evaluations_) / rate_);
    show("h", 1 / rate_);
    for (std::size_t i = 0; i < count; ++i) {
      const Vec& x = runs_[i]->now.x;
      const Vec truth = place(runs_[i]->t());
      show(names_of[i].x, x.x());
      show(names_of[i].y, x.y());
      show_reference(names_of[i].true_x, truth.x());
      show_reference(names_of[i].true_y, truth.y());
      show_reference(names_of[i].error, (x - truth).norm());
      show_reference(names_of[i].worst, worst_[i]);
    }
    show("steps", double(runs_[static_cast<std::size_t>(method_)]->steps));
  }
};

}  // namespace

std::unique_ptr<Figure> make_equal_cost() {
  return std::make_unique<EqualCost>();
}

}  // namespace live
