// SPDX-License-Identifier: MIT-0
// BDF2 where others are no help: what its start decides, steps that change, nets.
#include "integrate/bdf2.h"

#include <Eigen/Core>
#include <algorithm>
#include <catch2/catch_template_test_macros.hpp>
#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <cmath>
#include <complex>
#include <cstddef>
#include <limits>
#include <numbers>
#include <vector>

#include "frames/recorded.h"
#include "integrate/sparse_system.h"
#include "measure/eigenvalues.h"
#include "measure/methods.h"
#include "measure/run.h"
#include "order_problems.h"
#include "scenes/chain.h"
#include "scenes/cloth.h"
#include "scenes/rope.h"
#include "scenes/spring.h"
#include "theory_of_limits.h"

using Catch::Matchers::WithinAbs;
using Catch::Matchers::WithinRel;
using integrate::Bdf2Previous;
using scenes::Spring;
using scenes::State;
using Complex = std::complex<double>;

namespace {

constexpr double frame = 1.0 / 60;

// Each way to begin says what to remember, and may move the state on by the first step; and by what
// it then has multiplied a motion exp(z t / h) after the first step.
struct ByItsStart {
  static constexpr bool is_a_step = false;
  static Bdf2Previous<double> begin(State<double>& s, double h, const auto& scene) {
    return integrate::bdf2_start(s.x, s.v, 0.0, h, scene);
  }
  static Complex factor(Complex z) { return (1.0 + z / 3.0) / (1.0 - 2.0 * z / 3.0); }
};
struct ByBackwardEuler {
  static constexpr bool is_a_step = true;
  static Bdf2Previous<double> begin(State<double>& s, double h, const auto& scene) {
    const Bdf2Previous<double> previous{s.x, s.v};
    measure::backward_euler(s.x, s.v, 0.0, h, scene);
    return previous;
  }
  static Complex factor(Complex z) { return 1.0 / (1.0 - z); }
};
struct ByTrapezoid {
  static constexpr bool is_a_step = true;
  static Bdf2Previous<double> begin(State<double>& s, double h, const auto& scene) {
    const Bdf2Previous<double> previous{s.x, s.v};
    measure::trapezoid(s.x, s.v, 0.0, h, scene);
    return previous;
  }
  static Complex factor(Complex z) { return (1.0 + z / 2.0) / (1.0 - z / 2.0); }
};

template <class Start, class Scene>
State<double> after(const Scene& scene, double h, int steps) {
  State<double> s = scene.start();
  auto previous = Start::begin(s, h, scene);
  for (int n = Start::is_a_step ? 1 : 0; n < steps; ++n) {
    REQUIRE(integrate::bdf2(s.x, s.v, previous, n * h, h, h, scene, measure::solver_of(scene)));
  }
  return s;
}

// What a second at 60 Hz leaves of the energy of a spring that swings once.
template <class Start>
double left_of_a_slow_spring() {
  const Spring<> spring{.omega = 2 * std::numbers::pi};
  const auto end = after<Start>(spring, frame, 60);
  return spring.energy(end.x, end.v) / spring.energy(spring.x0, spring.v0);
}

// The same by the recurrence 3/2 y - 2 y_1 + 1/2 y_2 = z y of a number.
template <class Start>
double left_by_recurrence() {
  const Complex z(0, 2 * std::numbers::pi * frame);
  Complex before = 1, now = Start::factor(z);
  for (int n = 1; n < 60; ++n) {
    const Complex next = (2.0 * now - 0.5 * before) / (1.5 - z);
    before = now;
    now = next;
  }
  return std::norm(now);
}

// The largest error in position on steps of these lengths, and of the velocity if it is asked for.
template <class Scene>
double largest_error(const Scene& scene, const std::vector<double>& lengths, bool told) {
  auto [x, v] = scene.start();
  double h_previous = lengths[0], t = 0, largest = 0;
  auto previous = integrate::bdf2_start(x, v, t, h_previous, scene);
  for (const double h : lengths) {
    REQUIRE(integrate::bdf2(x, v, previous, t, h, told ? h_previous : h, scene,
                            measure::solver_of(scene)));
    t += h;
    h_previous = h;
    largest = std::max(largest, std::abs(x - scene.exact(t).x));
  }
  return largest;
}

// As often as a finer run takes one of them.
std::vector<double> recorded_frames(int finer) {
  std::vector<double> lengths;
  frames::Playback frames{.at = 60};
  for (int n = 0; n < 60; ++n) {
    lengths.insert(lengths.end(), std::size_t(finer), frames.next() / finer);
  }
  return lengths;
}

// What two steps do to an undamped spring, the second `ratio` times as long as the first, which is
// as much longer than the one before.
double growth_in_two_steps(double h_omega, double ratio) {
  const Spring<> spring{};
  Eigen::Matrix4d both;
  for (int column = 0; column < 4; ++column) {
    Eigen::Vector4d kept = Eigen::Vector4d::Unit(column);
    Bdf2Previous<double> previous{kept[2], kept[3]};
    const double brief = h_omega, lengthy = h_omega * ratio;
    for (const auto& [h, h_previous] : {std::pair{brief, lengthy}, {lengthy, brief}}) {
      REQUIRE(integrate::bdf2(kept[0], kept[1], previous, 0.0, h, h_previous, spring,
                              measure::solver_of(spring)));
    }
    both.col(column) << kept[0], kept[1], previous.x, previous.v;
  }
  return measure::largest_eigenvalue(both);
}

constexpr auto largest = [](const Eigen::VectorXd& change) {
  return change.size() > 0 ? change.cwiseAbs().maxCoeff() : 0.0;
};

template <class Scene>
auto sparse(const Scene& scene) {
  const auto jacobian = [&scene](const auto& x, const auto& v, double t, auto&& add) {
    scene.jacobian(x, v, t, add);
  };
  return integrate::SparseSystem<decltype(jacobian)>(jacobian);
}

}  // namespace

