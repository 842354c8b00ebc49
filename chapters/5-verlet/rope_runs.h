// SPDX-License-Identifier: MIT-0
/// @file
/// What becomes of two metres of rope.
#pragma once
#include <cmath>
#include <cstddef>
#include <numbers>
#include <string>
#include <vector>

#include "measure/eigenvalues.h"
#include "measure/methods.h"
#include "measure/record.h"
#include "measure/run.h"
#include "rope_in_frames.h"
#include "shelf/link.h"
#include "toys.h"

/// Where something last turned from rising to falling.
inline double last_rise(const std::vector<double>& heights) {
  for (std::size_t n = heights.size() - 2; n > 0; --n) {
    if (heights[n] >= heights[n - 1] && heights[n] >= heights[n + 1]) return heights[n];
  }
  return heights.front();
}

/// The length of the rope of springs [m].
inline double length_of(const Eigen::VectorXd& x) {
  double length = 0;
  for (Eigen::Index i = 3; i < x.size(); i += 3) {
    length += (x.segment<3>(i) - x.segment<3>(i - 3)).norm();
  }
  return length;
}

/// The frequency of the fastest motion of the rope of springs, which is along it [1/s].
inline double fastest_swing() {
  const auto s = rope_of_springs.start();
  const auto size = s.x.size();
  Eigen::MatrixXd slopes = Eigen::MatrixXd::Zero(size, size);
  rope_of_springs.jacobian(s.x, s.v, 0.0,
                           [&](int i, int j, double dadx, double) { slopes(i, j) += dadx; });
  return std::sqrt(measure::largest_eigenvalue(slopes)) / (2 * std::numbers::pi);
}

inline void burst(measure::Record& record) {
  auto& table = record.table("burst", {{"frame", "", measure::whole}, {"springs", "m"}});
  auto s = rope_of_springs.start();
  // [burst]
  const auto keep = [&](double t, const auto& now) {
    table.add({std::round(60 * t), length_of(now.x)});
  };
  measure::run(measure::stormer_verlet, rope_of_springs, s, frame, 8, keep);
  // [burst]
  record.number("burst-rate", 1 / frame, measure::whole, "Hz");
  record.number("calm-rate", 6 / frame, measure::whole, "Hz");
  record.number("burst-pair",
                std::sqrt(2 * rope_of_springs.k / rope_of_springs.mass) / (2 * std::numbers::pi),
                2);
  record.number("burst-fastest", fastest_swing(), 3);
  record.number("burst-5", table.rows[5][1].value, 2, "m");
  auto& calm =
      record.table("calm", {{"frame", "", measure::whole}, {"springs", "m"}, {"links", "m"}});
  Rope rope = two_metres(20, {1, 0});
  s = rope_of_springs.start();
  measure::run(measure::stormer_verlet, rope_of_springs, s, frame / 6, 360,
               [&](double t, const auto& now) {
                 const double frames = 60 * t;
                 if (std::abs(frames - std::round(frames)) > 0.01) return;
                 calm.add({std::round(frames), length_of(now.x), 2 * (1 + stretch(rope))});
                 rope.step(frame, 8);
               });
}

/// A link of a rope that hangs still: how much too long it is when it is pulled, on average over
/// the iterations, and after the step [m].
struct HangingLink {
  double pulled = 0, after = 0;
};

