// SPDX-License-Identifier: MIT-0
#include "shelf/damper.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "measure/shelf_card.h"

namespace measure::shelf_cards {
namespace {

constexpr double epsilon = std::numeric_limits<double>::epsilon();
constexpr double h = 1 / 60.0;

struct Two {
  double v1, v2, w1, w2, pull;  // the damper's c, times the step

  void damp() { shelf::damper(v1, v2, h, pull / h, w1, w2); }
  long double parting() const { return (long double)v2 - v1; }
  long double momentum() const { return v1 / (long double)w1 + v2 / (long double)w2; }
  long double momenta() const {
    return std::abs(v1) / (long double)w1 + std::abs(v2) / (long double)w2;
  }
};

// Two bodies of 1 g to 1 t, from weak dampers to locks.
template <class Visit>
void for_each_two(Visit visit) {
  for (const double w1 : {1e3, 30.0, 1.0, 0.07, 1e-3}) {
    for (const double w2 : {1e3, 7.0, 1.0, 0.3, 1e-3}) {
      for (const double pull : {1e-6, 1e-3, 0.3, 1.0, 70.0, 1e6}) {
        for (const double v1 : {-7.1, 0.3, 12.7}) visit(Two{v1, 3.3, w1, w2, pull});
      }
    }
  }
}

Promise divided() {
  long double off = 0;
  for_each_two([&](Two two) {
    const double speeds = std::abs(two.v1) + std::abs(two.v2);
    const long double wanted =
        two.parting() / (1 + (long double)h * (two.pull / h) * ((long double)two.w1 + two.w2));
    two.damp();
    off = std::max(off, std::abs(two.parting() - wanted) / speeds);
  });
  const double roundings = double(off) / epsilon;
  return {
      "the speed of parting is divided by 1 + h c (1/m1 + 1/m2), to 4 roundings of the speeds, "
      "for masses from 1 g to 1 t",
      roundings < 4, roundings, 2, "roundings"};
}

Promise momentum() {
  long double off = 0;
  for_each_two([&](Two two) {
    const long double before = two.momentum(), all = two.momenta();
    two.damp();
    off = std::max(off, std::abs(two.momentum() - before) / all);
  });
  const double roundings = double(off) / epsilon;
  return {"momentum is kept, to 2 roundings of m1 |v1| + m2 |v2|", roundings < 2, roundings, 2,
          "roundings"};
}

Promise no_turning() {
  double back = 0;
  for_each_two([&](Two two) {
    for (const double pull : {1e9, 1e20, 1e30}) {
      Two locked = two;
      locked.pull = pull;
      locked.damp();
      const bool turned = (locked.parting() > 0) != (two.parting() > 0);
      const double speeds = std::abs(two.v1) + std::abs(two.v2);
      if (turned) back = std::max(back, std::abs(double(locked.parting())) / speeds / epsilon);
    }
  });
  return {
      "however large h c is, up to 10^30 kg, the two never part the other way, but for "
      "2 roundings of the speeds",
      back <= 2, back, 2, "roundings"};
}

Promise immovable() {
  int moved = 0;
  for_each_two([&](Two two) {
    const double before = two.v1;
    two.w1 = 0;
    two.damp();
    moved += two.v1 != before;
  });
  return {"a body of inverse mass 0 keeps its velocity to the bit", moved == 0, double(moved),
          whole, "bodies moved"};
}

// A velocity in the plane of the screen.
struct Flat {
  double right, up;

  friend Flat operator+(Flat p, Flat q) { return {p.right + q.right, p.up + q.up}; }
  friend Flat operator*(double s, Flat p) { return {s * p.right, s * p.up}; }
};

Promise across() {
  const auto dot = [](Flat p, Flat q) { return p.right * q.right + p.up * q.up; };
  double off = 0;
  bool same = true;
  for_each_two([&](Two two) {
    Flat v1{two.v1, 0.7}, v2{two.v2, -1.9};
    shelf::damper_along(v1, v2, h, two.pull / h, two.w1, two.w2, Flat{1, 0}, dot);
    same = same && v1.up == 0.7 && v2.up == -1.9;
    v1 = {two.v1, 0.7};
    shelf::damper_along(v1, v2, h, two.pull / h, two.w1, two.w2, Flat{0.6, 0.8}, dot);
    const long double change = 0.8L * (v1.right - (long double)two.v1) - 0.6L * (v1.up - 0.7L);
    const double speeds = std::abs(two.v1) + std::abs(two.v2) + 2.6;
    off = std::max(off, double(std::abs(change)) / speeds / epsilon);
  });
  return {
      "along a line, the velocities across it stay to the bit if the line is an axis, and to 2 "
      "roundings if not",
      same && off < 2, off, 2, "roundings"};
}

}  // namespace

ShelfCard damper() {
  return {"damper", {divided(), momentum(), no_turning(), immovable(), across()}};
}

}  // namespace measure::shelf_cards
