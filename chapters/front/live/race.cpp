// SPDX-License-Identifier: MIT-0
// The race of the front page: eight methods on one orbit, at one price, however the shuttle is
// thrown.
#include "front/race.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "live/figure.h"
#include "live/implicit.h"
#include "live/run.h"
#include "measure/methods/euler.h"
#include "measure/methods/runge_kutta.h"
#include "measure/methods/verlet.h"

namespace live {
namespace {

using Vec = Eigen::Vector2d;
using Orbit = scenes::Orbit<>;

constexpr std::tuple methods{Method{"euler", measure::euler},
                             Method{"midpoint", measure::midpoint},
                             Method{"heun", measure::heun},
                             Method{"rk4", measure::rk4},
                             Method{"backward_euler", backward_euler},
                             Method{"predicted_euler", measure::predicted_euler<1>},
                             Method{"velocity_verlet", measure::velocity_verlet},
                             Method{"symplectic_euler", measure::symplectic_euler}};

/// The true flight of a shuttle that is thrown upwards from the right of its planet, more slowly
/// than one that never comes back.
class Thrown {
  Orbit orbit_ = race_shuttle;
  double begin_;  // time from the pericentre to the start [s]
  double turn_;   // direction of the pericentre [rad]

 public:
  explicit Thrown(const scenes::State<Vec>& start) {
    const double r = start.x.norm();
    orbit_.semi_major = -orbit_.mu / (2 * orbit_.energy(start.x, start.v));
    // The start's eccentric anomaly E, by e sin E and e cos E.
    const double sine = start.x.dot(start.v) / std::sqrt(orbit_.mu * orbit_.semi_major);
    const double cosine = 1 - r / orbit_.semi_major;
    const double anomaly = std::atan2(sine, cosine);
    orbit_.eccentricity = std::hypot(sine, cosine);
    begin_ = (anomaly - sine) * orbit_.period() / (2 * std::numbers::pi);
    const Vec at = orbit_.exact(begin_).x;
    turn_ = std::atan2(start.x.y(), start.x.x()) - std::atan2(at.y(), at.x());
  }

  Vec at(double t) const { return Eigen::Rotation2Dd(turn_) * orbit_.exact(begin_ + t).x; }
  double period() const { return orbit_.period(); }
  /// A place on its ellipse, by the eccentric anomaly, so that equal parts of it are equally round.
  Vec on_its_ellipse(double anomaly) const {
    const double mean = anomaly - orbit_.eccentricity * std::sin(anomaly);
    return Eigen::Rotation2Dd(turn_) * orbit_.exact(mean * period() / (2 * std::numbers::pi)).x;
  }
};

/// One of the eight, between its last two steps.
struct Racer {
  std::string x, y, length, error;  // what is shown of it
  std::unique_ptr<Run<Vec>> run{};
  Vec before{};
  double worst = 0;  // distance from the true shuttle so far [m]
  bool crashed = false;

  void start(std::unique_ptr<Run<Vec>> begun) {
    run = std::move(begun);
    worst = 0;
    crashed = false;
  }
  void fly(double until, const Thrown& truth) {
    while (!crashed && run->t() < until) {
      before = run->now.x;
      run->step();
      crashed = !(run->now.x.norm() > planet);
      worst = crashed ? INFINITY : std::max(worst, (run->now.x - truth.at(run->t())).norm());
    }
  }
  /// On the straight line between the steps, so that long steps fly as smoothly as short ones.
  Vec place(double t) const {
    if (crashed || run->steps == 0) return run->now.x;
    return run->now.x + (t - run->t()) / run->h * (run->now.x - before);
  }
};

// Time passes by one evaluation after the other.
class Race final : public Figure {
  double price_ = ::price, throw_x_ = 0, throw_y_ = race_shuttle.start().v.y();
  double energy_ = 0;  // per unit mass [J/kg]
  long evaluations_ = 0;
  Thrown truth_{race_shuttle.start()};
  std::vector<Racer> racers_;

 public:
  Race() {
    for (const std::string name : names(methods))
      racers_.push_back({name + " x", name + " y", name + " length", name + " error"});
  }

 private:
  std::vector<Setting> settings() override {
    return {{"price", &price_}, {"throw x", &throw_x_}, {"throw y", &throw_y_}};
  }

  void start() override {
    auto begin = race_shuttle.start();
    begin.v = {throw_x_, throw_y_};
    truth_ = Thrown(begin);
    energy_ = race_shuttle.energy(begin.x, begin.v);
    evaluations_ = 0;
    const auto steps = std::apply(
        [this](const auto&... method) { return std::array{affordable(method.step, price_)...}; },
        methods);
    for (std::size_t i = 0; i < racers_.size(); ++i) {
      racers_[i].start(start_run(methods, double(i), race_shuttle, begin, steps[i]));
    }
    show_path();
    show_state();
  }

  void step() override {
    ++evaluations_;
    for (Racer& racer : racers_) racer.fly(t(), truth_);
  }

  double t() const { return double(evaluations_) / price_; }

  // Of the orbit on which a shuttle is, by its energy, as a part of what it should be.
  double length(const scenes::State<Vec>& now) const {
    const double energy = race_shuttle.energy(now.x, now.v);
    return energy < 0 ? energy_ / energy : INFINITY;
  }

  void show_state() override {
    show("t", t());
    show("h", 1 / price_);
    const Vec truth = truth_.at(t());
    show_reference("true x", truth.x());
    show_reference("true y", truth.y());
    std::vector<double> crashed;
    for (const Racer& racer : racers_) {
      const Vec x = racer.place(t());
      show(racer.x.c_str(), x.x());
      show(racer.y.c_str(), x.y());
      show(racer.length.c_str(), racer.crashed ? NAN : length(racer.run->now));
      show_reference(racer.error.c_str(), racer.worst);
      crashed.push_back(racer.crashed);
    }
    show("crashed", crashed);
    show("true length", 1);
  }

  void show_path() {
    std::vector<double> xs, ys;
    for (int i = 0; i <= 120; ++i) {
      const Vec x = truth_.on_its_ellipse(2 * std::numbers::pi * i / 120);
      xs.push_back(x.x());
      ys.push_back(x.y());
    }
    show_reference("path x", xs);
    show_reference("path y", ys);
    show_reference("turn", truth_.period());
  }
};

}  // namespace

std::unique_ptr<Figure> make_race() {
  return std::make_unique<Race>();
}

}  // namespace live
