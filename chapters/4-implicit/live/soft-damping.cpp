// SPDX-License-Identifier: MIT-0
// A soft constraint of chapter 4, pulled and let go: what was asked for, and what one gets.
#include <numbers>

#include "4-implicit/soft_step.h"
#include "live/figure.h"
#include "live/run.h"
#include "live/step_limit.h"

namespace live {
namespace {

constexpr std::tuple methods{Method{"once", soft_step}, Method{"twice", soft_step_twice}};

class SoftDamping final : public Figure {
  double hertz_ = 5, zeta_ = 0, rate_ = 60, pulled_ = 1;
  scenes::Spring<> spring_;
  std::vector<std::unique_ptr<Run<double>>> runs_;

  std::vector<Setting> settings() override {
    return {{"hertz", &hertz_}, {"zeta", &zeta_}, {"rate", &rate_}, {"pulled", &pulled_}};
  }

  void start() override {
    spring_ = {.omega = 2 * std::numbers::pi * hertz_, .zeta = zeta_, .x0 = pulled_};
    runs_ = start_runs(methods, spring_, spring_.start(), 1 / rate_);
    const auto got = one_step(soft_step, spring_, 1 / rate_).effective(1 / rate_);
    show_reference("got zeta", got.zeta);
    show_reference("got hertz",
                   got.omega * std::sqrt(1 - got.zeta * got.zeta) / (2 * std::numbers::pi));
    show_state();
  }

  void step() override {
    for (const auto& run : runs_) run->step();
  }

  void show_state() override {
    const double t = runs_.front()->t();
    show("t", t);
    show("h", 1 / rate_);
    const auto all = names(methods);
    for (std::size_t i = 0; i < runs_.size(); ++i) show(all[i], runs_[i]->now.x);
    show_reference("asked", spring_.exact(t).x);
  }
};

}  // namespace

std::unique_ptr<Figure> make_soft_damping() {
  return std::make_unique<SoftDamping>();
}

}  // namespace live
