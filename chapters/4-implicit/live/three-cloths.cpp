// SPDX-License-Identifier: MIT-0
// Three cloths of chapter 4 that hang side by side, under one blow.
#include <cstddef>
#include <optional>
#include <span>

#include "4-implicit/net/struck_cloths.h"
#include "live/figure.h"

namespace live {
namespace {

class ThreeCloths final : public Figure {
  double rate_ = 60, k_ = light_k, speed_ = 3, hit_x_ = 0, hit_y_ = -0.55;
  long frames_ = 0;
  std::optional<StruckCloths> cloths_;

  std::vector<Setting> settings() override {
    return {
        {"rate", &rate_}, {"k", &k_}, {"speed", &speed_}, {"hit x", &hit_x_}, {"hit y", &hit_y_}};
  }

  void start() override {
    frames_ = 0;
    cloths_.emplace(k_, 1 / rate_, Blow{.x = hit_x_, .y = hit_y_, .speed = speed_});
    show_state();
  }

  void step() override {
    ++frames_;
    cloths_->frame();
  }

  void show_state() override {
    show("t", double(frames_) / rate_);
    show("h", 1 / rate_);
    show("substeps", cloths_->substeps());
    show("side", StruckCloths::side);
    show_cloth("backward_euler", cloths_->backward_euler());
    show_cloth("bdf2", cloths_->bdf2());
    show_cloth("symplectic_euler", cloths_->substepped());
    const auto [solved, remembered, stepped] = cloths_->energies();
    show("backward_euler energy", solved);
    show("bdf2 energy", remembered);
    show("symplectic_euler energy", stepped);
  }

  void show_cloth(const char* name, const MassSpringState& s) {
    show(name, std::span(s.x.data(), std::size_t(s.x.size())));
  }
};

}  // namespace

std::unique_ptr<Figure> make_three_cloths() {
  return std::make_unique<ThreeCloths>();
}

}  // namespace live
