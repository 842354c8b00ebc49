// SPDX-License-Identifier: MIT-0
// The steps of chapter 6's cat in slow motion: first the kick, then the drift; or both at once.
#include "6-symplectic/cat.h"
#include "live/figure.h"
#include "live/run.h"
#include "measure/methods/euler.h"

namespace live {
namespace {

constexpr std::tuple methods{Method{"symplectic_euler", measure::symplectic_euler},
                             Method{"euler", measure::euler}};

// Its time is counted in steps. Euler's method moves everything over the whole of one, symplectic
// Euler the velocities over its first half and the places over its second; and so is drawn what
// stands in their places.
class Shears final : public Figure {
  static constexpr int parts = 20;          // of each edge
  static constexpr long moves = 48;         // that make a step
  static constexpr std::size_t apart = 33;  // points from one arrow to the next

  double method_ = 0, h_ = 1;
  double aside_ = 0, faster_ = 0;  // where it is put, from where the chapter has it [rad, rad/s]
  double begin_ = 0;               // the area at the start [rad^2/s]
  long taken_ = 0;
  Outline from_, to_;  // the cat before and after the step

  std::vector<Setting> settings() override {
    return {
        {"method", &method_, names(methods)}, {"h", &h_}, {"aside", &aside_}, {"faster", &faster_}};
  }

  void start() override {
    taken_ = 0;
    from_ = cat(parts);
    for (auto& [x, v] : from_) x += aside_, v += faster_;
    begin_ = area(from_);
    to_ = moved(from_);
    show_state();
  }

  void step() override {
    if (++taken_ % moves != 0) return;
    from_ = to_;
    to_ = moved(from_);
  }

  Outline moved(const Outline& outline) const {
    const auto& [symplectic_euler, euler] = methods;
    const auto carry = [&](const auto& step) {
      return carried(step, wrecking_ball, outline, h_, 1);
    };
    return method_ == 0 ? with_what_stands<double>(symplectic_euler, carry)
                        : with_what_stands<double>(euler, carry);
  }

  // How far the velocities have come in this step, and how far the places.
  std::pair<double, double> shares() const {
    const double share = double(taken_ % moves) / moves;
    if (method_ != 0) return {share, share};
    return {std::min(1.0, 2 * share), std::max(0.0, 2 * share - 1)};
  }

  Outline now() const {
    const auto [kicked, drifted] = shares();
    Outline found = from_;
    for (std::size_t i = 0; i < found.size(); ++i) {
      found[i].x += drifted * (to_[i].x - from_[i].x);
      found[i].v += kicked * (to_[i].v - from_[i].v);
    }
    return found;
  }

  void show_state() override {
    show("t", double(taken_) / moves);
    show("h", 1.0 / moves);
    const Outline outline = now();
    show_outline("x", "v", outline, 1);
    show_outline("from x", "from v", from_, apart);
    show_outline("to x", "to v", to_, apart);
    show("area", 100 * area(outline) / begin_);
    show("true area", 100);
  }

  // Each of its points, or each of some that stand so many apart.
  void show_outline(const char* x_name, const char* v_name, const Outline& outline,
                    std::size_t step) {
    std::vector<double> xs, vs;
    for (std::size_t i = 0; i < outline.size(); i += step) {
      xs.push_back(outline[i].x);
      vs.push_back(outline[i].v);
    }
    show_reference(x_name, xs);
    show_reference(v_name, vs);
  }
};

}  // namespace

std::unique_ptr<Figure> make_shears() {
  return std::make_unique<Shears>();
}

}  // namespace live
