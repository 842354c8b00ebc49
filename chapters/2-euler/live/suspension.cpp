// SPDX-License-Identifier: MIT-0
// The suspension of a toy car from chapter 2, inside and outside the limit of its step.
#include "cast.h"
#include "live/figure.h"
#include "live/run.h"
#include "live/step_limit.h"
#include "measure/methods/euler.h"

namespace live {
namespace {

constexpr std::tuple methods{Method{"euler", measure::euler},
                             Method{"symplectic_euler", measure::symplectic_euler}};

class Suspension final : public Figure {
  static constexpr double shown_time = 1.5;                   // [s]
  static constexpr double shortest = 0.0001, longest = 0.25;  // steps to look for the limit [s]

  double method_ = 0, h_ = 0.011, zeta_ = suspension.zeta, pulled_ = suspension.x0;
  scenes::Spring<> spring_ = suspension;
  std::unique_ptr<Run<double>> run_;

  std::vector<Setting> settings() override {
    return {
        {"method", &method_, names(methods)}, {"h", &h_}, {"zeta", &zeta_}, {"pulled", &pulled_}};
  }

  void start() override {
    spring_.zeta = zeta_;
    spring_.x0 = pulled_;
    run_ = start_run(methods, method_, spring_, spring_.start(), h_);
    show_limit();
    show_reference("path", true_path(spring_, shown_time));
    show_state();
  }

  void step() override { run_->step(); }

  void show_state() override {
    const auto& [x, v] = run_->now;
    show("t", run_->t());
    show("h", h_);
    show("x", x);
    const double begin = spring_.energy(spring_.x0, spring_.v0);
    const auto truth = spring_.exact(run_->t());
    show("energy", spring_.energy(x, v) / begin);
    show_reference("true energy", spring_.energy(truth.x, truth.v) / begin);
  }

  // As the chapter finds it: by running the method.
  void show_limit() {
    const auto limits = std::apply(
        [this](const auto&... method) {
          return std::array{step_limit(method.step, spring_, shortest, longest)...};
        },
        methods);
    show("limit", limits[static_cast<std::size_t>(method_)]);
  }
};

}  // namespace

std::unique_ptr<Figure> make_suspension() {
  return std::make_unique<Suspension>();
}

}  // namespace live
