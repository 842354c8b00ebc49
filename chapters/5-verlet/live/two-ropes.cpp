// SPDX-License-Identifier: MIT-0
// Two ropes in one hand, in chapter 5: the pulls of a frame in one step, and in as many substeps.
#include <algorithm>

#include "5-verlet/two_ropes.h"
#include "live/figure.h"

namespace live {
namespace {

class TwoRopes final : public Figure {
  static constexpr double fastest = 0.1;  // of the hand [m a frame]

  double pulls_ = 8, weight_ = 10, hand_x_ = -0.6, hand_y_ = 0.1, held_ = 0, cut_ = 0;
  long frames_ = 0;
  RopeWithWeight iterated_ = level_rope(weight_), stepped_ = iterated_;

  std::vector<Setting> settings() override {
    return {{"pulls", &pulls_},   {"weight", &weight_}, {"hand x", &hand_x_},
            {"hand y", &hand_y_}, {"held", &held_},     {"cut", &cut_}};
  }

  void start() override {
    frames_ = 0;
    lay();
    show_state();
  }

  // Level, with the point that is held in the hand.
  void lay() {
    const Vec level(1, 0);
    iterated_ = RopeWithWeight(hand() - held_ * RopeWithWeight::length * level, level, weight_);
    iterated_.hold(std::size_t(held_), weight_);
    iterated_.whole = whole();
    stepped_ = iterated_;
  }

  std::size_t whole() const { return cut_ > 0 ? std::size_t(cut_) : RopeWithWeight::links + 1; }

  Vec hand() const { return {hand_x_, hand_y_}; }

  void step() override {
    ++frames_;
    const bool is_cut = iterated_.whole <= RopeWithWeight::links;
    if (is_cut && iterated_.whole != whole()) lay();  // what has fallen is not tied on again
    advance(iterated_, 1, int(pulls_));
    advance(stepped_, int(pulls_), 1);
  }

  void advance(RopeWithWeight& rope, int substeps, int iterations) const {
    rope.hold(std::size_t(held_), weight_);
    rope.whole = whole();
    const Vec from = rope.x[rope.held], way = hand() - from;
    const Vec to = from + std::min(1.0, fastest / way.norm()) * way;
    rope.frame_of(to, substeps, iterations);
  }

  void show_state() override {
    show("t", double(frames_) * frame);
    show("h", frame);
    show("peg", std::array{iterated_.peg.x(), iterated_.peg.y(), iterated_.radius});
    show_rope("iterated x", "iterated y", iterated_);
    show_rope("stepped x", "stepped y", stepped_);
    show("iterated stretch", 100 * iterated_.stretch());
    show("stepped stretch", 100 * stepped_.stretch());
  }

  void show_rope(const char* x_name, const char* y_name, const RopeWithWeight& rope) {
    std::vector<double> x, y;
    for (const Vec& point : rope.x) {
      x.push_back(point.x());
      y.push_back(point.y());
    }
    show(x_name, x);
    show(y_name, y);
  }
};

}  // namespace

std::unique_ptr<Figure> make_two_ropes() {
  return std::make_unique<TwoRopes>();
}

}  // namespace live
