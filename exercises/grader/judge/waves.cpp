// SPDX-License-Identifier: MIT-0
#include "judge/waves.h"

#include <cmath>
#include <numbers>

namespace judge {

Waves::Waves(Random& random, double strength, double scale, double seconds) {
  constexpr double turn = 2 * std::numbers::pi;
  double square = 0;
  for (Wave& wave : waves_) {
    wave.push = random.vector(-1, 1);
    wave.along = (turn / scale / std::sqrt(3.0)) * random.vector(-1, 1);
    wave.rate = turn / seconds * random.between(-1, 1);
    wave.at = random.between(0, turn);
    square += dot(wave.push, wave.push) / 2;
  }
  for (Wave& wave : waves_) wave.push *= strength / std::sqrt(square);
}

Vec Waves::operator()(const Vec& x, double t) const {
  Vec sum;
  for (const Wave& wave : waves_) {
    sum += std::sin(dot(wave.along, x) + wave.rate * t + wave.at) * wave.push;
  }
  return sum;
}

}  // namespace judge
