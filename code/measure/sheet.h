// SPDX-License-Identifier: MIT-0
/// @file
/// A sheet of cloth in free fall, moved by link.h, for what is measured of it.
#pragma once
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <random>
#include <utility>
#include <vector>

#include "shelf/link.h"
#include "shelf/orientation.h"

namespace measure {

/// Four metres by four, in 64 by 32 cells with a diagonal in each, of floats: flat, with each link
/// as long as it should be, so that nothing has to move but down.
class Sheet {
 public:
  using Vec = shelf::Vec3<float>;

  static constexpr int across = 64, along = 32;
  static constexpr float mass = 0.15f * 16 / ((across + 1) * (along + 1));  ///< of a point [kg]

  /// Its links, cell by cell.
  Sheet() {
    const float width = 4.0f / across, depth = 4.0f / along, diagonal = std::hypot(width, depth);
    for (int j = 0; j <= along; ++j) {
      for (int i = 0; i <= across; ++i) {
        const float right = float(i) * width, on = float(j) * depth;
        x.push_back({0.8f * right - 0.6f * on, 0, 0.6f * right + 0.8f * on});
        if (i < across) links.push_back({at(i, j), at(i + 1, j), width});
        if (j < along) links.push_back({at(i, j), at(i, j + 1), depth});
        if (i < across && j < along) links.push_back({at(i, j), at(i + 1, j + 1), diagonal});
      }
    }
    before = x;
  }

  /// Puts its links in an order that leads nowhere, always the same.
  void shuffle() {
    std::mt19937 random(1);
    for (std::size_t i = links.size() - 1; i > 0; --i)
      std::swap(links[i], links[random() % (i + 1)]);
  }

  /// Turns the order of its links round.
  void turn_round() { std::reverse(links.begin(), links.end()); }

  /// One substep.
  void step(float h, float compliance, int passes) {
    for (std::size_t i = 0; i < x.size(); ++i) {
      const Vec here = x[i];
      x[i] = here + (here + -1.0f * before[i]) + h * h * Vec{0, -9.81f, 0};
      before[i] = here;
    }
    for (Link& link : links) link.tension = 0;
    for (int pass = 0; pass < passes; ++pass) {
      for (Link& link : links) {
        shelf::link(x[link.a], x[link.b], link.tension, 1 / mass, 1 / mass, link.length, compliance,
                    h, norm);
      }
    }
  }

  /// By which share of its length the worst link is too long or too short.
  double worst() const {
    double most = 0;
    for (const Link& link : links) {
      const double length = norm(x[link.b] + -1.0f * x[link.a]);
      most = std::max(most, std::abs(length / double(link.length) - 1));
    }
    return most;
  }

 private:
  struct Link {
    std::size_t a, b;
    float length, tension = 0;
  };

  static std::size_t at(int i, int j) { return std::size_t(j) * (across + 1) + std::size_t(i); }
  static constexpr auto norm = [](const Vec& v) { return std::sqrt(dot(v, v)); };

  std::vector<Vec> x, before;
  std::vector<Link> links;
};

}  // namespace measure
