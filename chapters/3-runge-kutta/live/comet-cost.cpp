// SPDX-License-Identifier: MIT-0
// The comet of chapter 3 in frames: each step that was taken, each try that was not, and what every
// frame cost.
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numeric>
#include <vector>

#include "3-runge-kutta/comet.h"
#include "live/figure.h"

namespace live {
namespace {

using Vec = Eigen::Vector2d;

/// The comet, and a note of where and when somebody asks for its acceleration.
struct NotedComet : CountedComet {
  struct Look {
    Vec x;
    double t;
  };
  std::vector<Look>* looks;

  explicit NotedComet(std::vector<Look>& all) : CountedComet(comet), looks(&all) {}

  Vec operator()(const Vec& x, const Vec& v, double t) const {
    looks->push_back({x, t});
    return CountedComet::operator()(x, v, t);
  }
};

/// Places, and how many of them each frame had come to.
struct Dots {
  std::vector<double> x, y, until;

  void add(const Vec& place) {
    x.push_back(place.x());
    y.push_back(place.y());
  }
  void end_frame() { until.push_back(double(x.size())); }
};

class CometCost final : public Figure {
  static constexpr double cut = 0, ahead = 1, equal = 2;  // as the choices below
  double method_ = cut, tolerance_ = micrometre, rate_ = 60;
  CometState start_;
  Passage passage_;
  Dots steps_, missed_;
  std::size_t frame_ = 0;  // frames gone by

  std::vector<Setting> settings() override {
    return {{"method", &method_, {"cut", "ahead", "equal"}},
            {"tolerance", &tolerance_},
            {"rate", &rate_}};
  }

  void start() override {
    frame_ = 0;
    start_ = comet.exact(-comet_year / 2);
    std::vector<NotedComet::Look> looks;
    const NotedComet noted(looks);
    const long frames = std::lround(comet_year * rate_);
    passage_ = method_ == cut     ? pass(frames, start_, tolerance_, noted)
               : method_ == ahead ? read(frames, tolerance_, noted)
                                  : step_equally(frames, noted);
    find_steps(looks);
    show_reference("step x", steps_.x);
    show_reference("step y", steps_.y);
    show_reference("missed x", missed_.x);
    show_reference("missed y", missed_.y);
    const std::vector<double> costs(passage_.evaluations.begin(), passage_.evaluations.end());
    show_reference("costs", costs);
    show_state();
  }

  // A try of Dormand-Prince asks six times, the last time at its end; if the next one begins before
  // that, it was rejected. A step of RK4 asks four times, the first time at its start.
  void find_steps(const std::vector<NotedComet::Look>& looks) {
    steps_ = missed_ = {};
    std::size_t at = 0, until = 0;
    for (std::size_t n = 0; n < passage_.evaluations.size(); ++n) {
      until += static_cast<std::size_t>(passage_.evaluations[n]);
      if (method_ == cut || (method_ == ahead && n == 0)) ++at;  // the slope at the start
      for (; method_ == equal && at < until; at += 4) steps_.add(looks[at].x);
      for (; at < until; at += 6) {
        const auto& end = looks[at + 5];
        const bool rejected = at + 6 < until && looks[at + 6].t < end.t;
        (rejected ? missed_ : steps_).add(end.x);
      }
      steps_.end_frame();
      missed_.end_frame();
    }
  }

  void step() override { frame_ = std::min(frame_ + 1, passage_.frames.size()); }

  void show_state() override {
    const bool begun = frame_ > 0;
    const std::size_t last = begun ? frame_ - 1 : 0;
    const CometState& s = begun ? passage_.frames[last] : start_;
    const double t = double(frame_) / rate_;
    const auto& costs = passage_.evaluations;
    const auto gone = costs.begin() + std::ptrdiff_t(frame_);
    const double cost = begun ? double(costs[last]) : 0;
    const double none = std::numeric_limits<double>::quiet_NaN();
    const long sum = std::accumulate(costs.begin(), gone, 0L);
    show("t", t);
    show("h", 1 / rate_);
    show_reference("x", s.x.x());
    show_reference("y", s.x.y());
    // In equal steps it is where the last of them, of four evaluations, has brought it.
    const double reached = method_ == equal ? millisecond * double(sum) / 4 : t;
    show_reference("error", (s.x - comet.exact(reached - comet_year / 2).x).norm());
    show_reference("steps", begun ? steps_.until[last] : 0);
    show_reference("missed", begun ? missed_.until[last] : 0);
    show_reference("cost", cost);
    show_reference("dearest", begun ? double(*std::max_element(costs.begin(), gone)) : 0);
    show_reference("sum", double(sum));
    show_reference("adaptive cost", method_ == equal ? none : cost);
    show_reference("equal cost", method_ == equal ? cost : none);
  }
};

}  // namespace

std::unique_ptr<Figure> make_comet_cost() {
  return std::make_unique<CometCost>();
}

}  // namespace live
