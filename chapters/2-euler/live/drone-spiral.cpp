// SPDX-License-Identifier: MIT-0
// The drone of chapter 2, which should stay on its circle.
#include "cast.h"
#include "live/figure.h"
#include "live/run.h"
#include "measure/methods/euler.h"

namespace live {
namespace {

using Vec = Eigen::Vector2d;

constexpr std::tuple methods{Method{"euler", measure::euler},
                             Method{"symplectic_euler", measure::symplectic_euler}};

class DroneSpiral final : public Figure {
  double method_ = 0, rate_ = 1 / frame;
  std::unique_ptr<Run<Vec>> run_;

  std::vector<Setting> settings() override {
    return {{"method", &method_, names(methods)}, {"rate", &rate_}};
  }

  void start() override {
    run_ = start_run(methods, method_, drone, drone.start(), 1 / rate_);
    show_state();
  }

  void step() override { run_->step(); }

  void show_state() override {
    const auto& [x, v] = run_->now;
    const auto begin = drone.start();
    show("t", run_->t());
    show("h", run_->h);
    show("x", x.x());
    show("y", x.y());
    show("distance", x.norm());
    show("true energy", 1);
    show("energy", drone.energy(x, v) / drone.energy(begin.x, begin.v));
  }
};

}  // namespace

std::unique_ptr<Figure> make_drone_spiral() {
  return std::make_unique<DroneSpiral>();
}

}  // namespace live
