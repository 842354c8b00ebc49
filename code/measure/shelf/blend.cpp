// SPDX-License-Identifier: MIT-0
#include "shelf/blend.h"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <utility>

#include "measure/shelf_card.h"

namespace measure::shelf_cards {
namespace {

using Eigen::Vector2d;
using Eigen::Vector2f;
using Eigen::Vector4d;

// Once round a metre away, at 3 rad/s.
Vector2d place(double t) {
  return {std::cos(3 * t), std::sin(3 * t)};
}

Vector2d velocity(double t) {
  return {-3 * std::sin(3 * t), 3 * std::cos(3 * t)};
}

constexpr int shares = 1000;

// How far off the straight and the curved blend are at most between two steps.
std::pair<double, double> off_the_circle(double h) {
  double straight = 0, curved = 0;
  for (int i = 0; i <= shares; ++i) {
    const double share = double(i) / shares;
    const Vector2d there = place(share * h);
    straight = std::max(straight, (shelf::blend(place(0), place(h), share) - there).norm());
    const Vector2d drawn =
        shelf::blend_curved(place(0), velocity(0), place(h), velocity(h), h, share);
    curved = std::max(curved, (drawn - there).norm());
  }
  return {straight, curved};
}

Promise straight() {
  const double off = off_the_circle(1 / 20.0).first;
  return {
      "a metre round a lamp, at 3 rad/s in 20 steps a second, the straight blend is 2.8 mm inside",
      std::abs(off - 2.8e-3) < 0.05e-3, off, 2, "m"};
}

Promise curved() {
  const double off = off_the_circle(1 / 20.0).second;
  return {"there the curved one is 1.3 thousandths of a millimetre off",
          std::abs(off - 1.3e-6) < 0.05e-6, off, 2, "m"};
}

Promise orders() {
  const auto [straight, curved] = off_the_circle(1 / 20.0);
  const auto [half_straight, half_curved] = off_the_circle(1 / 40.0);
  const double orders[] = {std::log2(straight / half_straight), std::log2(curved / half_curved)};
  return {
      "in steps half as long the straight one is a quarter as far off, and the curved one a "
      "sixteenth, to an order of 0.01",
      std::abs(orders[0] - 2) < 0.01 && std::abs(orders[1] - 4) < 0.01, orders[1], 3};
}

Promise ends() {
  const Vector2d before(0.1, -7e8), now(1 / 3.0, 4e-9), v(1e5, -3);
  int other = 0;
  for (const double share : {0.0, 1.0}) {
    const Vector2d end = share == 0.0 ? before : now;
    other += shelf::blend(before, now, share) != end;
    other += shelf::blend_curved(before, v, now, v, 1 / 60.0, share) != end;
  }
  return {"at 0 and at 1 both are one of the two places, to the last bit", other == 0,
          other == 0 ? Cell("the same") : Cell("others")};
}

Promise far_away() {
  double off = 0;
  const Vector2f before(10'000, -10'000), v(4, 4), now = before + v / 60.0f;
  for (int i = 0; i <= shares; ++i) {
    const float share = float(i) / shares;
    const Vector2d drawn = shelf::blend_curved(before, v, now, v, 1 / 60.0f, share).cast<double>();
    const Vector2d way = (now - before).cast<double>();
    off = std::max(off, (drawn - before.cast<double>() - share * way).cwiseAbs().maxCoeff());
  }
  const double place_of_a_float = std::ldexp(1.0, -10);  // between 8192 and 16384
  return {
      "in float, 10 km from the origin, no blend of an even motion is further off than two places "
      "of a float",
      off <= 2 * place_of_a_float, off / place_of_a_float, 2};
}

// A quaternion that is turned by so much about an axis.
Vector4d turned(double angle) {
  return {std::cos(angle / 2), 0.6 * std::sin(angle / 2), 0, 0.8 * std::sin(angle / 2)};
}

const auto product = [](const Vector4d& p, const Vector4d& q) { return p.dot(q); };

// The angle by which the blend is off, of what turns by `angle` between the two.
double off_the_turn(double angle, double share, double side) {
  const Vector4d between =
      shelf::blend_turned(turned(0), Vector4d(side * turned(angle)), share, product);
  return 2 * std::abs(std::atan2(between.tail<3>().norm(), between[0]) - share * angle / 2);
}

Promise even() {
  double off = 0, middle = 0;
  for (const double angle : {0.01, 0.1, 0.5, 1.0, 2.0, 3.0}) {
    for (int i = 0; i <= shares; ++i) {
      const double here = off_the_turn(angle, double(i) / shares, i % 2 == 0 ? 1 : -1);
      off = std::max(off, here / std::pow(angle, 3));
    }
    middle = std::max(middle, off_the_turn(angle, 0.5, -1));
  }
  return {
      "what turns evenly, by up to 3 rad between two steps, is off by less than 0.0046 of the cube "
      "of that angle, and in the middle by nothing but rounding",
      off < 0.0046 && middle < 1e-15, off, 2, "rad"};
}

Promise unit() {
  double off = 0;
  for (int i = 0; i <= shares; ++i) {
    const double share = double(i) / shares;
    off = std::max(
        off, std::abs(shelf::blend_turned(turned(0.3), turned(2), share, product).norm() - 1));
  }
  return {"the length of what is turned stays one, to 1e-15", off < 1e-15, off};
}

}  // namespace

ShelfCard blend() {
  return {"blend", {straight(), curved(), orders(), ends(), far_away(), even(), unit()}};
}

}  // namespace measure::shelf_cards
