// SPDX-License-Identifier: MIT-0
/// @file
/// Curves made fit to be drawn.
#pragma once
#include <cstddef>
#include <optional>

#include "finding.h"

namespace grade {

/// The curve without the points that are not finite.
Curve finite(const Curve& curve);

/// The curve in powers of ten, without the points that have none.
Curve logarithm(const Curve& curve);

/// The curve with about `most` points that keep its shape: of each stretch its leftmost, rightmost,
/// lowest and highest point, in their order.
Curve thinned(const Curve& curve, std::size_t most);

struct Box {
  double left, right, bottom, top;
};

/// The part of the plane that a picture shows: all of the curves; but where the student's, the
/// first, goes far away from the others, only these and their surroundings. Nothing if there is not
/// a single point.
/// @param curves  of finite points
std::optional<Box> view(const std::vector<Curve>& curves);

/// Returns whether part of the curve lies outside.
bool leaves(const Curve& curve, const Box& box);

}  // namespace grade
