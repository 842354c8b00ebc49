// SPDX-License-Identifier: MIT-0
#include "judge/random.h"

#include <string>

#include "judge/session.h"

namespace judge {
namespace {

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

int Random::whole(int low, int high) {
  return low + static_cast<int>(numbers_() % static_cast<std::uint64_t>(high - low + 1));
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

Start Random::start() {
  const Vec sign{whole(0, 1) * 2.0 - 1, whole(0, 1) * 2.0 - 1, whole(0, 1) * 2.0 - 1};
  const Vec x = vector(0.4, 1.2), v = vector(0.4, 1.2);
  return {{sign.x * x.x, sign.y * x.y, sign.z * x.z}, {v.x, -v.y, v.z}, between(0.1, 0.9)};
}

harness::Force Random::wild() {
  harness::Force force{harness::Force::wild, {}};
  for (double& constant : force.a) constant = between(0.7, 1.6);
  force.a[6] = between(0.2, 0.4);
  return force;
}

}  // namespace judge
