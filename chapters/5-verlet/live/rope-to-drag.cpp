// SPDX-License-Identifier: MIT-0
// A rope in the reader's hand, in chapter 5: steps of position Verlet, and after each its links are
// put right, in even frames or in recorded ones.
#include "5-verlet/rope_in_frames.h"
#include "cast.h"
#include "live/figure.h"

namespace live {
namespace {

constexpr int links = 20;

class RopeToDrag final : public Figure {
  double method_ = 0, iterations_ = 8, substeps_ = 1, hand_x_ = 0, hand_y_ = 0;
  double t_ = 0, h_ = frame, h_previous_ = frame;  // [s]
  frames::Playback recording_;
  Rope rope_;

  std::vector<Setting> settings() override {
    return {{"method", &method_, {"even", "recorded", "distance_corrected", "uneven"}},
            {"iterations", &iterations_},
            {"substeps", &substeps_},
            {"hand x", &hand_x_},
            {"hand y", &hand_y_}};
  }

  void start() override {
    t_ = 0;
    recording_ = {};
    h_ = next_frame();
    h_previous_ = h_ / substeps_;
    rope_ = two_metres(links, {1, 0});
    for (Vec& point : rope_.x) point += hand();
    rope_.x_previous = rope_.x;
    show_state();
  }

  Vec hand() const { return {hand_x_, hand_y_}; }
  double next_frame() { return method_ == 0 ? frame : recording_.next(); }

  void step() override {
    rope_.x[0] = hand();
    for (int n = 0; n < int(substeps_); ++n) substep(h_ / substeps_);
    t_ += h_;
    h_ = next_frame();
  }

  void substep(double h) {
    if (method_ == 2)
      frame_of_rope(rope_, distance_corrected, h, h_previous_, int(iterations_));
    else if (method_ == 3)
      frame_of_rope(rope_, corrected, h, h_previous_, int(iterations_));
    else
      frame_of_rope(rope_, plain, h, h_previous_, int(iterations_));
    h_previous_ = h;
  }

  void show_state() override {
    std::vector<double> x, y;
    for (const Vec& point : rope_.x) {
      x.push_back(point.x());
      y.push_back(point.y());
    }
    show("t", t_);
    show("h", h_);
    show("x", x);
    show("y", y);
    show("stretch", 100 * ::stretch(rope_));
    show("rule", 100 * rule_of_thumb() / 2);
  }

  // How far a rope that hangs in even frames is stretched [m].
  double rule_of_thumb() const {
    const double h = frame / substeps_;
    return links * links * -gravity({}, {}, t_).y() * h * h / (2 * iterations_);
  }
};

}  // namespace

std::unique_ptr<Figure> make_rope_to_drag() {
  return std::make_unique<RopeToDrag>();
}

}  // namespace live