TEMPLATE_TEST_CASE("A second leaves a slow spring what the recurrence leaves of a number", "",
                   ByItsStart, ByBackwardEuler, ByTrapezoid) {
  CHECK_THAT(left_of_a_slow_spring<TestType>(), WithinRel(left_by_recurrence<TestType>(), 1e-12));
}

TEST_CASE("A second of BDF2 leaves 98 to 99.7 per cent of a slow spring, by its start") {
  CHECK_THAT(left_of_a_slow_spring<ByBackwardEuler>(), WithinAbs(0.98, 0.005));
  CHECK_THAT(left_of_a_slow_spring<ByItsStart>(), WithinAbs(0.991, 0.0005));
  CHECK_THAT(left_of_a_slow_spring<ByTrapezoid>(), WithinAbs(0.997, 0.0005));
}

TEST_CASE(
    "The shorter the step that its start makes up, the nearer is the first one to trapezoid") {
  const Spring<> spring{.omega = 7, .zeta = 0.1, .x0 = 0.3, .v0 = -2};
  const double h = 0.1;
  const auto solve = measure::solver_of(spring);
  auto trapezoid = spring.start();
  measure::trapezoid(trapezoid.x, trapezoid.v, 0.0, h, spring);
  double before = 1;
  for (const double h_previous : {h, h / 10, h / 100, h / 1000}) {
    auto [x, v] = spring.start();
    auto previous = integrate::bdf2_start(x, v, 0.0, h_previous, spring);
    REQUIRE(integrate::bdf2(x, v, previous, 0.0, h, h_previous, spring, solve));
    const double apart = std::hypot(x - trapezoid.x, v - trapezoid.v);
    if (h_previous < h / 10) CHECK_THAT(before / apart, WithinAbs(10, 0.5));
    before = apart;
  }
}

