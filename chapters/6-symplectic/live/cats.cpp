// SPDX-License-Identifier: MIT-0
// The cat of chapter 6, carried through phase space, and how large it is.
#include "6-symplectic/cat.h"
#include "live/figure.h"
#include "live/implicit.h"
#include "live/run.h"
#include "measure/methods/euler.h"
#include "measure/methods/runge_kutta.h"
#include "measure/methods/verlet.h"

namespace live {
namespace {

constexpr std::tuple methods{Method{"euler", measure::euler},
                             Method{"symplectic_euler", measure::symplectic_euler},
                             Method{"velocity_verlet", measure::velocity_verlet},
                             Method{"rk4", measure::rk4}, Method{"backward_euler", backward_euler}};

class Cats final : public Figure {
  static constexpr int parts = 20;               // of each edge, so that 100 % is right to 0.05 %
  static constexpr double between = 1.5;         // cats that are left behind [s]
  static constexpr std::size_t left_behind = 6;  // at most

  double method_ = 1, h_ = cat_step;
  double aside_ = 0, faster_ = 0;  // where it is put, from where the chapter has it [rad, rad/s]
  double begin_ = 0;               // the area at the start [rad^2/s]
  std::vector<std::unique_ptr<Run<double>>> points_;
  std::vector<double> x_, v_, behind_x_, behind_v_;

  std::vector<Setting> settings() override {
    return {
        {"method", &method_, names(methods)}, {"h", &h_}, {"aside", &aside_}, {"faster", &faster_}};
  }

  void start() override {
    points_.clear();
    behind_x_.clear();
    behind_v_.clear();
    for (const auto& [x, v] : cat(parts)) {
      const scenes::State<double> point{x + aside_, v + faster_};
      points_.push_back(start_run(methods, method_, wrecking_ball, point, h_));
    }
    begin_ = area(outline());
    leave_behind();
    show_state();
  }

  void step() override {
    for (const auto& point : points_) point->step();
    const auto due = double(behind_x_.size() / points_.size());
    if (due < left_behind && points_.front()->t() > due * between - h_ / 2) leave_behind();
  }

  Outline outline() const {
    Outline found;
    for (const auto& point : points_) found.push_back(point->now);
    return found;
  }

  void leave_behind() {
    for (const auto& [x, v] : outline()) {
      behind_x_.push_back(x);
      behind_v_.push_back(v);
    }
  }

  void show_state() override {
    const Outline now = outline();
    x_.clear();
    v_.clear();
    for (const auto& [x, v] : now) {
      x_.push_back(x);
      v_.push_back(v);
    }
    show("t", points_.front()->t());
    show("h", h_);
    show("x", x_);
    show("v", v_);
    show_reference("behind x", behind_x_);  // hashed when they were the cat
    show_reference("behind v", behind_v_);
    show("area", 100 * area(now) / begin_);
    show("true area", 100);
  }
};

}  // namespace

std::unique_ptr<Figure> make_cats() {
  return std::make_unique<Cats>();
}

}  // namespace live
