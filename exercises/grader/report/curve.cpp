// SPDX-License-Identifier: MIT-0
#include "report/curve.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <span>

namespace grade {
namespace {

/// Free room between the outermost points and the edge, in widths and heights.
constexpr double room = 0.04;
/// The distance to which the student's curve is followed around the others, in their widths and
/// heights.
constexpr double surroundings = 1;

void add(Curve& curve, const Curve& from, std::size_t i) {
  curve.x.push_back(from.x[i]);
  curve.y.push_back(from.y[i]);
}

Box box_of(std::span<const Curve> curves) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  Box box{infinity, -infinity, infinity, -infinity};
  for (const Curve& curve : curves) {
    for (const double x : curve.x)
      box.left = std::min(box.left, x), box.right = std::max(box.right, x);
    for (const double y : curve.y)
      box.bottom = std::min(box.bottom, y), box.top = std::max(box.top, y);
  }
  return box;
}

bool has_points(std::span<const Curve> curves) {
  return std::any_of(curves.begin(), curves.end(), [](const Curve& c) { return !c.x.empty(); });
}

/// A side of `whole`, but no further from `part` than its surroundings.
void limit(double& low, double& high, double part_low, double part_high, double width) {
  low = std::max(low, part_low - surroundings * width);
  high = std::min(high, part_high + surroundings * width);
}

Box with_room(const Box& box) {
  const double x = room * (box.right - box.left), y = room * (box.top - box.bottom);
  return {box.left - x, box.right + x, box.bottom - y, box.top + y};
}

}  // namespace

Curve finite(const Curve& curve) {
  Curve kept{curve.name, {}, {}};
  for (std::size_t i = 0; i < std::min(curve.x.size(), curve.y.size()); ++i) {
    if (std::isfinite(curve.x[i]) && std::isfinite(curve.y[i])) add(kept, curve, i);
  }
  return kept;
}

Curve logarithm(const Curve& curve) {
  Curve powers = curve;
  for (double& x : powers.x) x = std::log10(x);
  for (double& y : powers.y) y = std::log10(y);
  return finite(powers);
}

Curve thinned(const Curve& curve, std::size_t most) {
  const std::size_t all = curve.x.size();
  if (all <= most) return curve;
  std::set<std::size_t> kept{0, all - 1};
  const std::size_t stretches = std::max<std::size_t>(1, most / 4);
  for (std::size_t s = 0; s < stretches; ++s) {
    const std::size_t from = all * s / stretches, to = all * (s + 1) / stretches;
    for (const std::vector<double>& side : {curve.x, curve.y}) {
      const std::span stretch(side.begin() + std::ptrdiff_t(from), to - from);
      const auto [low, high] = std::minmax_element(stretch.begin(), stretch.end());
      kept.insert(from + std::size_t(low - stretch.begin()));
      kept.insert(from + std::size_t(high - stretch.begin()));
    }
  }
  Curve thin{curve.name, {}, {}};
  for (const std::size_t i : kept) add(thin, curve, i);
  return thin;
}

std::optional<Box> view(const std::vector<Curve>& curves) {
  if (!has_points(curves)) return std::nullopt;
  Box box = box_of(curves);
  const std::span<const Curve> others = std::span(curves).subspan(1);
  if (!has_points(others)) return with_room(box);
  const Box part = box_of(others);
  const double width = part.right - part.left, height = part.top - part.bottom;
  limit(box.left, box.right, part.left, part.right, width > 0 ? width : height);
  limit(box.bottom, box.top, part.bottom, part.top, height > 0 ? height : width);
  return with_room(box);
}

bool leaves(const Curve& curve, const Box& box) {
  const auto outside = [](const std::vector<double>& values, double low, double high) {
    return std::any_of(values.begin(), values.end(),
                       [&](double value) { return value < low || value > high; });
  };
  return outside(curve.x, box.left, box.right) || outside(curve.y, box.bottom, box.top);
}

}  // namespace grade
