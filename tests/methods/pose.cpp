// SPDX-License-Identifier: MIT-0
// Places and velocities of two types: poses that are moved by twists. Turns don't commute, so that
// some methods have another order there than on vectors.
#include <Eigen/Geometry>
#include <catch2/catch_test_macros.hpp>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iterator>
#include <map>
#include <regex>
#include <string>

#include "integrate/dopri5.h"
#include "integrate/leapfrog.h"
#include "integrate/velocity_verlet.h"
#include "integrate/yoshida4.h"
#include "measure/methods.h"

namespace {

using Eigen::Quaterniond;
using Eigen::Vector3d;

// A velocity and a spin; or an acceleration and what changes the spin.
struct Twist {
  Vector3d along, about;
};
Twist operator+(const Twist& p, const Twist& q) {
  return {p.along + q.along, p.about + q.about};
}
Twist operator*(double s, const Twist& p) {
  return {s * p.along, s * p.about};
}

// Lengths that no length can be added to, and speeds: a step must not mix them up.
struct Speed {
  double metres_a_second;
};
constexpr Speed operator+(Speed p, Speed q) {
  return {p.metres_a_second + q.metres_a_second};
}
constexpr Speed operator*(double s, Speed p) {
  return {s * p.metres_a_second};
}
struct Length {
  double metres;
};
constexpr Length operator+(Length p, Speed way) {
  return {p.metres + way.metres_a_second};
}

// Where a thing is, and how it is turned. No two of them can be added.
struct Pose {
  Vector3d at;
  Quaterniond turned;
};
Pose operator+(const Pose& pose, const Twist& way) {
  const double angle = way.about.norm();
  const Vector3d axis = angle > 0 ? Vector3d(way.about / angle) : Vector3d::UnitX();
  return {pose.at + way.along, Quaterniond(Eigen::AngleAxisd(angle, axis)) * pose.turned};
}

// A ball with two needles in it, each drawn to a direction of its own, on a spring.
struct Pull {
  static constexpr double damping() { return 0; }
  Twist operator()(const Pose& pose, const Twist&, double) const {
    const Vector3d first = pose.turned * Vector3d::UnitX();
    const Vector3d second = pose.turned * Vector3d::UnitY();
    const Vector3d about =
        4 * first.cross(Vector3d(0.2, 0.9, 0.3)) + 3 * second.cross(Vector3d(0.8, -0.1, 0.5));
    return {-4 * pose.at + first, about};
  }
};
constexpr Pull pull;

struct Start {
  Pose x{{1, 0, 0}, Quaterniond::Identity()};
  Twist v{{0, 1, 0}, {0.5, 1, 2}};
};

constexpr double duration = 2;

// The pose after the same time in so many steps.
using Run = std::function<Pose(int)>;

template <class Step>
Run without_memory(Step step) {
  return [step](int steps) {
    auto [x, v] = Start();
    const double h = duration / steps;
    for (int n = 0; n < steps; ++n) step(x, v, n * h, h);
    return x;
  };
}

// With the acceleration kept from step to step.
template <class Step>
Run with_acceleration(Step step) {
  return [step](int steps) {
    auto [x, v] = Start();
    Twist a = pull(x, v, 0);
    const double h = duration / steps;
    for (int n = 0; n < steps; ++n) step(x, v, a, n * h, h);
    return x;
  };
}

Pose leapfrog(int steps) {
  auto [x, v] = Start();
  const double h = duration / steps;
  Twist v_half = integrate::leapfrog_start(x, v, 0.0, h, pull);
  for (int n = 0; n < steps; ++n) integrate::leapfrog(x, v_half, n * h, h, pull);
  return x;
}

// One that keeps the acceleration.
#define KEEPING(name)        \
  {#name, with_acceleration( \
              [](auto& x, auto& v, auto& a, double t, double h) { name(x, v, a, t, h, pull); })}

// By the name of the function; those that keep nothing from step to step as the lists have them.
std::map<std::string, Run> runs() {
  using namespace integrate;
  std::map<std::string, Run> all{
      {"leapfrog", leapfrog}, KEEPING(velocity_verlet), KEEPING(yoshida4), KEEPING(dopri5)};
  list::for_each(
      list::Joined<list::EveryExplicit, list::EveryDamping>(), [&]<class Method>(Method) {
        if constexpr (std::is_invocable_v<Method, Pose&, Twist&, double, double, const Pull&>) {
          all[std::string(Method::function)] = without_memory(
              [](auto& x, auto& v, double t, double h) { Method()(x, v, t, h, pull); });
        }
      });
  return all;
}

