// SPDX-License-Identifier: MIT-0
// The lines of the page, moving vectors of float that take no double.
#include <catch2/catch_test_macros.hpp>
#include <cmath>
#include <utility>

// The lines multiply a counter by a float, as games do.
#pragma GCC diagnostic ignored "-Wconversion"
#include "calls.h"

namespace {

/// A vector as in glm: float times it, and nothing that a double would turn into.
template <class T>
struct Vec3 {
  T x = 0, y = 0, z = 0;
};
template <class T>
Vec3<T> operator+(const Vec3<T>& a, const Vec3<T>& b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}
template <class T>
Vec3<T> operator-(const Vec3<T>& a, const Vec3<T>& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
template <class T>
Vec3<T> operator*(T s, const Vec3<T>& a) {
  return {s * a.x, s * a.y, s * a.z};
}
template <class T>
T dot(const Vec3<T>& a, const Vec3<T>& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
template <class T>
T length(const Vec3<T>& a) {
  return std::sqrt(dot(a, a));
}

using Vec = Vec3<float>;

constexpr float tick = 1.0f / 60, omega = 6.2831853f;

}  // namespace

TEST_CASE("The lines of the page move float vectors as well") {
  const auto forces = [](Vec x, Vec, double) { return (-omega * omega) * x; };
  const Vec g{0, -9.81f, 0};
  Vec x{1, 0, 0}, v{};
  // A spring that swings once a second, after a whole swing. Its place changes little there, and
  // its velocity most.
  const auto is_back = [&](float within) {
    return length(x - Vec{1, 0, 0}) < within && length(v) < within * omega;
  };

  SECTION("a constant force") {
    x = {};
    for (int n = 0; n < 60; ++n) move_by_constant(x, v, n / 60.0, tick, g);
    CHECK(std::abs(x.y + 9.81f / 2) < 1e-4f);
  }
  SECTION("the air") {
    for (const float c : {0.05f, 2.0f}) {
      x = v = {};
      for (int n = 0; n < 60; ++n) move_in_air(x, v, tick, g, c);
      const double fallen = -9.81 / c * (1 - (1 - std::exp(-double(c))) / c);
      CHECK(std::abs(x.y - fallen) < 1e-4);
    }
  }
  SECTION("a spring") {
    for (int n = 0; n < 60; ++n) move_on_spring(x, v, tick, Vec{}, Vec{}, omega, 0.0f);
    CHECK(is_back(1e-4f));
  }
  SECTION("contacts") {
    for (int n = 0; n < 60; ++n) move_undamped(x, v, n / 60.0, tick, 6, forces);
    CHECK(is_back(0.01f));
  }
  SECTION("drag") {
    for (int n = 0; n < 60; ++n) move_with_drag(x, v, n / 60.0, tick, 6, 0.0f, forces);
    CHECK(is_back(0.01f));
  }
  SECTION("a damper between") {
    struct Body {
      float m;
      Vec x, v;
    };
    Body one{1, {0, 0, 0}, {}}, two{1, {1, 0, 0}, {}};
    const auto spring = [](const Body& a, const Body& b) {
      const Vec pull = (omega * omega / 2) * (b.x - a.x);
      return std::pair{pull, -1.0f * pull};
    };
    for (int n = 0; n < 60; ++n) move_pair(one, two, Vec{1, 0, 0}, 0.0f, tick, 6, spring);
    CHECK(length(two.x - one.x - Vec{1, 0, 0}) < 0.01f);
  }
  SECTION("links") {
    Vec last = start_linked(x, v, 0, tick, 2, forces);
    // A quarter of a swing more: what keeps no velocity changes its place most there.
    for (int n = 0; n < 75; ++n) {
      move_linked(x, v, last, n / 60.0, tick / 2, 2, forces, [](Vec&) {});
    }
    CHECK(length(x) < 0.01f);
  }
  SECTION("for ever, its place") {
    for (int n = 0; n < 60; ++n) move_for_ever(x, v, n / 60.0, tick, 1, forces);
    CHECK(is_back(1e-3f));
  }
  SECTION("for ever, its shape") {
    for (int n = 0; n < 60; ++n) move_in_shape(x, v, n / 60.0, tick, 1, forces);
    CHECK(is_back(0.01f));
  }
  SECTION("frames of any length") {
    shelf::FixedStep<float> clock{tick / 4};
    Vec a = integrate::velocity_verlet_start(x, v, 0.0, forces);
    for (int n = 0; n < 60; ++n) {
      clock.frame(n % 2 ? 0.025 : 1.0 / 120,
                  [&](double now) { integrate::velocity_verlet(x, v, a, now, clock.h, forces); });
    }
    const float turned = omega * float(clock.time());
    CHECK(length(x - Vec{std::cos(turned), 0, 0}) < 0.01f);
    CHECK(length(v + omega * Vec{std::sin(turned), 0, 0}) < 0.01f * omega);
  }
  SECTION("closely") {
    for (int n = 0; n < 60; ++n) move_closely(x, v, n / 60.0, tick, 1, forces);
    CHECK(is_back(1e-4f));
  }
  SECTION("to a tolerance") {
    move_within(x, v, 0, tick, 1.0, forces, 1e-4f);
    CHECK(is_back(1e-2f));
  }
  SECTION("a stiff spring") {
    const auto nothing = [](Vec, Vec, double) { return Vec{}; };
    for (int n = 0; n < 60; ++n) {
      move_stiff(x, v, n / 60.0, tick, 1, Vec{}, 600.0f, 0.0f, nothing);
    }
    CHECK(length(x) < 1e-6f);
  }
}

TEST_CASE(
    "In float the lines of the air are right to 0.02 % from c = 0.001 on, and off by a per cent at "
    "a millionth") {
  const auto off = [](float c) {
    float x = 0, v = 0;
    for (int n = 0; n < 60; ++n) move_in_air(x, v, 1 / 60.0f, -9.81f, c);
    // Of the exact fall in a second, by its series where c is small.
    const double wide = c, share = wide > 1e-3 ? (std::expm1(-wide) + wide) / (wide * wide)
                                               : 0.5 - wide / 6 + wide * wide / 24;
    return std::abs(double(x) / (-9.81 * share) - 1);
  };
  for (const float c : {0.001f, 0.003f, 0.01f, 0.1f, 1.0f, 10.0f}) CHECK(off(c) < 2e-4);
  CHECK(off(1e-6f) > 0.01);
}
