// SPDX-License-Identifier: MIT-0
#include "scenes/sine.h"

#include <algorithm>
#include <bit>
#include <catch2/catch_test_macros.hpp>
#include <cmath>
#include <cstdint>
#include <numbers>

using scenes::cosine;
using scenes::sine;

namespace {

// How far `value` is from `truth`, in units of the last place of the double nearest to `truth`.
double units_off(double value, long double truth) {
  const double nearest = std::abs(static_cast<double>(truth));
  const double unit = std::nextafter(nearest, INFINITY) - nearest;
  return static_cast<double>(std::abs(value - truth) / unit);
}

struct Worst {
  double off = 0;

  void at(double x) {
    const long double exact = x;
    off =
        std::max({off, units_off(sine(x), std::sin(exact)), units_off(cosine(x), std::cos(exact))});
  }
};

}  // namespace

TEST_CASE("Sine and cosine are less than one unit in the last place off") {
  Worst worst;
  for (int n = 0; n <= 1'000'000; ++n) worst.at(n * 1e-6);
  for (int n = -1'000'000; n <= 1'000'000; ++n) worst.at(n * 0.0999999);
  for (int power = -1022; power < 0; ++power) worst.at(std::ldexp(1.1, power));
  CHECK(worst.off < 0.85);
}

TEST_CASE("Sine and cosine are as good next to a multiple of an eighth of a turn") {
  Worst worst;
  for (int n = 1; n <= 127323; ++n) {
    const double multiple = n * (std::numbers::pi / 4);
    double x = std::nextafter(std::nextafter(multiple, 0.0), 0.0);
    for (int neighbour = 0; neighbour < 5; ++neighbour, x = std::nextafter(x, 1e9)) worst.at(x);
  }
  CHECK(worst.off < 0.85);
}

TEST_CASE("A float's sine is the float nearest to the truth, but for one in a million") {
  int wrong = 0;
  for (int n = -500'000; n < 500'000; ++n) {
    const float x = static_cast<float>(n) * 2e-5f;
    if (sine(x) != static_cast<float>(std::sin(static_cast<long double>(x)))) ++wrong;
  }
  CHECK(wrong <= 1);
}

TEST_CASE("Sine is odd and cosine is even, to the last bit") {
  for (int n = 0; n < 100'000; ++n) {
    const double x = n * 0.9999;
    if (sine(-x) != -sine(x) || cosine(-x) != cosine(x)) FAIL("at " << x);
  }
  CHECK(sine(0.0) == 0);
  CHECK(cosine(0.0) == 1);
}

TEST_CASE("Beyond its range the sine is not a number") {
  CHECK_FALSE(std::isnan(sine(1e5)));
  for (const double x : {std::nextafter(1e5, 1e6), -2e5, double(INFINITY), double(NAN)}) {
    CHECK(std::isnan(sine(x)));
    CHECK(std::isnan(cosine(x)));
  }
}

// FNV-1a over the bits of many values. The number is the same from every compiler.
constexpr std::uint64_t hash_of_sines(int count) {
  std::uint64_t hash = 0xcbf29ce484222325;
  for (int n = 0; n < count; ++n) {
    const double x = (n - count / 2) * 0.7853;
    for (const double value : {sine(x), cosine(x)}) {
      hash = (hash ^ std::bit_cast<std::uint64_t>(value)) * 0x100000001b3;
    }
  }
  return hash;
}

TEST_CASE(
    "Sine and cosine have the same bits from every compiler, at compile time and at run time") {
  constexpr std::uint64_t known = 4414405438435805503u;
  STATIC_CHECK(hash_of_sines(1000) == known);
  volatile int count = 1000;
  CHECK(hash_of_sines(count) == known);
}
