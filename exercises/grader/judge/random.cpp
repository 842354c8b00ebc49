// SPDX-License-Identifier: MIT-0
#include "judge/random.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "judge/session.h"

namespace judge {
namespace {

// The smallest number that comes, as a share of the largest, if nothing else is said: mostly,
// and now and then.
constexpr double sizes = 0x1p-30, all_sizes = 0x1p-44;

// The standard fixes this generator's numbers, but no distribution's, and no hash of a string.
std::seed_seq seed(const std::string& test) {
  std::vector<std::uint32_t> words{static_cast<std::uint32_t>(session().seed),
                                   static_cast<std::uint32_t>(session().seed >> 32)};
  for (const char letter : test) words.push_back(static_cast<unsigned char>(letter));
  return std::seed_seq(words.begin(), words.end());
}

}  // namespace

Random::Random() {
  std::seed_seq words = seed(session().tests.back().name);
  numbers_.seed(words);
}

double Random::between(double low, double high) {
  return low + (high - low) * static_cast<double>(numbers_() >> 11) * 0x1p-53;
}

double Random::between(const harness::Bounds& bounds) {
  return between(bounds.smallest(), bounds.largest());
}

double Random::octaves(double low, double high) {
  const int power = whole(std::ilogb(low), std::ilogb(high));
  return std::clamp(std::ldexp(between(1, 2), power), low, high);
}

int Random::whole(int low, int high) {
  return low + static_cast<int>(numbers_() % static_cast<std::uint64_t>(high - low + 1));
}

double Random::sign() {
  return 2 * whole(0, 1) - 1;
}

double Random::nearly_one(double least, double most) {
  const double side = sign();
  return 1 + side * octaves(least, most);
}

Vec Random::vector(double low, double high) {
  Vec drawn;
  drawn.x = between(low, high);
  drawn.y = between(low, high);
  drawn.z = between(low, high);
  return drawn;
}

std::vector<double> Random::all_of(const harness::Bounds& bounds, int drawn) {
  std::vector<double> values(bounds.asked().begin(), bounds.asked().end());
  for (int n = 0; n < drawn; ++n) values.push_back(between(bounds));
  return values;
}

double Random::anywhere(const harness::Bounds& bounds) {
  const int kind = whole(0, 2);
  if (kind == 0) {
    const int last = static_cast<int>(bounds.asked().size()) - 1;
    return bounds.asked()[static_cast<std::size_t>(whole(0, last))];
  }
  if (kind == 1) return between(bounds);
  const double low = bounds.smallest(), high = bounds.largest();
  if (low > 0) return octaves(low, high);
  if (high < 0) return -octaves(-high, -low);
  const bool below = high == 0 || (low < 0 && whole(0, 1) == 1);
  const double most = below ? -low : high;
  const double size = octaves((whole(0, 3) == 0 ? all_sizes : sizes) * most, most);
  return below ? -size : size;
}

Vec Random::vector_anywhere(const harness::Bounds& bounds) {
  const double size = anywhere(bounds);
  Vec drawn = vector(-1, 1);
  if (whole(0, 3) == 0) {
    const int axis = whole(0, 2);
    const double side = sign();
    drawn = side * Vec{axis == 0 ? 1.0 : 0, axis == 1 ? 1.0 : 0, axis == 2 ? 1.0 : 0};
  }
  return size / length(drawn) * drawn;
}

Start Random::start() {
  const Vec side{sign(), sign(), sign()};
  const Vec x = vector(0.4, 1.2), v = vector(0.4, 1.2);
  return {{side.x * x.x, side.y * x.y, side.z * x.z}, {v.x, -v.y, v.z}, between(0.1, 0.9)};
}

harness::Force Random::wild() {
  harness::Force force{harness::Force::wild, {}};
  for (double& constant : force.a) constant = between(0.7, 1.6);
  force.a[6] = between(0.2, 0.4);
  return force;
}

harness::Force Random::any_force() {
  if (whole(0, 3) > 0) return wild();
  return {harness::Force::falling, {whole(0, 1) == 1 ? 9.81 : 0.0, 0, 0}};
}

}  // namespace judge
