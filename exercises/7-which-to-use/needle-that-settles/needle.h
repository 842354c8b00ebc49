// SPDX-License-Identifier: MIT-0
/// @file
/// A needle as its equation moves it, and as other equations would.
#pragma once
#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "judge/method.h"

namespace needle {

/// A target that moves, for so long.
struct Frame {
  double target, u, h;

  double end() const { return target + u * h; }
  Frame at(double other) const { return {other, 0, h}; }
};

struct State {
  double x, v;
};

/// How a needle is pulled, with the time in units of 1/omega, so that all are equally stiff.
struct Needle {
  double omega;
  double dragged = 0;  ///< the damper brakes it against so many times the target's velocity

  judge::Start start(const State& from) const { return {{from.x, 0, 0}, {from.v / omega, 0, 0}}; }
  State seen(const judge::State& state) const { return {state.x.x, state.v.x * omega}; }

  Acceleration pull(const Frame& frame) const {
    const double u = frame.u / omega, target = frame.target, against = dragged * u;
    return [=](const Vec& x, const Vec& v, double t) {
      return Vec{target + u * t - x.x - 2 * (v.x - against), 0, 0};
    };
  }

  /// By tiny steps; after so long that nothing is left of the start, where it follows.
  State after(const State& from, const Frame& frame) const {
    if (omega * frame.h > 200) return {frame.end() - 2 * (1 - dragged) * frame.u / omega, frame.u};
    return seen(judge::truth(start(from), omega * frame.h, 1, 1, pull(frame)).states.back());
  }

  /// By a single step of a method.
  State by(const judge::Method& method, const State& from, const Frame& frame) const {
    return seen(judge::run(method, start(from), omega * frame.h, 1, 1, pull(frame)).states.back());
  }

  /// At the end of a frame, if it has followed that target for ever.
  State follower(const Frame& frame) const {
    const double long_ago = 45 / omega;
    return after({frame.target - long_ago * frame.u, frame.u},
                 {frame.target - long_ago * frame.u, frame.u, long_ago + frame.h});
  }
};

/// To nine digits.
inline bool alike(double a, double b) {
  return std::abs(a - b) <= 1e-9 * (1 + std::abs(b));
}

/// To six digits.
inline bool nearly(double a, double b) {
  return std::abs(a - b) <= 1e-6 * (1 + std::abs(b));
}

inline bool alike(const State& a, const State& b) {
  return alike(a.x, b.x) && alike(a.v, b.v);
}

/// The step as it is written for a target that stands still, of the needle that trails; with its
/// parts at hand, so that one of them can be wrong.
struct Written {
  double behind, y, w, left, omega, h;

  Written(const Needle& needle, const State& from, const Frame& frame)
      : behind(2 * frame.u / needle.omega),
        y(from.x - frame.target + behind),
        w(from.v - frame.u),
        left(std::exp(-needle.omega * frame.h)),
        omega(needle.omega),
        h(frame.h) {}

