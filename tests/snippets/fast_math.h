// SPDX-License-Identifier: MIT-0
// What -ffast-math leaves of the headers, which come first: steps that are right but for rounding,
// and the promises about numbers that are not finite, though the compiler takes every number for
// finite. The bad ones are made of bits, so that it cannot see them coming.
#pragma once
#include <cstdint>
#include <cstring>
#include <vector>

#include "same_steps.h"

inline int wrong = 0;

inline void check(bool right, const char* what, int line) {
  if (right) return;
  std::printf("line %d: %s\n", line, what);
  ++wrong;
}
#define CHECK(right) check(right, #right, __LINE__)

template <class Real>
struct Bad;
template <>
struct Bad<double> {
  using Bits = std::uint64_t;
  static constexpr Bits numbers[] = {0x7ff8000000000000, 0xfff8000000000000, 0x7ff0000000000001,
                                     0x7ff0000000000000, 0xfff0000000000000};
};
template <>
struct Bad<float> {
  using Bits = std::uint32_t;
  static constexpr Bits numbers[] = {0x7fc00000, 0xffc00000, 0x7f800001, 0x7f800000, 0xff800000};
};

// Three that are not numbers, and the two infinities.
template <class Real>
Real bad(int which) {
  volatile auto hidden = Bad<Real>::numbers[which];
  const auto bits = hidden;
  Real number;
  std::memcpy(&number, &bits, sizeof number);
  return number;
}

template <class Real>
Real size(Real x) {
  return std::abs(x);
}

template <class Real, class Force>
bool arrives(Force force, Real duration, Real& x, Real& v) {
  Real h = Real(0.1);
  return integrate::dopri5_adaptive(x, v, 0.0, duration, h, force, size<Real>, Real(1e-5));
}

template <class Real, class Force>
bool moves_nothing(Force force, Real duration = 2) {
  Real x = 1, v = Real(-0.5);
  return !arrives(force, duration, x, v) && x == 1 && v == Real(-0.5);
}

// A path, too, goes no farther than it can.
template <class Real, class Force>
bool path_ends(Force force, double t = 2) {
  auto path = integrate::dopri5_path(Real(1), Real(-0.5), 0.0, Real(0.1), force);
  return !integrate::dopri5_adaptive(path, t, force, size<Real>, Real(1e-5)) && path.t < 0.6 &&
         path.x > 0 && path.x <= 1;
}

template <class Real>
void adaptive() {
  Real x = 1, v = 0;
  CHECK(arrives([](Real at, Real, double) { return -at; }, Real(1), x, v));
  CHECK(std::abs(x - std::cos(Real(1))) < Real(1e-4));
  for (int which = 0; which < 5; ++which) {
    const Real b = bad<Real>(which);
    CHECK(moves_nothing<Real>([b](Real, Real, double) { return b; }));
    CHECK(moves_nothing<Real>([b](Real at, Real, double t) { return t > 0.5 ? b : -at; }));
    int asked = 0;
    CHECK(moves_nothing<Real>([b, &asked](Real at, Real, double) { return ++asked >= 7 ? b : -at; },
                              Real(0.01)));
    if (which < 3) CHECK(moves_nothing<Real>([](Real at, Real, double) { return -at; }, b));
    CHECK(path_ends<Real>([b](Real, Real, double) { return b; }));
    CHECK(path_ends<Real>([b](Real at, Real, double t) { return t > 0.5 ? b : -at; }));
    CHECK(path_ends<Real>([](Real at, Real, double) { return -at; }, bad<double>(which)));
  }
  CHECK(moves_nothing<Real>([](Real at, Real, double) { return -1 / (at * at); }));
}

template <class Real>
struct Entry {
  int row, column;
  Real dadx;
};

template <class Real>
struct Entries {
  const std::vector<Entry<Real>>* all;
  template <class Vec, class Add>
  void operator()(const Vec&, const Vec&, double, Add&& add) const {
    for (const Entry<Real>& each : *all) add(each.row, each.column, each.dadx, Real(0));
  }
};

