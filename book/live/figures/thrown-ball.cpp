// SPDX-License-Identifier: MIT-0
// A thrown ball, with and without air: where it is, and where its steps put it.
#include <Eigen/Core>

#include "../figure.h"
#include "../run.h"
#include "scenes/linear_drag.h"

namespace live {
namespace {

using Vec = Eigen::Vector2d;

// Drag in proportion to the speed acts on each coordinate by itself, so that the fall of the book
// does for a throw: once sideways without gravity, once up.
struct Ball {
  scenes::LinearDrag<> across{.c = 0, .g = 0, .v0 = 10};
  scenes::LinearDrag<> up{.c = 0, .v0 = 10};

  Vec operator()(const Vec& x, const Vec& v, double t) const {
    return {across(x.x(), v.x(), t), up(x.y(), v.y(), t)};
  }
  Vec exact(double t) const { return {across.exact(t).x, up.exact(t).x}; }
};

constexpr std::tuple methods{Method{"euler", measure::euler},
                             Method{"constant_acceleration", measure::constant_acceleration}};

class ThrownBall final : public Figure {
  static constexpr double drag = 1;  // of the choice "air" [1/s]
  static constexpr double flight =
      2;  // [s]; without air the ball is back on the ground after 2.04 s

  double method_ = 0, rate_ = 20, air_ = 0;
  Ball ball_;
  std::unique_ptr<Run<Vec>> run_;

  std::vector<Setting> settings() override {
    return {
        {"method", &method_, names(methods)}, {"rate", &rate_}, {"air", &air_, {"none", "air"}}};
  }

  void start() override {
    ball_.across.c = ball_.up.c = air_ * drag;
    const scenes::State<Vec> thrown{Vec::Zero(), {ball_.across.v0, ball_.up.v0}};
    run_ = start_run(methods, method_, ball_, thrown, 1 / rate_);
    show_path();
    show_state();
  }

  void step() override { run_->step(); }

  void show_state() override {
    const Vec& x = run_->now.x;
    show("t", run_->t());
    show("h", run_->h);
    show("x", x.x());
    show("y", x.y());
    show_reference("error", (x - ball_.exact(run_->t())).norm());
  }

  // The true path, as points x, y, x, y.
  void show_path() {
    std::vector<double> path;
    for (int i = 0; i <= 100; ++i) {
      const Vec x = ball_.exact(flight * i / 100);
      path.insert(path.end(), {x.x(), x.y()});
    }
    show_reference("path", path);
  }
};

}  // namespace

std::unique_ptr<Figure> thrown_ball() {
  return std::make_unique<ThrownBall>();
}

}  // namespace live