double apart(const Pose& p, const Pose& q) {
  return (p.at - q.at).norm() + p.turned.angularDistance(q.turned);
}

// What is left of the difference between two runs, if the step is halved again.
double order(const Run& run) {
  const Pose coarse = run(256), middle = run(512), fine = run(1024);
  return std::log2(apart(coarse, middle) / apart(middle, fine));
}

// Of each function that moves a Position, the order that its comment promises on poses; none if it
// promises nothing.
std::map<std::string, std::string> promised() {
  std::map<std::string, std::string> orders;
  const std::regex function(
      R"(((?:///.*\n)+)(?:#ifdef[^#]*#endif\n\n)?template <class Position.*\n.*?(\w+)\(Position& x,)");
  for (const auto& entry : std::filesystem::directory_iterator(INTEGRATE_FOLDER)) {
    std::ifstream file(entry.path());
    const std::string text{std::istreambuf_iterator<char>(file), {}};
    for (std::sregex_iterator at(text.begin(), text.end(), function), end; at != end; ++at) {
      const std::string words = std::regex_replace((*at)[1].str(), std::regex("\\s*///\\s*"), " ");
      std::smatch found;
      std::regex_search(words, found, std::regex("On poses, order (\\d)\\."));
      orders[(*at)[2]] = found[1];
    }
  }
  return orders;
}

}  // namespace

TEST_CASE("On poses each method has the order that its header promises") {
  const auto all = runs();
  const auto promises = promised();
  CHECK(promises.size() == all.size());
  for (const auto& [name, promise] : promises) {
    CAPTURE(name, promise);
    REQUIRE(all.contains(name));
    CHECK(std::abs(order(all.at(name)) - std::stod(promise)) < 0.1);
  }
}

TEST_CASE("A pose that only turns comes round in sixty steps of a sixtieth of a turn") {
  Pose x{{1, 0, 0}, Quaterniond::Identity()};
  Twist v{{0, 0, 1}, {0, 2 * double(EIGEN_PI), 0}};
  const auto free = [](const Pose&, const Twist&, double) {
    return Twist{Vector3d::Zero(), Vector3d::Zero()};
  };
  for (int n = 0; n < 60; ++n) integrate::symplectic_euler(x, v, n / 60.0, 1 / 60.0, free);
  CHECK((x.at - Vector3d(1, 0, 1)).norm() < 1e-14);
  CHECK(std::abs(x.turned.w() + 1) < 1e-14);  // once round is minus one
}

TEST_CASE("Strong lengths and speeds take the steps of numbers") {
  const auto number = [](double x, double v, double) { return -9 * x - v; };
  const auto strong = [](Length x, Speed v, double) {
    return Speed{-9 * x.metres - v.metres_a_second};
  };
  const auto same = [&](auto step) {
    double x = 1, v = 0.5;
    Length length{1};
    Speed speed{0.5};
    for (int n = 0; n < 60; ++n) {
      step(x, v, n / 60.0, number);
      step(length, speed, n / 60.0, strong);
    }
    return x != 1 && length.metres == x && speed.metres_a_second == v;
  };
  const double h = 1 / 60.0;
  CHECK(same(
      [h](auto& x, auto& v, double t, auto& a) { integrate::symplectic_euler(x, v, t, h, a); }));
  CHECK(same([h](auto& x, auto& v, double t, auto& a) { integrate::rk4(x, v, t, h, a); }));
  CHECK(same([h](auto& x, auto& v, double t, auto& a) {
    auto memory = integrate::yoshida4_start(x, v, t, a);
    integrate::yoshida4(x, v, memory, t, h, a);
  }));
}

TEST_CASE("Far from the origin a place of doubles keeps what a velocity of floats adds") {
  const auto coast = [](double, float, double) { return 0.0f; };
  double x = 1e6;
  float v = 0.5f;
  for (int n = 0; n < 3600; ++n) integrate::symplectic_euler(x, v, n / 60.0, 1 / 64.0f, coast);
  CHECK(x == 1e6 + 0.5 * 3600 / 64);
}
