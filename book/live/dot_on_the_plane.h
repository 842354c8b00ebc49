// SPDX-License-Identifier: MIT-0
/// @file
/// A spring as a dot on the plane of zeta and h omega, and what becomes of it step by step.
#pragma once
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "live/figure.h"
#include "live/run.h"
#include "live/step_limit.h"
#include "scenes/spring.h"

namespace live {

/// A spring at sixty steps a second, of which the reader sets the damping ratio and h omega, under
/// one of several methods, and for each of them the longest step at which it holds the spring.
template <class... Steps>
class DotOnThePlane final : public Figure {
  static constexpr double h = 1.0 / 60, seconds = 1.5;  // of a step, of the run [s]
  static constexpr double far = 10;  // a spring that was stretched so much is lost

  std::tuple<Method<Steps>...> methods_;
  double method_ = 0, zeta_ = 0.3, homega_ = 0.5, widest_;
  const std::vector<std::string> edge_names_;
  scenes::Spring<> spring_;
  std::unique_ptr<Run<double>> run_;
  bool lost_ = false;

 public:
  /// @param methods  to choose from
  /// @param widest  the largest damping ratio on the plane
  DotOnThePlane(std::tuple<Method<Steps>...> methods, double widest)
      : methods_(methods), widest_(widest), edge_names_(names(methods, "edge")) {}

 private:
  std::vector<Setting> settings() override {
    std::vector<Setting> found{{"zeta", &zeta_}, {"homega", &homega_}};
    if (sizeof...(Steps) > 1) found.push_back({"method", &method_, names(methods_)});
    return found;
  }

  void start() override {
    if (shown().empty()) show_edges();
    spring_ = {.omega = homega_ / h, .zeta = zeta_};
    lost_ = false;
    run_ = start_run(methods_, method_, spring_, spring_.start(), h);
    show_step();
    show_reference("path", true_path(spring_, seconds));
    show_state();
  }

  void step() override {
    lost_ = lost_ || !(std::abs(run_->now.x) < far);  // the first place out there is still shown
    run_->step();
  }

  void show_state() override {
    show("t", run_->t());
    show("h", h);
    show("x", lost_ ? std::numeric_limits<double>::quiet_NaN() : run_->now.x);
  }

  // By how much one step multiplies what lasts, and any area of places and velocities.
  void show_step() {
    std::size_t place = 0;
    const auto look = [&](const auto& method) {
      if (place++ != static_cast<std::size_t>(method_)) return;
      const auto step = one_step(method.step, spring_, h);
      show("factor", step.largest_eigenvalue());
      show("area", step.determinant());
    };
    std::apply([&](const auto&... method) { (look(method), ...); }, methods_);
  }

  // As the chapters find them: by running the methods.
  void show_edges() {
    constexpr int count = 62;
    std::vector<double> zetas;
    for (int i = 0; i <= count; ++i) zetas.push_back(widest_ * i / count);
    show("zetas", zetas);
    auto name = edge_names_.begin();
    const auto find = [&](const auto& method) {
      std::vector<double> edge;
      for (const double zeta : zetas) {
        edge.push_back(
            step_limit(method.step, scenes::Spring<>{.omega = 1, .zeta = zeta}, 1e-3, 20));
      }
      show((name++)->c_str(), edge);
    };
    std::apply([&](const auto&... method) { (find(method), ...); }, methods_);
  }
};

/// The figure of some methods.
/// @param methods  to choose from
/// @param widest  the largest damping ratio on the plane
template <class... Steps>
std::unique_ptr<Figure> make_dot_on_the_plane(std::tuple<Method<Steps>...> methods, double widest) {
  return std::make_unique<DotOnThePlane<Steps...>>(methods, widest);
}

}  // namespace live
