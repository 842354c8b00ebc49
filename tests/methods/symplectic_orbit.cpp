// SPDX-License-Identifier: MIT-0
// A million steps of a planet: who keeps its energy, and who its angular momentum.
#include <catch2/catch_template_test_macros.hpp>
#include <catch2/catch_test_macros.hpp>
#include <cmath>
#include <limits>
#include <typeinfo>

#include "measure/energy.h"
#include "measure/methods.h"
#include "scenes/orbit.h"

using scenes::Orbit;

namespace {

constexpr double h = 0.01;  // some 600 steps a turn

// If every step rounded the same way: some four roundings a step, of terms that are up to ten times
// as large as what is kept.
constexpr double rounding(long taken) {
  return 40 * double(taken) * std::numeric_limits<double>::epsilon();
}

// A mean whose weights fade in and out so smoothly that what swings with every turn drops out.
struct SmoothMean {
  double sum = 0, weights = 0;

  void add(double value, double part) {
    if (part <= 0 || part >= 1) return;
    const double weight = std::exp(-1 / (part * (1 - part)));
    sum += weight * value;
    weights += weight;
  }
  double value() const { return sum / weights; }
};

// How much the mean energy of the second half differs from that of the first, in parts.
template <class Method>
double drift_of_energy(long taken) {
  const Orbit<> planet;
  auto s = planet.start();
  const double first = planet.energy(s.x, s.v);
  SmoothMean early, late;
  measure::run(Method(), planet, s, h, taken, [&](double t, const auto& now) {
    const double change = (planet.energy(now.x, now.v) - first) / std::abs(first);
    const double part = 2 * t / (h * double(taken));
    early.add(change, part);
    late.add(change, part - 1);
  });
  return late.value() - early.value();
}

template <class Method>
double change_of_angular_momentum(double step, long taken) {
  const Orbit<> planet;
  const auto momentum = [&](const auto& x, const auto& v) { return planet.angular_momentum(x, v); };
  return measure::drift(Method(), planet, step, taken, momentum).largest;
}

using Symplectic = list::Where<[](auto method) { return method.symplectic; }>;

// Of the explicit ones; the orbits of order 1 end in the sun or far away.
constexpr auto drifts = [](auto method) {
  return !method.symplectic && method.order > 1 &&
         list::is_in<decltype(method)>(list::EveryExplicit());
};
using NotSymplectic = list::Where<drifts>;

// Each change of the velocity points at the sun from where the planet is. Not so the carried form,
// since what it is seen to have is brought up to date by the pull of a step ago.
using Central = list::Where<[](auto method) { return method.conserves_angular_momentum; }>;
using NotCentral = list::Where<[](auto method) { return !method.conserves_angular_momentum; }>;

}  // namespace

TEMPLATE_LIST_TEST_CASE("In a million steps the energy of a planet does not drift", "",
                        Symplectic) {
  INFO(typeid(TestType).name());
  CHECK(std::abs(drift_of_energy<TestType>(1'000'000)) < rounding(1'000'000));
}

TEMPLATE_LIST_TEST_CASE("In a tenth as many steps the energy of a planet drifts", "",
                        NotSymplectic) {
  INFO(typeid(TestType).name());
  CHECK(std::abs(drift_of_energy<TestType>(100'000)) > 10 * rounding(100'000));
}

TEMPLATE_LIST_TEST_CASE("The angular momentum of a planet is kept to rounding", "", Central) {
  INFO(typeid(TestType).name());
  CHECK(change_of_angular_momentum<TestType>(h, 100'000) < rounding(100'000));
}

TEMPLATE_LIST_TEST_CASE("The angular momentum of a planet is not kept", "", NotCentral) {
  INFO(typeid(TestType).name());
  // Soon after, implicit Euler falls into the sun.
  CHECK(change_of_angular_momentum<TestType>(5 * h, 20) > 1e3 * rounding(20));
}
