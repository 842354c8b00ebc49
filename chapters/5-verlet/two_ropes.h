// SPDX-License-Identifier: MIT-0
/// @file
/// A rope with a weight, in a hand above a peg, whose pulls are spent on iterations or on substeps.
#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <utility>

#include "../cast.h"
#include "rope.h"
#include "shelf/link.h"

/// Two metres in twenty links, and at the end what weighs more than the points between them.
struct RopeWithWeight {
  static constexpr std::size_t links = 20;
  static constexpr double length = 2.0 / double(links);  // of a link [m]
  Vec peg = {0, -0.3};                                   ///< [m]
  double radius = 0.12;                                  ///< of the peg [m]
  std::array<Vec, links + 1> x, before;
  std::array<double, links> tension{};
  std::array<double, links + 1> w;  ///< 1 over the weight, in points; of the one in the hand 0
  std::size_t held = 0;             ///< the point in the hand
  std::size_t whole = links + 1;    ///< how many points hang together before the link that is cut

  /// At rest.
  /// @param weight  how many points its last one weighs
  RopeWithWeight(const Vec& hand, const Vec& direction, double weight) {
    for (std::size_t i = 0; i <= links; ++i)
      x[i] = before[i] = hand + (double(i) * length) * direction;
    hold(0, weight);
  }

  /// Takes another point in the hand, or hangs another weight on the last one.
  void hold(std::size_t point, double weight) {
    w.fill(1);
    w.back() = 1 / weight;
    held = point;
    w[held] = 0;
  }

  /// What hangs together.
  struct Part {
    std::span<Vec> x, before;
    std::span<double> tension;
    std::span<const double> w;
  };

  std::array<Part, 2> parts() {
    const auto part = [this](std::size_t from, std::size_t count) -> Part {
      const std::size_t first_link = std::min(from, links);
      return {std::span(x).subspan(from, count), std::span(before).subspan(from, count),
              std::span(tension).subspan(first_link), std::span(w).subspan(from, count)};
    };
    return {part(0, whole), part(whole, links + 1 - whole)};
  }

  /// A frame, in which every link is pulled as many times as substeps and iterations say together.
  /// @param hand  where the hand is at its end
  void frame_of(const Vec& hand, int substeps, int iterations) {
    const auto norm = [](const Vec& d) { return d.norm(); };
    const auto outside = [this](const Vec& place) -> Vec {
      const Vec away = place - peg;
      return away.norm() < radius ? Vec(peg + (radius / away.norm()) * away) : place;
    };
    // [frame]
    const double h = frame / substeps;
    const Vec way = hand - x[held];
    const shelf::Rope<double> rope{.length = length, .passes = iterations};
    for (int n = 0; n < substeps; ++n) {
      x[held] += way / substeps;
      for (Part part : parts())
        shelf::rope_step(part.x, part.before, part.tension, part.w, part.x.size(), rope, g, h, norm,
                         outside);
    }
    // [frame]
  }

  /// How much longer its links are than they should be, but for one that is cut [share].
  double stretch() const {
    double sum = 0;
    std::size_t count = 0;
    for (std::size_t i = 1; i <= links; ++i) {
      if (i == whole) continue;
      sum += (x[i] - x[i - 1]).norm();
      ++count;
    }
    return sum / (double(count) * length) - 1;
  }

 private:
  inline static const Vec g = gravity({}, {}, 0.0);
};

/// The rope of the first page, a moment before it falls over its peg.
inline RopeWithWeight level_rope(double weight) {
  return {{-0.6, 0.1}, {1, 0}, weight};
}

/// How far a rope with a weight is stretched when it has come to rest, without a peg [share].
inline double hanging_with_weight(double weight, int substeps, int iterations) {
  RopeWithWeight rope({0, 0}, {0, -1}, weight);
  rope.radius = 0;
  double before = INFINITY, now = 0;
  for (int minute = 0; minute < 60 && std::abs(now - before) > 1e-6; ++minute) {
    for (int n = 0; n < 3600; ++n) rope.frame_of({0, 0}, substeps, iterations);
    before = std::exchange(now, rope.stretch());
  }
  return now;
}