// Three unknowns, with one number after the other replaced.
template <class Real, class System>
void system_refuses() {
  using Vec = typename System::Vec;
  std::vector<Entry<Real>> entries{{0, 0, -1}, {0, 1, Real(0.5)},  {1, 0, Real(0.5)}, {1, 1, -1},
                                   {2, 2, -1}, {1, 2, Real(0.25)}, {2, 1, Real(0.25)}};
  System system{Entries<Real>{&entries}};
  const Vec zero = Vec::Zero(3), ones = Vec::Ones(3);
  const auto solves = [&](Vec right) { return system(zero, zero, 0.0, Real(-1), Real(0), right); };
  Vec y = ones;
  CHECK(system(zero, zero, 0.0, Real(-1), Real(0), y));
  CHECK(std::abs(2 * y[0] - y[1] / 2 - 1) < Real(1e-5));
  for (int which = 0; which < 5; ++which) {
    for (Entry<Real>& each : entries) {
      const Real before = each.dadx;
      each.dadx = bad<Real>(which);
      CHECK(!solves(ones));
      each.dadx = before;
      CHECK(solves(ones));
    }
    for (int i = 0; i < 3; ++i) {
      Vec right = ones;
      right[i] = bad<Real>(which);
      CHECK(!solves(right));
    }
    // Newton's method has no other guard than the system's verdict.
    const auto force = [which](const Vec& x, const Vec&, double) {
      return Vec(Vec::Constant(x.size(), bad<Real>(which)));
    };
    const auto norm = [](const Vec& change) { return change.norm(); };
    Vec x = ones, v = ones;
    CHECK(!integrate::backward_euler(x, v, 0.0, Real(1), force, system));
    CHECK(!integrate::trapezoid(x, v, 0.0, Real(1), force, system));
    CHECK(!integrate::backward_euler_newton(x, v, 0.0, Real(1), force, system, norm, Real(1e-3)));
    CHECK(!integrate::trapezoid_newton(x, v, 0.0, Real(1), force, system, norm, Real(1e-3)));
    integrate::Bdf2Previous<Vec> previous{ones, ones};
    CHECK(!integrate::bdf2(x, v, previous, 0.0, Real(1), Real(1), force, system));
    CHECK(!integrate::bdf2_newton(x, v, previous, 0.0, Real(1), Real(1), force, system, norm,
                                  Real(1e-3)));
    CHECK(x == ones && v == ones && previous.x == ones && previous.v == ones);
  }
}

// From numbers that are finite to a pivot that is not: 1e200 times 1e200 is too much.
inline void overflow() {
  const std::vector<Entry<double>> entries{{0, 1, 1e200}, {1, 0, 1e200}};
  integrate::BandSystem<1, Entries<double>> system(Entries<double>{&entries});
  const Eigen::VectorXd zero = Eigen::VectorXd::Zero(2);
  Eigen::VectorXd right = Eigen::VectorXd::Ones(2);
  CHECK(!system(zero, zero, 0.0, -1.0, 0.0, right));
}

inline int broken_promises() {
  adaptive<double>();
  adaptive<float>();
  using D = Entries<double>;
  using F = Entries<float>;
  system_refuses<double, integrate::DenseSystem<D>>();
  system_refuses<double, integrate::DenseSystem<D, double, 3>>();
  system_refuses<float, integrate::DenseSystem<F, float>>();
  system_refuses<double, integrate::BandSystem<1, D>>();
  system_refuses<float, integrate::BandSystem<2, F, float>>();
  system_refuses<double, integrate::SparseSystem<D>>();
  system_refuses<float, integrate::SparseSystem<F, float>>();
  overflow();
  return wrong;
}

struct Attempt {
  int wrong = broken_promises();

  template <class Method>
  void operator()(const char* name, Method method) {
    wrong += numbers_wrong(name, method);
  }
};