TEST_CASE(
    "The first step after its start takes a third of (h omega)^2, backward Euler's all of it") {
  const Spring<> spring{.omega = 7, .x0 = 0.3, .v0 = -2};
  const double w = 0.01, h = w / spring.omega;
  const double first = spring.energy(spring.x0, spring.v0);
  const auto taken = [&](const State<double>& s) {
    return (1 - spring.energy(s.x, s.v) / first) / (w * w);
  };
  CHECK_THAT(taken(after<ByItsStart>(spring, h, 1)), WithinAbs(1 / 3.0, 1e-3));
  CHECK_THAT(taken(after<ByBackwardEuler>(spring, h, 1)), WithinAbs(1, 1e-3));
}

TEMPLATE_TEST_CASE("Begun in any of three ways, BDF2 has order 2 and stills a stiff spring", "",
                   ByItsStart, ByBackwardEuler, ByTrapezoid) {
  const Spring<> slow{.omega = 3, .zeta = 0.1, .x0 = 0.4, .v0 = 1.3};
  const auto error = [&slow](int steps) {
    const auto end = after<TestType>(slow, 0.5 / steps, steps);
    return std::hypot(end.x - slow.exact(0.5).x, end.v - slow.exact(0.5).v);
  };
  for (const int steps : {50, 100, 200}) {
    CHECK_THAT(std::log2(error(steps) / error(2 * steps)), WithinAbs(2, 0.1));
  }
  const Spring<> stiff{.omega = 600, .x0 = 1e-3};
  CHECK(std::abs(after<TestType>(stiff, frame, 10).x) < 1e-5 * stiff.x0);
}

TEST_CASE("In the long run BDF2 takes from a spring what its largest factor takes") {
  for (const double w : {0.1, 0.5, 2.0, 10.0}) {
    const Spring<> spring{.omega = 7, .x0 = 0.3, .v0 = -2};
    const double h = w / spring.omega;
    const auto energy = [&](int steps) {
      const auto end = after<ByItsStart>(spring, h, steps);
      return spring.energy(end.x, end.v);
    };
    const double factor =
        theory::radius(theory::characteristic(measure::Bdf2(), theory::spring(w, 0)));
    CHECK(factor < 1);
    CHECK_THAT(energy(80) / energy(60), WithinRel(std::pow(factor, 40), 1e-6));
  }
}

TEST_CASE("On frames as they come BDF2 has order 2, and one if it isn't told their lengths") {
  const Spring<> spring{.omega = 3, .zeta = 0.2, .x0 = 0.4, .v0 = 1.3};
  for (const int finer : {4, 8, 16}) {
    const auto coarse = recorded_frames(finer), fine = recorded_frames(2 * finer);
    const auto order = [&](bool told) {
      return std::log2(largest_error(spring, coarse, told) / largest_error(spring, fine, told));
    };
    CHECK_THAT(order(true), WithinAbs(2, 0.1));
    CHECK(order(false) < 1.5);
  }
}

TEST_CASE("Steps that alternate between one length and up to ten times as much hold any spring") {
  for (double h_omega = 0.03; h_omega < 1e4; h_omega *= 1.3) {
    CAPTURE(h_omega);
    for (const double ratio : {1.0, 1.2, 2.0, 3.5, 10.0}) {
      CAPTURE(ratio);
      CHECK(growth_in_two_steps(h_omega, ratio) < 1);
    }
  }
}

TEST_CASE("Frames as they come never give an undamped spring more than it began with") {
  for (double omega = 0.5; omega < 1e5; omega *= 1.7) {
    CAPTURE(omega);
    const Spring<> spring{.omega = omega, .x0 = 0.3, .v0 = -2};
    auto [x, v] = spring.start();
    const double first = spring.energy(x, v);
    frames::Playback frames{.at = 0};
    double h_previous = frame;
    auto previous = integrate::bdf2_start(x, v, 0.0, h_previous, spring);
    for (int n = 0; n < 600; ++n) {
      const double h = frames.next();
      REQUIRE(
          integrate::bdf2(x, v, previous, 0.0, h, h_previous, spring, measure::solver_of(spring)));
      h_previous = h;
      CHECK(spring.energy(x, v) < (1 + 1e-12) * first);
    }
  }
}

