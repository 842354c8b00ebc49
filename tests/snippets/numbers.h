// SPDX-License-Identifier: MIT-0
// The numbers that a header of the shelf gives on some kind of vector, beside those on plain
// doubles.
#pragma once
#include <cmath>
#include <cstdio>
#include <limits>
#include <vector>

// The numbers that were found, in the order in which they came.
struct Numbers {
  std::vector<double> all;

  void add(double number) { all.push_back(number); }
};

// The least that a header may ask of a vector.
struct PlainVector {
  double x, y, z;
};
constexpr PlainVector operator+(PlainVector p, PlainVector q) {
  return {p.x + q.x, p.y + q.y, p.z + q.z};
}
constexpr PlainVector operator*(double s, PlainVector p) {
  return {s * p.x, s * p.y, s * p.z};
}

// With two coordinates, z is always zero.
template <int coordinates>
struct DoublesOf {
  using Vec = PlainVector;
  using Real = double;
  static constexpr int size = coordinates;
  static constexpr const char* name = "a plain struct of doubles";
  static Vec make(const Real* from) { return {from[0], from[1], size > 2 ? from[2] : 0}; }
  static Real read(const Vec& x, int i) { return i == 0 ? x.x : i == 1 ? x.y : x.z; }
};

using Doubles = DoublesOf<3>;

// Of any kind, by its numbers.
template <class Kind>
struct Dot {
  using Vec = typename Kind::Vec;
  typename Kind::Real operator()(const Vec& p, const Vec& q) const {
    typename Kind::Real sum = 0;
    for (int i = 0; i < Kind::size; ++i) sum += Kind::read(p, i) * Kind::read(q, i);
    return sum;
  }
};

template <class Kind>
struct Length {
  typename Kind::Real operator()(const typename Kind::Vec& p) const {
    return std::sqrt(Dot<Kind>()(p, p));
  }
};

template <class Kind>
void add_all(Numbers& found, const typename Kind::Vec& x) {
  for (int i = 0; i < Kind::size; ++i) found.add(double(Kind::read(x, i)));
}

// How many of the numbers of a header on some kind of vector are others than those on doubles.
template <class Kind, class Call>
int differences(const char* header, Call call) {
  Numbers wanted, found;
  call(DoublesOf<Kind::size>(), wanted);
  call(Kind(), found);
  const double rounding = 256 * double(std::numeric_limits<typename Kind::Real>::epsilon());
  int wrong = wanted.all.empty() || wanted.all.size() != found.all.size();
  for (std::size_t i = 0; i < wanted.all.size() && !wrong; ++i) {
    const double size = std::abs(wanted.all[i]), allowed = rounding * (size > 1 ? size : 1);
    if (std::abs(wanted.all[i] - found.all[i]) <= allowed) continue;
    ++wrong;
    std::printf("%s.h on %s, number %d: %.17g; on doubles %.17g\n", header, Kind::name, int(i) + 1,
                found.all[i], wanted.all[i]);
  }
  return wrong;
}
