// SPDX-License-Identifier: MIT-0
// Four machines of chapter 1 that play one jump, each in frames of its own, under a ledge.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "1-test-case/jump.h"
#include "integrate/euler.h"
#include "live/figure.h"
#include "shelf/fixed_step.h"

namespace live {
namespace {

// Frames begin and end at whole ticks, so that frames of two machines meet to the bit.
constexpr int second = 3600;             // [ticks]
constexpr int late_frame = second / 10;  // how long a late frame takes [ticks]

struct Machine {
  int usual;     // how long a frame takes that is not late [ticks]
  bool follows;  // whether each frame is one step
  double high;   // where the ledge is [m]
  int late_at;   // when a frame is late [ticks]; negative for never

  int shown = 0;                      // when it had its picture [ticks]
  double highest = 0;                 // that its jumper was drawn [m]
  double spent = 0, step_length = 0;  // steps of the last frame, and how long one is [s]
  bool stands = false;                // on the ledge
  scenes::State<Eigen::Vector2d> before = jump.start(), now = before;
  shelf::FixedStep<> clock{};

  // When it has its next picture [ticks].
  int next() const {
    const bool late = shown <= late_at && late_at < shown + usual;
    return shown + (late ? std::max(usual, late_frame) : usual);
  }

  void frame() {
    const double length = double(next() - shown) / second;
    const long long steps_before = clock.steps;
    if (follows) {
      step(double(shown) / second, length);
    } else {
      clock.frame(length, [&](double t) { step(t, clock.h); });
    }
    spent = follows ? 1 : double(clock.steps - steps_before);
    step_length = follows ? length : clock.h;
    shown = next();
    highest = std::max(highest, drawn());
  }

  // Whoever was above the ledge lands on it.
  void step(double t, double h) {
    const double floor = now.x.y() < high ? 0 : high;
    before = now;
    integrate::euler(now.x, now.v, t, h, jump);
    if (!(now.x.y() < floor)) return;
    now = {{0, floor}, {0, 0}};
    stands = floor > 0;
  }

  double drawn() const {
    return follows ? now.x.y() : before.x.y() + clock.blend() * (now.x.y() - before.x.y());
  }
};

// A step goes to the next frame of any machine.
class FourMachines final : public Figure {
  static constexpr std::size_t count = 4;
  static constexpr int everybody = 5;  // of the choices of `late`

  double method_ = 0, late_ = 0, at_ = 0.2, ledge_ = ledge;
  std::array<double, count> rates_{20, 30, 60, 144};
  std::vector<Machine> machines_;
  int ticks_ = 0;

  std::vector<Setting> settings() override {
    return {{"method", &method_, {"follow", "fixed"}},
            {"late", &late_, {"none", "a", "b", "c", "d", "all"}},
            {"at", &at_},
            {"a", &rates_[0]},
            {"b", &rates_[1]},
            {"c", &rates_[2]},
            {"d", &rates_[3]},
            {"ledge", &ledge_}};
  }

  void start() override {
    ticks_ = 0;
    machines_.clear();
    for (std::size_t i = 0; i < count; ++i) {
      const bool late = late_ == everybody || late_ == double(i + 1);
      machines_.push_back({.usual = int(second / rates_[i]),
                           .follows = method_ == 0,
                           .high = ledge_,
                           .late_at = late ? int(std::lround(at_ * second)) : -1});
    }
    show_state();
  }

  int next() const {
    int first = machines_[0].next();
    for (const Machine& machine : machines_) first = std::min(first, machine.next());
    return first;
  }

  void step() override {
    ticks_ = next();
    for (Machine& machine : machines_)
      if (machine.next() == ticks_) machine.frame();
  }

  void show_state() override {
    show("t", double(ticks_) / second);
    show("h", double(next() - ticks_) / second);
    show("ledge", ledge_);
    show_all("y", [](const Machine& machine) { return machine.drawn(); });
    show_all("highest", [](const Machine& machine) { return machine.highest; });
    show_all("shown", [](const Machine& machine) { return double(machine.shown) / second; });
    show_all("saved", [](const Machine& machine) { return machine.clock.saved; });
    show_all("spent", [](const Machine& machine) { return machine.spent; });
    show_all("step length", [](const Machine& machine) { return machine.step_length; });
    show_all("stands", [](const Machine& machine) { return double(machine.stands); });
    const char* names[] = {"a highest", "b highest", "c highest", "d highest"};
    for (std::size_t i = 0; i < count; ++i) show(names[i], machines_[i].highest);
  }

  template <class Value>
  void show_all(const char* name, Value value) {
    std::array<double, count> values;
    for (std::size_t i = 0; i < count; ++i) values[i] = value(machines_[i]);
    show(name, values);
  }
};

}  // namespace

std::unique_ptr<Figure> make_four_machines() {
  return std::make_unique<FourMachines>();
}

}  // namespace live
