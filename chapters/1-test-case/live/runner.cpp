// SPDX-License-Identifier: MIT-0
// The runner of chapter 1, drawn three ways in each frame of a screen.
#include "1-test-case/runner.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "live/figure.h"
#include "shelf/fixed_step.h"

namespace live {
namespace {

// A step of the figure is a frame; the steps of the runner lie within.
class RunnerDrawn final : public Figure {
  static constexpr double usual_frame = 1.0 / 144;  // of the screen, until the page says [s]
  static constexpr double remembered = 2;           // of the frames that are counted [s]

  /// What one frame showed.
  struct Frame {
    double t;       // [s]
    bool still;     // whether the newest state is the one of the frame before
    double behind;  // how far the blended picture is from where he is [m]
    double beyond;  // how far the extrapolated one is within a wall [m]
  };

  double rate_ = 20, speed_ = 3, frame_ = usual_frame, t_ = 0;
  shelf::FixedStep<> clock_;
  Runner before_, now_;
  std::vector<Frame> frames_;

  std::vector<Setting> settings() override {
    return {{"rate", &rate_}, {"speed", &speed_}, {"frame", &frame_}};
  }

  void start() override {
    t_ = 0;
    frame_ = usual_frame;
    clock_ = {.h = 1 / rate_};
    // With the settings that the page opens with, it ends while he is drawn in the wall.
    now_ = before_ = {.x = 1.37, .v = -speed_};
    frames_.clear();
    show_state();
  }

  void step() override {
    clock_.h = 1 / rate_;
    now_.v = now_.v < 0 ? -speed_ : speed_;
    const double last = now_.x;
    clock_.frame(frame_, [&](double) {
      before_ = now_;
      now_.step(clock_.h);
    });
    t_ += frame_;
    frames_.push_back({t_, now_.x == last, off(blended()), within_wall()});
    const auto old = [&](const Frame& frame) { return frame.t < t_ - remembered; };
    frames_.erase(frames_.begin(), std::find_if_not(frames_.begin(), frames_.end(), old));
  }

  double blended() const { return before_.x + clock_.blend() * (now_.x - before_.x); }
  double extrapolated() const { return now_.x + clock_.saved * now_.v; }
  double within_wall() const { return std::max({0.0, -extrapolated(), extrapolated() - room}); }

  // How far a place is from where he is at this moment, since steps of any length are exact [m].
  double off(double x) const {
    Runner runner = now_;
    runner.step(clock_.saved);
    return std::abs(x - runner.x);
  }

  double most(double Frame::* what) const {
    double largest = 0;
    for (const Frame& frame : frames_) largest = std::max(largest, frame.*what);
    return largest;
  }

  void show_state() override {
    show("t", t_);
    show("h", frame_);
    show("newest", now_.x);
    show("blended", blended());
    show("extrapolated", extrapolated());
    show("wall", room);
    const double way = clock_.h * speed_;  // of a step [m]
    show("newest off", off(now_.x) / way);
    show("blended off", off(blended()) / way);
    show("extrapolated off", off(extrapolated()) / way);
    show("frames", double(frames_.size()));
    show("still", double(std::count_if(frames_.begin(), frames_.end(),
                                       [](const Frame& frame) { return frame.still; })));
    show("behind", most(&Frame::behind));
    show("beyond", most(&Frame::beyond));
  }
};

}  // namespace

std::unique_ptr<Figure> make_runner() {
  return std::make_unique<RunnerDrawn>();
}

}  // namespace live
