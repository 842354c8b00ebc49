// SPDX-License-Identifier: MIT-0
// A rope on a nail, in chapter 4: in substeps of symplectic Euler, and solved by backward Euler.
#include <optional>

#include "4-implicit/net/nets.h"
#include "4-implicit/net/substeps.h"
#include "live/figure.h"

namespace live {
namespace {

// Both ropes are made of counted numbers, whose bits are those of plain ones: a second rope only to
// be counted would need as much room in the page again.
using Rope = scenes::Rope<OpCounted>;
using State = scenes::State<Rope::Vec>;

class HangingRope final : public Figure {
  double method_ = 1, k_ = 1e4, substeps_ = 20;
  long frames_ = 0;
  Rope rope_;
  State stepped_, solved_;
  std::optional<decltype(system_of(rope_))> system_;

  std::vector<Setting> settings() override {
    return {{"method", &method_, {"symplectic_euler", "backward_euler"}},
            {"k", &k_},
            {"substeps", &substeps_}};
  }

  void start() override {
    frames_ = 0;
    rope_ = rope_on_a_nail<OpCounted>(k_);
    stepped_ = solved_ = rope_.start();
    system_.emplace(system_of(rope_));
    show_state();
    show_cost();
  }

  void step() override {
    ++frames_;
    for (int n = 0; n < int(substeps_); ++n) {
      integrate::symplectic_euler(stepped_.x, stepped_.v, 0.0, OpCounted(frame / substeps_), rope_);
    }
    const bool solved =
        integrate::backward_euler(solved_.x, solved_.v, 0.0, OpCounted(frame), rope_, *system_);
    if (!solved) solved_.x.setConstant(OpCounted(NAN));
  }

  void show_state() override {
    show("t", double(frames_) * frame);
    show("h", frame);
    show_rope("stepped x", "stepped y", stepped_);
    show_rope("solved x", "solved y", solved_);
    show("true energy", 0);
    show("stepped energy", energy(stepped_));
    show("solved energy", energy(solved_));
  }

  // In units of what a free fall by its length would take from the rope.
  double energy(const State& s) const {
    const OpCounted fall = double(rope_.count) * rope_.mass * rope_.g * rope_.length;
    return double(rope_.energy(s.x, s.v) / fall);
  }

  void show_rope(const char* x_name, const char* y_name, const State& s) {
    std::vector<double> x, y;
    for (int i = 0; i < rope_.count; ++i) {
      x.push_back(double(s.x[3 * i]));
      y.push_back(double(s.x[3 * i + 1]));
    }
    show(x_name, x);
    show(y_name, y);
  }

  // Multiplications of a frame, and how many substeps it takes to be stable.
  void show_cost() {
    show("stepped work", substeps_ * work_of_substep(rope_));
    show("solved work", work_of_step(rope_));
    show("minimum", frame * highest_frequency(rope_on_a_nail(k_)) / 2);
  }
};

}  // namespace

std::unique_ptr<Figure> make_hanging_rope() {
  return std::make_unique<HangingRope>();
}

}  // namespace live
