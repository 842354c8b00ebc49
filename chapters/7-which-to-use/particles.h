// SPDX-License-Identifier: MIT-0
/// @file
/// Up to a million particles: what their layout in memory costs.
#pragma once
#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <map>
#include <span>
#include <string>
#include <vector>

#include "integrate/symplectic_euler.h"
#include "level.h"
#include "measure/record.h"
#include "measure/times.h"

// [lanes]
/// Sixteen floats side by side, or eight doubles: a `Vec` like any other.
template <class Real>
struct Lanes {
  using Part [[gnu::vector_size(16)]] = Real;
  Part a, b, c, d;

  friend Lanes operator+(const Lanes& p, const Lanes& q) {
    return {p.a + q.a, p.b + q.b, p.c + q.c, p.d + q.d};
  }
  friend Lanes operator*(Real scale, const Lanes& p) {
    return {scale * p.a, scale * p.b, scale * p.c, scale * p.d};
  }
};
// [lanes]

inline constexpr float frame_of_float = 1.0f / 60;  ///< [s]

/// One particle, as most would write it.
struct Particle {
  Eigen::Vector3f x, v;
};

/// One coordinate of sixteen particles.
struct Pack {
  Lanes<float> x, v;
};

/// A spark on a spring, in draught: the same for each coordinate.
inline constexpr scenes::Spring<float> spark{.omega = 2, .zeta = 0.025f};

/// One step for each particle in turn.
inline void step_structs(std::vector<Particle>& particles, float h) {
  for (Particle& p : particles) {
    integrate::symplectic_euler(p.x, p.v, 0.0f, h, [](const auto& x, const auto& v, float t) {
      return Eigen::Vector3f(spark(x, v, t));
    });
  }
}

/// One step for sixteen numbers at once.
inline void step_packs(std::span<Pack> packs, float h) {
  for (Pack& pack : packs) integrate::symplectic_euler(pack.x, pack.v, 0.0f, h, spark);
}

inline constexpr int steps_a_visit = 16;

// [blocks]
/// `steps_a_visit` steps for one block of packs, and only then the next block.
inline void step_blocks(std::vector<Pack>& packs, float h) {
  const std::span all(packs);
  // A pack is 16 places and 16 velocities, 128 bytes: 64 are 8 KB, which stay in the nearest cache.
  const std::size_t size = 64;
  for (std::size_t first = 0; first < all.size(); first += size) {
    const auto block = all.subspan(first, std::min(size, all.size() - first));
    for (int n = 0; n < steps_a_visit; ++n) step_packs(block, h);
  }
}
// [blocks]

/// Reads and writes the same memory, and hardly computes.
inline void touch(std::vector<Pack>& packs, float) {
  for (Pack& pack : packs) {
    pack.x = 0.999f * pack.x;
    pack.v = 0.999f * pack.v;
  }
}

/// The coordinates of the particles, packed: all of the first axis, then of the second, the third.
inline std::vector<Pack> packed(const std::vector<Particle>& particles) {
  std::vector<Pack> packs;
  for (Eigen::Index axis = 0; axis < 3; ++axis) {
    for (std::size_t first = 0; first < particles.size(); first += 16) {
      std::array<float, 16> x{}, v{};
      for (std::size_t i = 0; i < 16; ++i) {
        x[i] = particles[first + i].x[axis];
        v[i] = particles[first + i].v[axis];
      }
      packs.push_back({std::bit_cast<Lanes<float>>(x), std::bit_cast<Lanes<float>>(v)});
    }
  }
  return packs;
}

/// Particles in a cloud, no two alike.
inline std::vector<Particle> cloud(long count) {
  std::vector<Particle> particles(static_cast<std::size_t>(count));
  for (std::size_t n = 0; n < particles.size(); ++n) {
    const float a = float(n % 1009) / 1009, b = float(n % 97) / 97;
    particles[n] = {{a, b, a - b}, {b, -a, 1 - a}};
  }
  return particles;
}

/// The numbers of particles that are timed.
inline constexpr long particle_counts[] = {4'096, 16'384, 65'536, 262'144, 1'048'576, 4'194'304};

/// The name of a time.
inline std::string particles_name(const std::string& layout, long count) {
  return "particles/" + layout + "/" + std::to_string(count);
}

/// Forgets the times of particles if to move some took less time than to touch their memory: then
/// something came between, and there is no telling which of them it met.
inline void forget_if_disturbed(measure::Times& times) {
  const auto taken = [&](const std::string& layout, long count) {
    return times.at(particles_name(layout, count)).median;
  };
  const bool disturbed = std::ranges::any_of(particle_counts, [&](long count) {
    return std::min(taken("packs", count), taken("structs", count)) < taken("memory", count);
  });
  if (!disturbed) return;
  std::erase_if(times.of, [](const auto& time) { return time.first.starts_with("particles/"); });
}

inline void memory_wall(measure::Record& record) {
  auto& table = record.table("particles", {{"particles", "", measure::whole},
                                           {"structs", "ns", 2},
                                           {"packs", "ns", 2},
                                           {"memory alone", "ns", 2},
                                           {"packs 16 times", "ns", 2}});
  record.number("steps-a-visit", steps_a_visit, measure::whole);
  auto& curves = record.table("memory-wall", {{"particles", "", measure::whole},
                                              {"structs", "ns"},
                                              {"packs", "ns"},
                                              {"memory", "ns"},
                                              {"blocks", "ns"}});
  const auto median = [](const std::string& layout, long count) {
    return measure::recorded_times().at(particles_name(layout, count)).median;
  };
  const auto cell = [](const std::string& layout, long count) {
    return measure::Cell("time:" + particles_name(layout, count));
  };
  for (const long count : particle_counts) {
    table.add({double(count), cell("structs", count), cell("packs", count), cell("memory", count),
               cell("blocks", count)});
    curves.add({double(count), median("structs", count), median("packs", count),
                median("memory", count), median("blocks", count)});
  }
}
