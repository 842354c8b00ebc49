// SPDX-License-Identifier: MIT-0
/// @file
/// A rope that hangs, moved by the lines of the page.
#pragma once
#include <Eigen/Core>

#include "calls.h"

inline constexpr int ticks_to_rest = 60 * 60 * 20;  ///< twenty minutes at sixty ticks a second

/// How far two metres of rope are stretched when they have come to rest, in a game of sixty ticks a
/// second, when each link is put right once in a step.
/// @returns  share of its length
inline double stretched(int links, int steps) {
  using Places = Eigen::Matrix2Xd;  // a column for each particle
  const double length = 2, link = length / links, tick = 1.0 / 60;
  const auto gravity = [](const Places& x, const Places&, double) {
    Places a = Places::Zero(2, x.cols());
    a.row(1).tail(x.cols() - 1).setConstant(-9.81);  // the first is held
    return a;
  };
  const auto pull_links = [link](Places& x) {
    for (int i = 1; i < x.cols(); ++i) {
      const Eigen::Vector2d d = x.col(i) - x.col(i - 1);
      const Eigen::Vector2d excess = (1 - link / d.norm()) * d;
      const double share = i == 1 ? 0 : 0.5;
      x.col(i - 1) += share * excess;
      x.col(i) -= (1 - share) * excess;
    }
  };
  Places x = Places::Zero(2, links + 1), v = x;
  for (int i = 0; i <= links; ++i) x(1, i) = -i * link;
  Places last = start_linked(x, v, 0.0, tick, steps, gravity);
  for (int n = 0; n < ticks_to_rest; ++n) {
    move_linked(x, v, last, n * tick, tick / steps, steps, gravity, pull_links);
  }
  double now = 0;
  for (int i = 1; i <= links; ++i) now += (x.col(i) - x.col(i - 1)).norm();
  return now / length - 1;
}
