// SPDX-License-Identifier: MIT-0
// RK4 of chapter 3 with the faults that the reader makes, beside the right one, on three scenes.
#include <algorithm>
#include <cmath>
#include <iterator>
#include <type_traits>
#include <vector>

#include "3-runge-kutta/toys.h"
#include "3-runge-kutta/wrong.h"
#include "live/figure.h"
#include "measure/order.h"

namespace live {
namespace {

using Vec = Eigen::Vector2d;
using State = scenes::State<Vec>;

/// A scene in the plane, whichever it is, so that the page has the code of all that is measured
/// only once. What moves on a line moves upwards.
class Scene {
 public:
  virtual ~Scene() = default;
  virtual Vec operator()(const Vec& x, const Vec& v, double t) const = 0;
  virtual State start() const = 0;
  virtual State exact(double t) const = 0;
  virtual bool on_a_line() const = 0;
};

template <class Of>
class SceneOf final : public Scene {
  static constexpr bool line = std::is_same_v<typename Of::Vec, double>;
  const Of& of_;

 public:
  explicit SceneOf(const Of& of) : of_(of) {}

  Vec operator()(const Vec& x, const Vec& v, double t) const override {
    if constexpr (line) {
      return {0, of_(x.y(), v.y(), t)};
    } else {
      return of_(x, v, t);
    }
  }
  State start() const override { return in_plane(of_.start()); }
  State exact(double t) const override { return in_plane(of_.exact(t)); }
  bool on_a_line() const override { return line; }

 private:
  static State in_plane(const scenes::State<typename Of::Vec>& s) {
    if constexpr (line) {
      return {{0, s.x}, {0, s.v}};
    } else {
      return s;
    }
  }
};

/// A scene, how long it is watched, and the rate whose errors show the order, beside those of half
/// of it: as in the chapter's table.
struct Trial {
  const Scene& scene;
  double seconds, rate_of_order;  // [s], [1/s]
};

/// A method, and the names of what is shown of it.
struct Side {
  wrong::Stages stages;
  const char *x, *y, *errors, *order, *off;
};

class StageBug final : public Figure {
  double third_ = 1, fourth_ = 1, moving_ = 0, clock_ = 0, weights_ = 0, scene_ = 0, rate_ = 60;
  long done_ = 0, steps_ = 0;

  std::vector<Setting> settings() override {
    return {{"third", &third_, {"first", "second"}},
            {"fourth", &fourth_, {"first", "second", "third"}},
            {"moving", &moving_, {"new", "old"}},
            {"clock", &clock_, {"runs", "stands"}},
            {"weights", &weights_, {"right", "equal"}},
            {"scene", &scene_, {"drone", "parachute", "rocket"}},
            {"rate", &rate_}};
  }

  wrong::Stages stages_of_reader() const {
    const auto copy = [](const auto& from, auto& to) {
      std::copy(std::begin(from), std::end(from), to);
    };
    wrong::Stages made;
    made.position_from[2] = made.velocity_from[2] = int(third_);
    made.position_from[3] = made.velocity_from[3] = int(fourth_);
    if (moving_ == 1) copy(wrong::stale_velocities.stages.position_from, made.position_from);
    if (clock_ == 1) copy(wrong::stopped_clock.stages.clock, made.clock);
    if (weights_ == 1) copy(wrong::equal_weights.stages.weight, made.weight);
    return made;
  }

  void start() override {
    static const SceneOf on_drone(drone);
    static const SceneOf on_parachute(parachute);
    static const SceneOf on_rocket(engine_on);
    static const Trial trials[] = {{on_drone, 8, 32}, {on_parachute, 2, 256}, {on_rocket, 4, 32}};
    const Trial& trial = trials[static_cast<std::size_t>(scene_)];
    done_ = 0;
    steps_ = std::lround(trial.seconds * rate_);
    show("seconds", trial.seconds);
    show_truth("true x", "true y", trial, steps_);
    show_truth("way x", "way y", trial, 120);
    show_side(trial, {{}, "right x", "right y", "right errors", "right order", "right off"});
    show_side(trial,
              {stages_of_reader(), "your x", "your y", "your errors", "your order", "your off"});
    show_state();
  }

  void show_side(const Trial& trial, const Side& side) {
    const auto method = wrong::method_of(side.stages);
    std::vector<double> errors;
    for (const auto& row : measure::halvings(method, trial.scene, 1.0, trial.seconds, 9)) {
      errors.push_back(row.error.position);
      if (row.h * trial.rate_of_order == 1) show_reference(side.order, row.position_order);
    }
    show_reference(side.errors, errors);
    show_reference(side.off,
                   measure::largest_error(method, trial.scene, 1 / rate_, steps_).position);
    std::vector<double> xs, ys;
    auto s = trial.scene.start();
    measure::run(method, trial.scene, s, 1 / rate_, steps_, [&](double t, const State& now) {
      xs.push_back(trial.scene.on_a_line() ? t : now.x.x());
      ys.push_back(now.x.y());
    });
    show(side.x, xs);
    show(side.y, ys);
  }

  void show_truth(const char* x, const char* y, const Trial& trial, long parts) {
    std::vector<double> xs, ys;
    for (long n = 0; n <= parts; ++n) {
      const double t = trial.seconds * double(n) / double(parts);
      const Vec place = trial.scene.exact(t).x;
      xs.push_back(trial.scene.on_a_line() ? t : place.x());
      ys.push_back(place.y());
    }
    show_reference(x, xs);
    show_reference(y, ys);
  }

  void step() override { done_ = std::min(done_ + 1, steps_); }

  void show_state() override {
    show("t", double(done_) / rate_);
    show("h", 1 / rate_);
    show("step", double(done_));
  }
};

}  // namespace

std::unique_ptr<Figure> make_stage_bug() {
  return std::make_unique<StageBug>();
}

}  // namespace live
