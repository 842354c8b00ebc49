// SPDX-License-Identifier: MIT-0
// A thrown ball, with and without air: where it is, and where its steps put it.
#include "1-test-case/ball.h"
#include "live/figure.h"
#include "live/run.h"
#include "measure/methods/euler.h"

namespace live {
namespace {

constexpr std::tuple methods{Method{"euler", measure::euler},
                             Method{"constant_acceleration", measure::constant_acceleration}};

class ThrownBall final : public Figure {
  static constexpr double flight = 2;  // [s]; in a vacuum the ball is on the ground after 2.04 s

  double method_ = 0, rate_ = 20, air_ = 0;
  double throw_x_ = in_a_vacuum.across.v0, throw_y_ = in_a_vacuum.up.v0;  // [m/s]
  Ball ball_ = in_a_vacuum;
  std::unique_ptr<Run<Ball::Vec>> run_;

  std::vector<Setting> settings() override {
    return {{"method", &method_, names(methods)},
            {"rate", &rate_},
            {"air", &air_, {"none", "drag"}},
            {"throw x", &throw_x_},
            {"throw y", &throw_y_}};
  }

  void start() override {
    ball_ = air_ == 0 ? in_a_vacuum : in_air;
    ball_.across.v0 = throw_x_;
    ball_.up.v0 = throw_y_;
    run_ = start_run(methods, method_, ball_, ball_.start(), 1 / rate_);
    show_path();
    show_state();
  }

  void step() override { run_->step(); }

  void show_state() override {
    const Ball::Vec& x = run_->now.x;
    show("t", run_->t());
    show("h", run_->h);
    show("x", x.x());
    show("y", x.y());
    show_reference("error", (x - ball_.exact(run_->t()).x).norm());
  }

  // The true path, as points x, y, x, y.
  void show_path() {
    std::vector<double> path;
    for (int i = 0; i <= 100; ++i) {
      const Ball::Vec x = ball_.exact(flight * i / 100).x;
      path.insert(path.end(), {x.x(), x.y()});
    }
    show_reference("path", path);
  }
};

}  // namespace

std::unique_ptr<Figure> make_thrown_ball() {
  return std::make_unique<ThrownBall>();
}

}  // namespace live
