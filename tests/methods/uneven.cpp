// SPDX-License-Identifier: MIT-0
// Position Verlet on steps that change: with the form for it, and with the one that takes no
// notice.
#include <algorithm>
#include <catch2/catch_template_test_macros.hpp>
#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <cmath>
#include <limits>
#include <vector>

#include "frames/recorded.h"
#include "integrate/stormer_verlet.h"
#include "scenes/linear_drag.h"
#include "scenes/spring.h"

using Catch::Matchers::WithinAbs;
using scenes::LinearDrag;
using scenes::Spring;

namespace {

// One step after the other of these lengths; a finer run has more of them in the same time.
struct Alternating {
  static std::vector<double> steps(int finer) {
    std::vector<double> lengths;
    for (int n = 0; n < 40 * finer; ++n) lengths.push_back((n % 2 + 1) / (60.0 * finer));
    return lengths;
  }
};
struct Frames {
  static std::vector<double> steps(int finer) {
    std::vector<double> lengths;
    frames::Playback frames{.at = 60};
    for (int n = 0; n < 60; ++n)
      lengths.insert(lengths.end(), std::size_t(finer), frames.next() / finer);
    return lengths;
  }
};

// The largest error in position, of steps of these lengths.
template <class Step, class Scene>
double largest_error(const Step& step, const Scene& scene, const std::vector<double>& lengths) {
  auto [x, v] = scene.start();
  double h_previous = lengths[0];
  double x_previous = integrate::stormer_verlet_start(x, v, 0.0, h_previous, scene);
  double t = 0, largest = 0;
  for (const double h : lengths) {
    step(x, x_previous, t, h, h_previous, scene);
    t += h;
    h_previous = h;
    largest = std::max(largest, std::abs(x - scene.exact(t).x));
  }
  return largest;
}

const auto uneven = [](double& x, double& x_previous, double t, double h, double h_previous,
                       const auto& scene) {
  integrate::stormer_verlet_uneven(x, x_previous, t, h, h_previous, scene);
};
const auto plain = [](double& x, double& x_previous, double t, double h, double,
                      const auto& scene) { integrate::stormer_verlet(x, x_previous, t, h, scene); };

constexpr Spring<> spring{.omega = 3, .x0 = 0.4, .v0 = 1.3};

}  // namespace

TEMPLATE_TEST_CASE("Under constant force uneven position Verlet is exact, plain is metres off", "",
                   Alternating, Frames) {
  const LinearDrag<> fall{.c = 0, .v0 = 20};
  for (const int finer : {1, 4}) {
    const auto lengths = TestType::steps(finer);
    // Rounding of x makes one of x / h in the velocity, which moves all later positions.
    const auto n = double(lengths.size());
    const double rounding = 20 * n * n * std::numeric_limits<double>::epsilon();
    CHECK(largest_error(uneven, fall, lengths) < rounding);
    CHECK(largest_error(plain, fall, lengths) > 1);
  }
}

TEMPLATE_TEST_CASE("On a spring uneven position Verlet has order 2, plain has none", "",
                   Alternating, Frames) {
  for (const int finer : {4, 8, 16}) {
    CAPTURE(finer);
    const auto coarse = TestType::steps(finer), fine = TestType::steps(2 * finer);
    const auto order = [&](const auto& step) {
      return std::log2(largest_error(step, spring, coarse) / largest_error(step, spring, fine));
    };
    CHECK_THAT(order(uneven), WithinAbs(2, 0.1));
    CHECK_THAT(order(plain), WithinAbs(0, 0.1));
    CHECK(largest_error(plain, spring, fine) > 0.1);
  }
}

TEST_CASE("With equal steps uneven position Verlet is the plain one") {
  const double h = 1.0 / 60;
  double x = 0.4, x_previous = 0.39, plain_x = x, plain_previous = x_previous;
  for (int n = 0; n < 100; ++n) {
    uneven(x, x_previous, n * h, h, h, spring);
    plain(plain_x, plain_previous, n * h, h, h, spring);
    // As often rounded, and each time moved on by the steps that are left.
    CHECK_THAT(x, WithinAbs(plain_x, 100 * 100 * std::numeric_limits<double>::epsilon()));
  }
}