/// The links of a hanging rope in one step, the lowest first.
inline std::vector<HangingLink> hanging_links(int links, double h, int iterations) {
  const auto size = std::size_t(links);
  Rope rope = two_metres(links, {0, -1});
  for (int n = 0; n < 36'000; ++n) rope.step(h, iterations);  // until it hangs still
  const auto too_long = [&](std::size_t i) {
    return (rope.x[i] - rope.x[i - 1]).norm() - rope.link;
  };
  for (std::size_t i = 1; i <= size; ++i)
    integrate::stormer_verlet(rope.x[i], rope.x_previous[i], 0.0, h, gravity);
  std::vector<HangingLink> seen(size);
  for (int iteration = 0; iteration < iterations; ++iteration) {
    for (std::size_t i = 1; i <= size; ++i) {
      seen[size - i].pulled += too_long(i) / iterations;
      rope.pull(i);
    }
  }
  for (std::size_t i = 1; i <= size; ++i) seen[size - i].after = too_long(i);
  return seen;
}

/// What is left open of each link of a rope of twenty with one iteration, and how much it closes.
inline void links_of_a_rope(measure::Record& record) {
  auto& table = record.table("hanging-links",
                             {{"link", "", measure::whole}, {"pulled", "cm"}, {"after", "cm"}});
  double link = 0;
  for (const auto& [pulled, after] : hanging_links(20, frame, 1))
    table.add({++link, 100 * pulled, 100 * after});
}

/// How much longer a rope of stiff links hangs, with one iteration in a step [m].
inline double stretch_of_stiff_links(int links, double h) {
  return links * (links - 1) * 9.81 * h * h / 2;
}

/// How far a rope of XPBD hangs longer, whose springs should let it hang one per cent longer [%].
/// @param compliant  false for links that give nothing
inline double hangs_longer(int substeps, bool compliant) {
  constexpr double m = 0.01, k = m * 9.81 * 20 * 21 / 2 / 0.02, h_frame = 1 / 60.0;
  double x[21], before[21], tension[20] = {}, w[21];
  for (int i = 0; i <= 20; ++i) x[i] = before[i] = -0.1 * i, w[i] = i > 0 ? 1 / m : 0;
  const shelf::Rope<double> links{0.1, compliant ? 1 / k : 0};
  const double h = h_frame / substeps;
  for (int n = 0; n < 3600 * substeps; ++n) {
    shelf::rope_step(
        x, before, tension, w, 21, links, -9.81, h, [](double d) { return std::abs(d); },
        [](double place) { return place; });
  }
  return 100 * (-x[20] / 2 - 1);
}

inline void ropes(measure::Record& record) {
  using measure::whole;
  auto& shapes = record.table("shapes", {{"iterations", "", whole}, {"x", "m"}, {"y", "m"}});
  for (const int iterations : {1, 4, 16, 64}) {
    Rope rope = two_metres(20, {1, 0});
    for (int n = 0; n < 42; ++n) rope.step(frame, iterations);
    for (const Vec& point : rope.x) shapes.add({double(iterations), point.x(), point.y()});
  }
  auto& table = record.table("stretch", {{"iterations", "", whole},
                                         {"10 links", "%"},
                                         {"20 links", "%"},
                                         {"40 links", "%"},
                                         {"20 links in substeps", "%"}});
  for (int k = 1; k <= 64; k *= 2) {
    table.add({double(k), 100 * hanging(10, frame, k), 100 * hanging(20, frame, k),
               100 * hanging(40, frame, k), 100 * hanging(20, frame / k, 1)});
  }
  record.number("hangs-60", 100 * hanging(20, frame, 8), 2, "%");
  record.number("hangs-30", 100 * hanging(20, 2 * frame, 8), 2, "%");
  record.number("hangs-120", 100 * hanging(20, frame / 2, 8), 2, "%");
  record.number("hangs-substeps", 100 * hanging(20, frame / 8, 1), 2, "%");
  const auto recorded = [](auto move) {
    return 100 * hanging_in_recorded_frames(move, 20, 8).second;
  };
  record.number("hangs-recorded", recorded(plain), 2, "%");
  record.number("hangs-corrected", recorded(corrected), 2, "%");
  record.number("falls-8", 100 * falling(20, frame, 8), 2, "%");

  auto& asked = record.table(
      "asked",
      {{"substeps", "", whole}, {"XPBD", "%", 4}, {"stiff links", "%", 4}, {"sum", "%", 4}});
  for (const int substeps : {1, 4, 8, 16, 32}) {
    const double law = 100 * stretch_of_stiff_links(20, frame / substeps) / 2;  // of two metres
    asked.add(
        {double(substeps), hangs_longer(substeps, true), hangs_longer(substeps, false), 1 + law});
  }

  auto& pendulum = record.table("pendulum", {{"t", "s"}, {"one step", "m"}, {"eight", "m"}});
  Rope once = two_metres(1, {1, 0}), often = once;
  std::vector<double> again, again_often;
  for (int n = 0; n <= 600; ++n) {
    pendulum.add({n * frame, once.x[1].y(), often.x[1].y()});
    again.push_back(once.x[1].y());
    again_often.push_back(often.x[1].y());
    once.step(frame, 1);
    for (int substep = 0; substep < 8; ++substep) often.step(frame / 8, 1);
  }
  record.number("pendulum-again", 2 + last_rise(again), 2, "m");
  record.number("pendulum-often", 2 + last_rise(again_often), 2, "m");
}
