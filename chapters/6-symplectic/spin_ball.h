// SPDX-License-Identifier: MIT-0
/// @file
/// The ball on which the angular momentum of the thrown body moves, as the body sees it.
#pragma once
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <string>

#include "measure/record.h"
#include "measure/tumbling.h"
#include "scenes/euler_top.h"
#include "shelf/orientation.h"

/// A place on the ball, in the body's axes: the angular momentum over its length.
using OnBall = shelf::Vec3<double>;

/// The angular momentum that the exact motion has, in the body's axes and over its length.
/// @param t  time since the throw [s]
inline OnBall exactly_on_ball(double t, const scenes::EulerTop& top = {}) {
  const scenes::EulerTop::Vec L = top.inertia.cwiseProduct(top.spin(t)).normalized();
  return {double(L.x()), double(L.y()), double(L.z())};
}

/// Follows an angular momentum along one step of spin_by_rotations(), from the body.
///
/// The middle moment is that of y. So y turns by nothing, and three pieces are left: about x, z, x.
///
/// @param L  angular momentum in the body's axes
/// @param observe  called as `observe(piece, L)` along pieces 1, 2 and 3, both ends among them
/// @returns  the angular momentum at the end of the step, in the body's axes
template <class Observe>
OnBall along_a_step(OnBall L, const shelf::Vec3<double>& inertia, double h, Observe&& observe) {
  constexpr int parts = 24;
  const auto about = [&](int piece, const OnBall& axis, double moment, double time) {
    const double half = time * dot(axis, L) * (1 / moment - 1 / inertia.y) / 2;
    const OnBall start = L;
    for (int n = 0; n <= parts; ++n) {
      const double by = half * n / parts;
      const OnBall sine = std::sin(by) * axis;
      L = shelf::rotate_back(shelf::Quaternion<double>{std::cos(by), sine.x, sine.y, sine.z},
                             start);
      observe(piece, L);
    }
  };
  about(1, {1, 0, 0}, inertia.x, h / 2);
  about(2, {0, 0, 1}, inertia.z, h);
  about(3, {1, 0, 0}, inertia.x, h / 2);
  return L;
}

/// The large step of the picture: when it starts, and how long it is [s].
inline constexpr double ball_start = 0.42, ball_step = 0.1;

/// A circle around an axis, from where it is farthest from the eye.
/// @param axis  of length one
/// @param through  a place on it
/// @param near  towards the eye, of length one
/// @param observe  called as `observe(place)`
template <class Observe>
void around_an_axis(const OnBall& axis, const OnBall& through, const OnBall& near,
                    Observe&& observe) {
  const double height = dot(axis, through), radius = std::sqrt(1 - height * height);
  const OnBall side = cross(axis, near);
  const OnBall across = (1 / std::sqrt(dot(side, side))) * side, away = cross(axis, across);
  for (int n = 0; n <= 120; ++n) {
    const double angle = n * std::numbers::pi / 60;
    observe(height * axis + radius * (std::cos(angle) * away + std::sin(angle) * across));
  }
}

/// Records what is drawn of the ball, as somebody far away sees it.
inline void spin_ball(measure::Record& record) {
  // From beside the third axis, towards the far end of the first, and from a little above.
  const double aside = -0.45, above = 0.35;
  const OnBall right{std::cos(aside), 0, -std::sin(aside)};
  const OnBall near{std::sin(aside) * std::cos(above), std::sin(above),
                    std::cos(aside) * std::cos(above)};
  const OnBall up = cross(near, right);
  auto& table = record.table("spin-ball", {{"piece"}, {"x"}, {"y"}, {"front", "", measure::whole}});
  const auto draw = [&](const std::string& piece, const OnBall& at) {
    table.add({piece, dot(at, right), dot(at, up), dot(at, near) > 0 ? 1.0 : 0.0});
  };

  // From the throw until the body has turned over twice, which closes the curve.
  for (int n = 0; n <= 416; ++n) {
    draw(n < 208 ? "over" : "and over", exactly_on_ball(n / 200.0));
    if (n == 208) draw("over", exactly_on_ball(n / 200.0));
  }

  const measure::Tumbling body;
  const double length = std::sqrt(dot(body.L, body.L));
  const OnBall start = exactly_on_ball(ball_start);
  const std::array<std::string, 4> pieces{"", "first", "second", "third"};
  draw("start", start);
  std::array<OnBall, 4> last{};
  const OnBall end =
      along_a_step(length * start, body.inertia, ball_step, [&](int n, const OnBall& L) {
        const auto piece = std::size_t(n);
        last.at(piece) = (1 / length) * L;
        draw(pieces.at(piece), last.at(piece));
      });
  for (std::size_t piece = 1; piece < pieces.size(); ++piece) {
    const OnBall axis{piece == 2 ? 0.0 : 1.0, 0, piece == 2 ? 1.0 : 0.0};
    around_an_axis(axis, last.at(piece), near,
                   [&](const OnBall& at) { draw("circle of the " + pieces.at(piece), at); });
  }
  draw("end", (1 / length) * end);
  const OnBall truth = exactly_on_ball(ball_start + ball_step);
  draw("true end", truth);
  const OnBall off = (1 / length) * end + (-1.0) * truth;
  record.number("spin-ball-off", 100 * std::sqrt(dot(off, off)), 2, "%");

  draw("axis 1", {-1, 0, 0});
  draw("axis 2", {0, 1, 0});
  draw("axis 3", {0, 0, 1});
}
