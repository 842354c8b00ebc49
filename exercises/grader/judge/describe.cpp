// SPDX-License-Identifier: MIT-0
#include "judge/describe.h"

#include "format_values.h"

namespace judge {

using grade::number;

std::string describe(double value, int digits) {
  return number(value, digits);
}

std::string describe(const Vec& a, int digits) {
  return "(" + number(a.x, digits) + ", " + number(a.y, digits) + ", " + number(a.z, digits) + ")";
}

std::string describe(const State& state, int digits) {
  return "x = " + describe(state.x, digits) + ", v = " + describe(state.v, digits);
}

std::string describe(const Start& start) {
  return describe(State{start.x, start.v}, 17) + ", t = " + number(start.t, 17);
}

std::string describe(const harness::Force& force) {
  const auto a = [&](std::size_t n) { return number(force.a[n], 17); };
  switch (force.kind) {
    case harness::Force::spring:
      return "a spring with omega = " + a(0) + "/s and zeta = " + a(1);
    case harness::Force::orbit:
      return "an orbit with mu = " + a(0) + " m^3/s^2";
    case harness::Force::falling:
      return "a fall with g = " + a(0) + " m/s^2, drag " + a(1) + "/s and " + a(2) + "/m";
    case harness::Force::wild:
      return "a force that bends, with drag and wind, drawn from the seed";
    case harness::Force::watched:
      break;
  }
  return "a force that only the judge knows";
}

}  // namespace judge
