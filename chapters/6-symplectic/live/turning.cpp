// SPDX-License-Identifier: MIT-0
// The shuttle of chapter 6, for a thousand turns.
#include <algorithm>
#include <cstddef>
#include <limits>

#include "6-symplectic/shuttle.h"
#include "live/figure.h"
#include "live/run.h"
#include "measure/methods/euler.h"
#include "measure/methods/runge_kutta.h"
#include "measure/methods/verlet.h"

namespace live {
namespace {

using Vec = Eigen::Vector2d;

constexpr std::tuple methods{Method{"euler", measure::euler},
                             Method{"symplectic_euler", measure::symplectic_euler},
                             Method{"velocity_verlet", measure::velocity_verlet},
                             Method{"yoshida4", measure::yoshida4}, Method{"rk4", measure::rk4}};

class Turning final : public Figure {
  static constexpr double picture = 40;  // [m] from the planet, and none of it is seen

  double method_ = 1, rate_ = 1 / tick;
  std::unique_ptr<Run<Vec>> run_;
  std::vector<double> x_, y_, last_x_, last_y_;                   // this turn and the last
  double least_ = 0, most_ = 0, last_least_ = 0, last_most_ = 0;  // of the energy in them
  Vec farthest_;                                                  // of the last turn
  double turns_ = 0;

  std::vector<Setting> settings() override {
    return {{"method", &method_, names(methods)}, {"rate", &rate_}};
  }

  void start() override {
    run_ = start_run(methods, method_, shuttle, shuttle.start(), 1 / rate_);
    farthest_.setConstant(std::numeric_limits<double>::quiet_NaN());
    turns_ = 0;
    last_x_.clear();
    last_y_.clear();
    begin_turn();
    show_truth();
    show_state();
  }

  // A turn goes from farthest point to farthest point; the first has only half.
  void step() override {
    const bool rising = outwards();
    run_->step();
    note();
    if (!rising || outwards()) return;
    farthest_ = run_->now.x;
    ++turns_;
    last_x_.swap(x_);
    last_y_.swap(y_);
    last_least_ = least_;
    last_most_ = most_;
    begin_turn();
  }

  bool outwards() const { return run_->now.x.dot(run_->now.v) > 0; }

  void begin_turn() {
    x_.clear();
    y_.clear();
    least_ = most_ = energy();
  }

  // The path of what flies away ends where it has left the picture.
  void note() {
    least_ = std::min(least_, energy());
    most_ = std::max(most_, energy());
    if (!(run_->now.x.norm() < picture)) return;
    x_.push_back(run_->now.x.x());
    y_.push_back(run_->now.x.y());
  }

  // What is done of this turn, after what is left of the last.
  static std::vector<double> one_turn(const std::vector<double>& last,
                                      const std::vector<double>& now) {
    std::vector<double> path(last.begin() + std::ptrdiff_t(std::min(last.size(), now.size())),
                             last.end());
    path.insert(path.end(), now.begin(), now.end());
    return path;
  }

  // At the start it is -1; from zero on, nothing holds the shuttle.
  double energy() const {
    const auto begin = shuttle.start();
    return -shuttle.energy(run_->now.x, run_->now.v) / shuttle.energy(begin.x, begin.v);
  }

  void show_state() override {
    const bool first = turns_ < 2;
    show("t", run_->t());
    show("h", run_->h);
    show("x", run_->now.x.x());
    show("y", run_->now.x.y());
    show("turns", turns_);
    show("farthest x", farthest_.x());
    show("farthest y", farthest_.y());
    show("turn x", one_turn(last_x_, x_));
    show("turn y", one_turn(last_y_, y_));
    show("least energy", first ? least_ : last_least_);
    show("most energy", first ? most_ : last_most_);
    show("true energy", -1);
  }

  void show_truth() {
    std::vector<double> x, y;
    for (int i = 0; i <= 200; ++i) {
      const Vec place = shuttle.exact(shuttle_turn * i / 200).x;
      x.push_back(place.x());
      y.push_back(place.y());
    }
    show_reference("true x", x);
    show_reference("true y", y);
  }
};

}  // namespace

std::unique_ptr<Figure> make_turning() {
  return std::make_unique<Turning>();
}

}  // namespace live
