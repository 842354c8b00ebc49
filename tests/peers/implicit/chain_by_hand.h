// SPDX-License-Identifier: MIT-0
// An implicit step of a chain after Thomas, written out.
#pragma once
#include <vector>

#include "implicit/variants.h"
#include "scenes/chain.h"

namespace implicit::by_hand {

class Chain {
 public:
  explicit Chain(const scenes::Chain<>& chain)
      : chain_(chain),
        x_end_(size(chain)),
        rest_(x_end_),
        left_(x_end_),
        middle_(x_end_),
        right_(x_end_) {}

  void operator()(State& s, double step) {
    assemble(s, step);
    eliminate();
    for (std::size_t i = 0; i < rest_.size(); ++i) {
      const auto at = Eigen::Index(i);
      s.v[at] += rest_[i];
      s.x[at] += step * s.v[at];
    }
  }

 private:
  static std::size_t size(const scenes::Chain<>& chain) { return std::size_t(chain.count); }

  void assemble(const State& s, double step) {
    const std::size_t last = rest_.size() - 1;
    for (std::size_t i = 0; i <= last; ++i) {
      x_end_[i] = s.x[Eigen::Index(i)] + step * s.v[Eigen::Index(i)];
    }
    const double weight = step * step * chain_.k / chain_.mass;
    double before = chain_.k * x_end_[0];
    for (std::size_t i = 0; i < last; ++i) {
      const double after = chain_.k * (x_end_[i + 1] - x_end_[i]);
      rest_[i] = step * ((after - before) / chain_.mass);
      before = after;
      left_[i] = right_[i] = -weight;
      middle_[i] = 1 + 2 * weight;
    }
    const double tip_weight = step * step * chain_.k / chain_.tip;
    rest_[last] = step * (-before / chain_.tip);
    left_[last] = -tip_weight;
    middle_[last] = 1 + tip_weight;
    right_[last] = 0;
  }

  void eliminate() {
    double right = 0, rest = 0;  // of the row above, divided by its pivot
    for (std::size_t i = 0; i < rest_.size(); ++i) {
      const double inverse = 1 / (middle_[i] - left_[i] * right);
      right_[i] = right = right_[i] * inverse;
      rest_[i] = rest = (rest_[i] - left_[i] * rest) * inverse;
    }
    for (std::size_t i = rest_.size() - 1; i-- > 0;) rest_[i] = rest = rest_[i] - right_[i] * rest;
  }

  scenes::Chain<> chain_;
  std::vector<double> x_end_, rest_, left_, middle_, right_;
};

}  // namespace implicit::by_hand
