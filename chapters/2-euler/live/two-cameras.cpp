// SPDX-License-Identifier: MIT-0
// Cameras of chapter 2 on three machines: a tenth of the way in every frame, and exact.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "2-euler/machines.h"
#include "live/figure.h"

namespace live {
namespace {

using Vec = Eigen::Vector2d;

// The target is where the reader's hand is. Two seconds after the hand was last moved it begins to
// jump to and fro by itself.
class TwoCameras final : public Figure {
  static constexpr double steps_per_second = 120, middle = 60;  // [Hz]
  static constexpr double far = 5, between_jumps = 2;           // [m], [s]

  double slow_ = 30, fast_ = 144, late_ = 0, hand_x_ = far, hand_y_ = 0;
  long steps_ = 0;
  double first_jump_ = 0;  // [s]
  Vec hand_;
  std::array<Machine<Vec>, 3> machines_;

  std::vector<Setting> settings() override {
    return {{"slow", &slow_},
            {"fast", &fast_},
            {"late", &late_},
            {"hand x", &hand_x_},
            {"hand y", &hand_y_}};
  }

  void start() override {
    steps_ = 0;
    take_hand();
    first_jump_ = between_jumps;
    for (Machine<Vec>& machine : machines_) machine = {0, other_place(), other_place(), hand_};
    set_machines();
    show_state();
  }

  double t() const { return double(steps_) / steps_per_second; }
  void take_hand() { hand_ = {hand_x_, hand_y_}; }
  Vec other_place() const { return {hand_.x() > 0 ? -far : far, hand_.y()}; }

  Vec target(double time) const {
    const double jumps = std::floor((time - first_jump_) / between_jumps) + 1;
    return jumps > 0 && std::fmod(jumps, 2) == 1 ? other_place() : hand_;
  }

  // One whose rate has changed goes on with the next of its refreshes.
  void set_machines() {
    const double rates[] = {slow_, middle, fast_};
    for (std::size_t i = 0; i < machines_.size(); ++i) {
      Machine<Vec>& machine = machines_[i];
      if (machine.rate == rates[i]) continue;
      machine.rate = rates[i];
      machine.shown = long(std::floor(t() * rates[i]));
      machine.next = machine.shown + 1;
    }
    machines_[1].late = std::max(1L, std::lround(late_ * middle));
  }

  void step() override {
    if (hand_ != Vec(hand_x_, hand_y_)) {
      take_hand();
      first_jump_ = between_jumps * std::ceil(t() / between_jumps + 1);
    }
    set_machines();
    ++steps_;
    for (Machine<Vec>& machine : machines_) {
      const double refreshes = double(steps_) * machine.rate / steps_per_second;
      machine.draw_until(refreshes, [this](double time) { return target(time); });
    }
  }

  void show_state() override {
    show("t", t());
    show("h", 1 / steps_per_second);
    const Vec aim = target(t());
    show("target x", aim.x());
    show("target y", aim.y());
    std::vector<double> places[4];
    for (const Machine<Vec>& machine : machines_) {
      places[0].push_back(machine.lerp.x());
      places[1].push_back(machine.lerp.y());
      places[2].push_back(machine.exact.x());
      places[3].push_back(machine.exact.y());
    }
    show("lerp x", places[0]);
    show("lerp y", places[1]);
    show_reference("exact x", places[2]);
    show_reference("exact y", places[3]);
    show("slow lerp", (machines_[0].lerp - aim).norm());
    show("middle lerp", (machines_[1].lerp - aim).norm());
    show("fast lerp", (machines_[2].lerp - aim).norm());
    show_reference("slow exact", (machines_[0].exact - aim).norm());
    show_reference("middle exact", (machines_[1].exact - aim).norm());
    show_reference("fast exact", (machines_[2].exact - aim).norm());
  }
};

}  // namespace

std::unique_ptr<Figure> make_two_cameras() {
  return std::make_unique<TwoCameras>();
}

}  // namespace live
