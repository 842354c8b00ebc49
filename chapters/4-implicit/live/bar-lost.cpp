// SPDX-License-Identifier: MIT-0
// The bar of chapter 4 between a truck and its trailer, or one less stiff, under four methods.
#include <cmath>
#include <string>

#include "cast.h"
#include "live/figure.h"
#include "live/implicit.h"
#include "live/run.h"
#include "measure/methods/euler.h"
#include "measure/methods/runge_kutta.h"

namespace live {
namespace {

constexpr std::tuple methods{Method{"euler", measure::euler},
                             Method{"symplectic_euler", measure::symplectic_euler},
                             Method{"rk4", measure::rk4}, Method{"backward_euler", backward_euler}};

class BarLost final : public Figure {
  double omega_ = bar.omega, zeta_ = bar.zeta, rate_ = 1 / frame;
  scenes::Spring<> spring_ = bar;
  std::vector<std::unique_ptr<Run<double>>> runs_;
  std::vector<double> torn_;  // 1 for each that has been
  const std::vector<std::string> distances_ = names(methods, "distance");

  std::vector<Setting> settings() override {
    return {{"omega", &omega_}, {"zeta", &zeta_}, {"rate", &rate_}};
  }

  void start() override {
    spring_.omega = omega_;
    spring_.zeta = zeta_;
    runs_ = start_runs(methods, spring_, spring_.start(), 1 / rate_);
    torn_.assign(runs_.size(), 0);
    show_state();
  }

  void step() override {
    for (std::size_t i = 0; i < runs_.size(); ++i) {
      runs_[i]->step();
      if (!(std::abs(runs_[i]->now.x) < 5 * bar.x0)) torn_[i] = 1;
    }
  }

  void show_state() override {
    const double t = runs_.front()->t();
    show("t", t);
    show("h", 1 / rate_);
    const auto all = names(methods);
    for (std::size_t i = 0; i < runs_.size(); ++i) {
      show(all[i], runs_[i]->now.x);
      show(distances_[i].c_str(), std::abs(runs_[i]->now.x));
    }
    show("torn", torn_);
    const auto truth = spring_.exact(t);
    show_reference("true", truth.x);
    // How far it swings, which does not pass through nothing twice in each swing.
    show_reference("true distance", std::hypot(truth.x, truth.v / omega_));
  }
};

}  // namespace

std::unique_ptr<Figure> make_bar_lost() {
  return std::make_unique<BarLost>();
}

}  // namespace live
