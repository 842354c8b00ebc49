// SPDX-License-Identifier: MIT-0
// Numbers that no game means to have, and what to try with them.
#pragma once
#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <functional>
#include <limits>
#include <random>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <vector>

#include "shelf/orientation.h"

namespace fuzz {

/// Two numbers: a vector with no more than the headers may ask for.
template <class Real>
struct Two {
  Real x, y;
  friend constexpr Two operator+(Two a, Two b) { return {a.x + b.x, a.y + b.y}; }
  friend constexpr Two operator*(Real s, Two a) { return {s * a.x, s * a.y}; }
};

template <class Real>
Real dot(Two<Real> a, Two<Real> b) {
  return a.x * b.x + a.y * b.y;
}
inline float dot(float a, float b) {
  return a * b;
}
inline double dot(double a, double b) {
  return a * b;
}

inline constexpr auto product = [](const auto& a, const auto& b) { return dot(a, b); };
inline constexpr auto length = [](const auto& a) { return std::sqrt(dot(a, a)); };

/// What a promise is broken with.
inline void require(bool kept, const char* promise) {
  if (!kept) throw std::runtime_error(promise);
}

/// Whether two numbers or vectors are the same to the bit, one that is not a number included.
template <class Value>
bool same(const Value& a, const Value& b) {
  return std::memcmp(&a, &b, sizeof a) == 0;
}

template <class Real>
bool finite(Real number) {
  return std::isfinite(number);
}
template <class Real>
bool finite(Two<Real> a) {
  return std::isfinite(a.x) && std::isfinite(a.y);
}
template <class Real>
bool finite(const shelf::Vec3<Real>& a) {
  return std::isfinite(a.x) && std::isfinite(a.y) && std::isfinite(a.z);
}

/// Numbers for one input. In some inputs all of them are tame, in some wild, and in most a few.
class Source {
 public:
  explicit Source(std::uint64_t seed) : random_(seed) {
    constexpr std::array shares{0.0, 0.0, 0.05, 0.2, 0.6, 1.0};
    wild_ = shares[random_() % shares.size()];
  }

  /// Whether this input has only the numbers that a promise is made for.
  bool tame() const { return wild_ == 0; }

  int whole(int from, int to) { return from + int(random_() % unsigned(to - from + 1)); }
  double share() { return double(random_() >> 11) * 0x1p-53; }

  /// Any number if the input is wild, else one of a game, zeros and round numbers often among them.
  template <class Real>
  Real number() {
    using Limits = std::numeric_limits<Real>;
    const Real sign = random_() % 2 ? Real(1) : Real(-1);
    if (share() >= wild_) {
      const Real round = Real(whole(0, 2)) / Real(2);
      if (whole(0, 3) == 0) return round == Real(0) ? round : sign * round;  // -0 is wild
      return sign * Real(std::pow(10, -4 + 7 * share()));
    }
    const Real odd[] = {Limits::quiet_NaN(),  Limits::infinity(),       Real(0),
                        Limits::denorm_min(), 3 * Limits::denorm_min(), Limits::min(),
                        Limits::min() / 16,   Limits::epsilon(),        Real(1),
                        Limits::max(),        std::sqrt(Limits::max())};
    if (whole(0, 1) == 0) return sign * odd[whole(0, 10)];
    const double range = Limits::max_exponent - Limits::min_exponent;
    return sign * Real(std::exp2(Limits::min_exponent + share() * range));
  }

  /// A number that is not negative if the input is tame.
  template <class Real>
  Real size() {
    const Real any = number<Real>();
    return any < Real(0) && (tame() || whole(0, 3) > 0) ? -any : any;
  }

  /// One that is above zero if the input is tame.
  template <class Real>
  Real above() {
    const Real any = size<Real>();
    return tame() && any == Real(0) ? Real(0.5) : any;
  }

  template <class Vec>
  Vec vector() {
    if constexpr (std::is_floating_point_v<Vec>) {
      return number<Vec>();
    } else if constexpr (requires(Vec v) { v.z; }) {
      using Real = typename Vec::Number;
      return Vec{number<Real>(), number<Real>(), number<Real>()};
    } else {
      using Real = decltype(Vec().x);
      return Vec{number<Real>(), number<Real>()};
    }
  }

  /// One of length 1 if the input is tame.
  template <class Vec>
  Vec direction() {
    Vec way = vector<Vec>();
    if (!tame()) return way;
    while (!(length(way) > 0)) way = vector<Vec>();
    return (1 / length(way)) * way;
  }

 private:
  std::mt19937_64 random_;
  double wild_;
};

/// A force of place, velocity and time, which counts how often it is asked.
template <class Vec, class Real>
struct Force {
  Real k, c, drive;
  Vec along;
  long long asked = 0;

  explicit Force(Source& source)
      : k(source.number<Real>()),
        c(source.number<Real>()),
        drive(source.number<Real>()),
        along(source.vector<Vec>()) {}

  template <class Time>
  Vec operator()(const Vec& x, const Vec& v, Time t) {
    ++asked;
    return (Real(-1) * k) * x + (Real(-1) * c) * v + (drive * Real(t)) * along;
  }
};

/// What is tried with one input after the other.
struct Case {
  std::string header, name;
  std::function<void(Source&)> once;
};
using Cases = std::vector<Case>;

/// The same on numbers, and on vectors of two and of three: `tried` is a lambda over the type of
/// the vector and that of its numbers, called with a source.
template <class Tried>
void add(Cases& cases, const std::string& header, const std::string& name, Tried tried) {
  const auto on = [&]<class Vec, class Real>(const char* kind) {
    cases.push_back({header, name + " on " + kind,
                     [tried](Source& source) { tried.template operator()<Vec, Real>(source); }});
  };
  on.template operator()<float, float>("floats");
  on.template operator()<double, double>("doubles");
  on.template operator()<Two<float>, float>("pairs of floats");
  on.template operator()<shelf::Vec3<double>, double>("triples of doubles");
}

/// What has no vectors: `tried` is a lambda over the type of its numbers.
template <class Tried>
void add_numbers(Cases& cases, const std::string& header, const std::string& name, Tried tried) {
  cases.push_back({header, name + " on floats",
                   [tried](Source& source) { tried.template operator()<float>(source); }});
  cases.push_back({header, name + " on doubles",
                   [tried](Source& source) { tried.template operator()<double>(source); }});
}

Cases methods();
Cases implicit_methods();
Cases systems();
Cases adaptive();
Cases springs();
Cases bounces();
Cases links();
Cases followers();
Cases bodies();

}  // namespace fuzz
