// SPDX-License-Identifier: MIT-0
// The reader's own spring under every method of chapter 7's map.
#include <cmath>
#include <limits>

#include "live/figure.h"
#include "live/implicit.h"
#include "live/run.h"
#include "measure/methods/damping.h"
#include "measure/methods/euler.h"
#include "measure/methods/runge_kutta.h"
#include "measure/methods/spring.h"
#include "measure/methods/verlet.h"
#include "scenes/spring.h"

namespace live {
namespace {

constexpr std::tuple methods{
    Method{"euler", measure::euler},
    Method{"midpoint", measure::midpoint},
    Method{"rk4", measure::rk4},
    Method{"dopri5", measure::dopri5},
    Method{"symplectic_euler", measure::symplectic_euler},
    Method{"linear_damping_implicit_last", measure::linear_damping_implicit_last},
    Method{"velocity_verlet", measure::velocity_verlet},
    Method{"yoshida4", measure::yoshida4},
    Method{"predicted_euler", measure::predicted_euler<1>},
    Method{"trapezoid", trapezoid},
    Method{"backward_euler", backward_euler},
    Method{"spring_exact", measure::spring_exact}};

class YourSpring final : public Figure {
  static constexpr double shown_time = 1;  // [s]
  static constexpr double far = 10;        // a spring that was stretched so much is lost

  double method_ = 4, omega_ = 40, zeta_ = 1, rate_ = 30;
  scenes::Spring<> spring_;
  std::vector<std::unique_ptr<Run<double>>> runs_;
  bool lost_ = false;

  std::vector<Setting> settings() override {
    return {{"method", &method_, names(methods)},
            {"omega", &omega_},
            {"zeta", &zeta_},
            {"rate", &rate_}};
  }

  void start() override {
    spring_ = {.omega = omega_, .zeta = zeta_};
    runs_ = start_runs(methods, spring_, spring_.start(), 1 / rate_);
    lost_ = false;
    show_reference("path", true_path(spring_, shown_time));
    show_state();
  }

  void step() override {
    lost_ = lost_ || !(std::abs(chosen().now.x) < far);  // the first place out there is still shown
    for (const auto& run : runs_) run->step();
  }

  const Run<double>& chosen() const { return *runs_[static_cast<std::size_t>(method_)]; }

  void show_state() override {
    const double t = runs_.front()->t();
    show("t", t);
    show("h", 1 / rate_);
    show("far", far);
    const auto all = names(methods);
    for (std::size_t i = 0; i < all.size(); ++i) show_run(all[i], *runs_[i], runs_[i]->now.x);
    show_run("x", chosen(), lost_ ? std::numeric_limits<double>::quiet_NaN() : chosen().now.x);
    show_reference("true x", spring_.exact(t).x);
  }

  // The exact step is made of the C library's sines.
  void show_run(const char* name, const Run<double>& run, double x) {
    &run == runs_.back().get() ? show_reference(name, x) : show(name, x);
  }
};

}  // namespace

std::unique_ptr<Figure> make_your_spring() {
  return std::make_unique<YourSpring>();
}

}  // namespace live