  double rush() const { return w + omega * y; }
};

/// What is wrong with a velocity whose place is right.
inline std::string wrong_velocity(const Needle& needle, const State& from, const Frame& frame,
                                  const State& got, const State& right) {
  const std::string place = "the place is right, the velocity is not: ";
  const State late = needle.after({right.x, from.v}, frame);
  const Written is{needle, from, frame};
  const double rush = is.rush(), way = is.y + rush * is.h, left = is.left;
  const std::pair<double, const char*> known[] = {
      {(right.x - from.x) / frame.h,
       "this is the mean velocity of the frame, not the one at its end"},
      {late.v, "its line uses the new x, where the old one is meant"},
      {right.v - frame.u, "the target's own velocity is missing"},
      {right.v + frame.u, "the target's own velocity is there twice"},
      {frame.u + rush * left, "in its derivative the exponential was not differentiated"},
      {frame.u - is.omega * way * left, "in its derivative the bracket was not differentiated"},
      {frame.u + (rush - way) * left, "the exponential's derivative has a factor omega"},
      {frame.u + (rush + is.omega * way) * left,
       "the exponential's derivative has a minus: it is -omega exp(-omega h)"},
      {frame.u + is.w * left,
       "what the exponential's derivative is multiplied by is the whole bracket, with its second "
       "part"},
      {frame.u + (is.w - rush * is.h) * left, "an omega is missing"},
      {frame.u + (is.w - is.omega * rush) * left, "an h is missing"},
      {frame.u + (is.w + is.omega * rush * is.h) * left, "a sign is wrong"},
      {frame.u + is.w - is.omega * rush * is.h, "it is not multiplied by the exponential"},
      {frame.u + (from.v - is.omega * rush * is.h) * left,
       "its first part is the old velocity against the target, v - u"},
      {from.v, "it is the old one"}};
  for (const auto& [velocity, says] : known)
    if (alike(got.v, velocity)) return place + says;
  return "the place is right, the velocity is not";
}

/// What is wrong with a place in which one part of the formula is.
inline std::string wrong_place(const Needle& needle, const State& from, const Frame& frame,
                               double got) {
  const Written is{needle, from, frame};
  const double rush = is.rush(), there = frame.end() - is.behind;
  const std::pair<double, const char*> known[] = {
      {is.y + rush * is.h, "the way is not multiplied by the exponential"},
      {is.y + rush * is.h * is.left,
       "the first part of the bracket is not multiplied by the "
       "exponential"},
      {is.y * is.left + rush * is.h,
       "the second part of the bracket is not multiplied by the "
       "exponential"},
      {(is.y + rush * is.h) / is.left, "the exponential grows: exp(omega h) for exp(-omega h)"},
      {(is.y + rush * is.h) * std::exp(-is.h), "the exponential has no omega: exp(-h)"},
      {(is.y + (is.w - is.omega * is.y) * is.h) * is.left,
       "in the bracket a sign is wrong: it is v + omega y"},
      {(is.y + (is.w + is.y) * is.h) * is.left,
       "in the bracket omega is missing: it is v + omega y"},
      {(is.y + is.w * is.h) * is.left, "in the bracket omega y is missing: it is v + omega y"},
      {(is.y + is.omega * is.y * is.h) * is.left, "in the bracket v is missing: it is v + omega y"},
      {(is.y + rush) * is.left, "in the bracket h is missing"}};
  for (const auto& [way, says] : known)
    if (alike(got, there + way)) return says;
  return "";
}

/// Another number in place of the exponential: what is left of the way to the follower.
inline bool is_lowes(const Needle& needle, const Frame& frame, const State& got,
                     const State& right) {
  const double z = needle.omega * frame.h, there = needle.follower(frame).x;
  const double left = std::exp(-z) * (got.x - there) / (right.x - there);
  return std::abs(left * (1 + z + 0.48 * z * z + 0.235 * z * z * z) - 1) < 1e-9;
}

/// What may have been written instead, for one frame.
inline std::string recognise(double omega, const State& from, const Frame& frame,
                             const State& got) {
  const Needle needle{omega};
  const State right = needle.after(from, frame);
  const Frame held = frame.at(frame.target), at_end = frame.at(frame.end());
  if (got.x == from.x && got.v == from.v) return "nothing moves";
  if (!std::isfinite(got.x) && omega * frame.h > 200)
    return "short steps blow up in a frame as long as that; the exact step needs none";
  if (std::isnan(got.v) && std::isfinite(got.x)) return "the velocity is not a number: 0 / 0?";
  if (alike(got.x, right.x) && !nearly(got.v, right.v))
    return wrong_velocity(needle, from, frame, got, right);
  if (alike(got, needle.after(from, held)))
    return "this is right for a target that stays where it was at the start of the frame";
  if (alike(got, needle.after(from, at_end)))
    return "this is right for a target that is where it ends, from the start of the frame on";
  if (alike(got, needle.after(from, frame.at((frame.target + frame.end()) / 2))))
    return "this is right for a target that stands halfway";
  if (alike(got.x, Needle{omega, 1}.after(from, frame).x))
    return std::string(alike(got.x, frame.end()) ? "this ends at the target, as with "
                                                 : "this is right for ") +
           "a damper that moves along with the target; here it is fixed to the dial, and the "
           "needle trails";
  if (alike(got.x, Needle{omega, 2}.after(from, frame).x))
    return "this needle runs ahead of its target by as much as it should trail";
  if (alike(got, needle.after({from.x, from.v + frame.u}, frame)))
    return "this needle begins faster by u: against the target its velocity is v - u";
  if (alike(got.x, Needle{omega, 0.5}.after(from, frame).x))
    return "this needle trails by half of what it should";
  if (alike(got.x + frame.u * frame.h, right.x))
    return "the target moves on by u h during the frame, and that is missing in the place";
  if (alike(got.x + frame.end(), right.x) || alike(got.x + frame.target, right.x))
    return "this is the way that is left; the needle is there plus the target";
  if (alike(got.x, needle.after(from, Frame{0, 0, frame.h}).x))
    return "this needle goes to zero, wherever its target is";
  for (const Frame& still : {held, at_end}) {
    if (alike(got.x, still.target + (from.x - still.target) * std::exp(-omega * frame.h)))
      return "this is a needle without a velocity of its own";
  }
  for (const judge::Method& method : judge::methods()) {
    for (const Frame& with : {frame, held, at_end}) {
      if (alike(got.x, needle.by(method, from, with).x)) return "this is a step of " + method.name;
    }
  }
  if (const std::string says = wrong_place(needle, from, frame, got.x); !says.empty()) return says;
  if (is_lowes(needle, frame, got, right))
    return "this is 1 / (1 + z + 0.48 z^2 + 0.235 z^3) in place of exp(-z): close, and not exact";
  if (nearly(got.x, right.x) && nearly(got.v, right.v))
    return "right to seven digits and no further: a float, or a constant with an f?";
  if (got.x == frame.target || got.x == frame.end())
    return "the needle is held at its target, and this one is so fast that it shoots past";
  return alike(got.v, right.v) ? "the velocity is right, the place is not" : "";
}

}  // namespace needle