TEST_CASE("On coarse steps a float's error is a double's") {
  const auto problem = order::driven<double>(0.45);
  const auto in_float = order::driven<float>(0.45f);
  for (const int steps : {10, 20}) {
    double error[2] = {0, 0};
    State<double> s{problem.start};
    auto kept = measure::start(measure::bdf2, s, 0.45 / steps, problem.scene);
    auto kept_float =
        measure::start(measure::bdf2, in_float.start, 0.45f / float(steps), problem.scene);
    for (int n = 0; n < 8 * steps; ++n) {
      measure::advance(measure::bdf2, kept, n * 0.45 / steps, 0.45 / steps, problem.scene);
      measure::advance(measure::bdf2, kept_float, float(n) * 0.45f / float(steps),
                       0.45f / float(steps), problem.scene);
      if ((n + 1) % steps != 0) continue;
      const double truth = problem.truth[std::size_t((n + 1) / steps - 1)].x;
      error[0] = std::max(error[0], std::abs(kept[0] - truth));
      error[1] = std::max(error[1], std::abs(double(kept_float[0]) - truth));
    }
    CHECK(error[0] > 1e-4);
    // Each step rounds a few numbers below two, and the sums of a second difference a few more.
    const double rounding = 64.0 * steps * double(std::numeric_limits<float>::epsilon());
    CHECK_THAT(error[1], WithinAbs(error[0], rounding));
  }
}

TEST_CASE("A chain in its slowest motion swings as the formula says, to order 2, by SparseSystem") {
  const scenes::Chain<> chain{.count = 40, .mass = 0.5, .k = 2000};
  const double omega = chain.frequency(1);
  Eigen::VectorXd mode(chain.count);
  for (int i = 0; i < chain.count; ++i) {
    mode[i] = std::sin((i + 1) * std::numbers::pi / (2 * chain.count + 1));
  }
  auto system = sparse(chain);
  const auto error = [&](int steps) {
    const double h = 1.5 / steps;
    Eigen::VectorXd x = mode, v = Eigen::VectorXd::Zero(chain.count);
    auto previous = integrate::bdf2_start(x, v, 0.0, h, chain);
    for (int n = 0; n < steps; ++n) {
      REQUIRE(integrate::bdf2(x, v, previous, n * h, h, h, chain, system));
    }
    return (x - std::cos(1.5 * omega) * mode).norm();
  };
  for (const int steps : {100, 200}) {
    CHECK_THAT(std::log2(error(steps) / error(2 * steps)), WithinAbs(2, 0.1));
  }
}

TEST_CASE("Rope and cloth, let go level, never have more energy than they were given") {
  const auto check = [](const auto& scene) {
    auto system = sparse(scene);
    auto [x, v] = scene.start();
    const double weight = scene.nodes() * scene.mass * scene.g;  // times a metre of fall, an energy
    double t = 0, h_previous = frame;
    auto previous = integrate::bdf2_start(x, v, t, h_previous, scene);
    for (int n = 0; n < 180; ++n) {
      const double h = n % 3 == 0 ? frame / 2 : frame;
      REQUIRE(integrate::bdf2_newton(x, v, previous, t, h, h_previous, scene, system, largest,
                                     1e-9) > 0);
      t += h;
      h_previous = h;
      CHECK(scene.energy(x, v) < 1e-3 * weight);
    }
    CHECK(scene.energy(x, v) < -0.1 * weight);
  };
  check(scenes::Rope<>{.count = 21});
  check(scenes::Cloth<>{.side = 6});
}
