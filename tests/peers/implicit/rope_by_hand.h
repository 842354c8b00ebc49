// SPDX-License-Identifier: MIT-0
// An implicit step of a rope after Thomas, with blocks of three by three for numbers.
#pragma once
#include <Eigen/Dense>
#include <vector>

#include "implicit/variants.h"
#include "scenes/rope.h"

namespace implicit::by_hand {

/// For equal masses, the first of them held, without damping and gravity.
class Rope {
 public:
  explicit Rope(const scenes::Rope<>& rope)
      : rope_(rope),
        rows_(std::size_t(rope.count)),
        link_{rope.length / (rope.count - 1), rope.k} {}

  void operator()(State& s, double step) {
    assemble(s, step);
    solve();
    for (std::size_t i = 0; i < rows_.size(); ++i) {
      s.v.segment<3>(3 * Eigen::Index(i)) += rows_[i].rest;
    }
    s.x += step * s.v;
  }

 private:
  struct Row {
    Eigen::Vector3d x_end, rest;
    Eigen::Matrix3d middle, right;  // of a symmetric matrix: what is left is right of the row above
  };

  void assemble(const State& s, double step) {
    for (std::size_t i = 0; i < rows_.size(); ++i) {
      const auto at = 3 * Eigen::Index(i);
      rows_[i].x_end = s.x.segment<3>(at) + step * s.v.segment<3>(at);
      rows_[i].rest.setZero();
      rows_[i].middle.setIdentity();
    }
    const double weight = step / rope_.mass;
    for (std::size_t i = 0; i + 1 < rows_.size(); ++i) {
      Row &here = rows_[i], &next = rows_[i + 1];
      const Eigen::Vector3d d = next.x_end - here.x_end;
      const Eigen::Vector3d pull = weight * link_.pull(d, Eigen::Vector3d::Zero());
      const Eigen::Matrix3d block = step * weight * link_.stiffness(d);
      here.rest += pull;
      next.rest -= pull;
      here.middle += block;
      next.middle += block;
      here.right = -block;
    }
    rows_[0].rest.setZero();
    rows_[0].middle.setIdentity();
    rows_[0].right.setZero();
  }

  void solve() {
    for (std::size_t i = 0; i + 1 < rows_.size(); ++i) {
      Row &here = rows_[i], &next = rows_[i + 1];
      here.middle = here.middle.inverse().eval();
      const Eigen::Matrix3d factor = here.right.transpose() * here.middle;
      next.middle -= factor * here.right;
      next.rest -= factor * here.rest;
    }
    rows_.back().rest = rows_.back().middle.inverse() * rows_.back().rest;
    for (std::size_t i = rows_.size() - 1; i-- > 0;) {
      Row& here = rows_[i];
      here.rest = here.middle * (here.rest - here.right * rows_[i + 1].rest);
    }
  }

  scenes::Rope<> rope_;
  std::vector<Row> rows_;
  scenes::Link<> link_;
};

}  // namespace implicit::by_hand
