// SPDX-License-Identifier: MIT-0
#include "shelf/link.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstddef>
#include <limits>
#include <numbers>
#include <vector>

#include "measure/sheet.h"
#include "measure/shelf_card.h"

namespace measure::shelf_cards {
namespace {

constexpr double g = 9.81, mass = 0.01, frame = 1 / 60.0;
constexpr double epsilon = std::numeric_limits<double>::epsilon();
constexpr auto length_of = [](double x) { return std::abs(x); };

// Two metres of rope in links, hanging straight down, with a floor far below.
struct Hanging {
  std::vector<double> x, before, tension, w;
  shelf::Rope<double> rope;

  Hanging(int links, double stiffness)
      : tension(std::size_t(links)), w(std::size_t(links) + 1, 1 / mass) {
    rope.length = 2.0 / links;
    rope.compliance = 1 / stiffness;
    for (int i = 0; i <= links; ++i) x.push_back(-i * rope.length);
    before = x;
    w[0] = 0;
  }

  void run(double h, double duration, double floor = -100) {
    const auto above = [floor](double place) { return std::max(place, floor); };
    for (int n = 0; n * h < duration; ++n) {
      shelf::rope_step(x, before, tension, w, x.size(), rope, -g, h, length_of, above);
    }
  }

  double per_cent() const { return 100 * (-x.back() / 2 - 1); }

  // How far a point goes at most in one of 600 more steps [m].
  double restless(double h) {
    double most = 0;
    for (int n = 0; n < 600; ++n) {
      run(h, h / 2);
      for (std::size_t i = 0; i < x.size(); ++i) most = std::max(most, std::abs(x[i] - before[i]));
    }
    return most;
  }
};

// The stiffness of springs that let 20 links hang one per cent longer.
constexpr double one_per_cent = mass * g * 20 * 21 / 2 / 0.02;

double in_substeps(int substeps, bool warm) {
  Hanging hanging(20, one_per_cent);
  hanging.rope.warm = warm;
  hanging.run(frame / substeps, 60);
  return hanging.per_cent();
}

// Calls `visit(w1, w2, x1, x2)` for points of 1 g to 1 t.
template <class Visit>
void for_each_pair(Visit visit) {
  for (const double w1 : {1e3, 30.0, 1.0, 0.02, 1e-3}) {
    for (const double w2 : {1e3, 7.0, 1.0, 0.3, 1e-3}) {
      for (const double x2 : {-1.0, 0.3, 0.9}) visit(w1, w2, 0.1, x2);
    }
  }
}

Promise distance() {
  double off = 0;
  for_each_pair([&](double w1, double w2, double x1, double x2) {
    shelf::pull(x1, x2, w1, w2, 0.7, length_of);
    off = std::max(off, std::abs(std::abs(x2 - x1) - 0.7));
  });
  return {"a pull brings two points of 1 g to 1 t to their distance, to 4 roundings",
          off < 4 * epsilon, off / epsilon, 2, "roundings"};
}

Promise centre() {
  long double off = 0;
  for_each_pair([&](double w1, double w2, double x1, double x2) {
    const auto place = [&] {
      return (x1 / (long double)w1 + x2 / (long double)w2) /
             (1 / (long double)w1 + 1 / (long double)w2);
    };
    const long double before = place();
    shelf::pull(x1, x2, w1, w2, 0.7, length_of);
    off = std::max(off, std::abs(place() - before));
  });
  double held = 0.1, end = 0.9;
  shelf::pull(held, end, 0.0, 1.0, 0.7, length_of);
  const double roundings = double(off) / epsilon;
  return {
      "their centre of mass stays, to 4 roundings, and a point of inverse mass 0 stays to the "
      "bit",
      roundings < 4 && held == 0.1, roundings, 2, "roundings"};
}

Promise backward_euler() {
  double off = 0;
  for (int power = -6; power <= 3; ++power) {
    const double angle = std::pow(10, power), h = frame, w = 5;
    for (const double speed : {-3.0, 0.0, 2.0}) {
      double anchor = 0, x = 1.25 + h * speed, tension = 0;
      const long double exact = ((long double)x - 1) / (1 + (long double)angle * angle);
      const double compliance = w * h * h / (angle * angle);
      shelf::link(anchor, x, tension, 0.0, w, 1.0, compliance, h, length_of);
      off = std::max(off, double(std::abs((long double)x - 1 - exact)) / epsilon);
    }
  }
  return {
      "a link with compliance makes the step of backward Euler: a stretch e that grows by v "
      "becomes (e + h v) / (1 + (h omega)^2), to 4 roundings, for h omega from 10^-6 to 10^3",
      off < 4, off, 2, "roundings"};
}

Promise next_link() {
  double off = 0;
  for (const double tip : {0.002, 0.01, 0.05}) {
    const double h = frame / 4;
    Hanging hanging(20, 4e3);
    hanging.w[20] = 1 / tip;
    hanging.run(h, 300);
    double below = 0, weight = tip * g;
    for (std::size_t i = 20; i > 0; --i) {
      const double wanted = 0.1 + weight / 4e3 + h * h / mass * below;
      off = std::max(off, std::abs(hanging.x[i - 1] - hanging.x[i] - wanted));
      below = weight;
      weight += mass * g;
    }
  }
  return {
      "where a rope hangs, with one pass, each link is longer than its tension asks for: by h^2/m "
      "times the tension of the link below it, m being the mass of the point between them; to "
      "10^-9 m",
      off < 1e-9, off, 2, "m"};
}

Promise law() {
  const auto near = [](int substeps, double promised, double last_digit) {
    return std::abs(in_substeps(substeps, false) - promised) < last_digit / 2;
  };
  return {
      "of two metres in 20 links that should give 1 %, one pass gives 26.9 % with one step in "
      "1/60 s, 2.62 with 4 substeps, 1.40 with 8, 1.10 with 16 and 1.03 with 32",
      near(1, 26.9, 0.1) && near(4, 2.62, 0.01) && near(8, 1.40, 0.01) && near(16, 1.10, 0.01) &&
          near(32, 1.03, 0.01),
      in_substeps(8, false), 4, "%"};
}

Promise warm() {
  const double stretch = in_substeps(8, true);
  return {"begun warm, it gives 1.000 % with 8 substeps", std::abs(stretch - 1) < 5e-4, stretch, 4,
          "%"};
}

double restless(double stiffness, bool warm) {
  const double h = frame / 8;
  Hanging hanging(20, stiffness * mass / (h * h));
  hanging.rope.warm = warm;
  hanging.run(h, 60);
  return hanging.restless(h);
}

Promise bursting() {
  const double bursts = restless(1.5, true);
  return {
      "begun warm, with one pass, it comes to rest if k h^2/m is 0.8 and bursts if it is 1.5, k "
      "being the stiffness of a link and m the mass of a point; begun cold, it comes to rest at "
      "10^9",
      restless(0.8, true) < 1e-6 && bursts > 0.01 && restless(1e9, false) < 1e-6, bursts, 2,
      "m in a step"};
}

// How far the first point of a rope that nobody holds falls in a third of a second [m].
template <class Real>
double fallen(double start, double h) {
  std::vector<Real> x, tension(20), w(21, Real(1 / mass));
  for (int i = 0; i <= 20; ++i) x.push_back(Real(start - 0.1 * i));
  const Real first = x[0];
  auto before = x;
  const shelf::Rope<Real> rope{Real(0.1), Real(1 / one_per_cent)};
  const auto distance = [](Real way) { return std::abs(way); };
  const auto anywhere = [](Real place) { return place; };
  for (int n = 0; 3 * n * h < 1; ++n) {
    shelf::rope_step(x, before, tension, w, x.size(), rope, Real(-g), Real(h), distance, anywhere);
  }
  return double(first - x[0]);
}

Promise in_float() {
  double off = 0, lost = 0;
  for (const int substeps : {4, 8, 16, 32}) {
    const double h = frame / substeps, added = h * h * g;
    for (double share = 0.5; share <= 1; share += 1 / 64.0) {
      const double start = std::ldexp(share * added, 17);
      off = std::max(off, std::abs(fallen<float>(start, h) / fallen<double>(start, h) - 1));
    }
    lost = std::max(lost, std::abs(fallen<float>(std::ldexp(added, 25), h)));
  }
  return {
      "in float, let go at up to 2^17 h^2 g from the origin, it falls as in double, to 1 %; "
      "let go at 2^25 h^2 g, it does not fall",
      off < 0.01 && lost == 0, 100 * off, 2, "%"};
}

// What a grapple that is let go at 1 rad has of its energy where it swings highest in its seconds 5
// to 10 [%].
double left_of_a_swing(int substeps) {
  using Flat = std::complex<double>;  // right and up
  const double h = frame / substeps, reach = 6;
  Flat x[] = {0, std::polar(reach, 1 - std::numbers::pi / 2)}, before[] = {x[0], x[1]};
  double tension[] = {0}, highest = -reach;
  const double w[] = {0, 1.0 / 80};
  const shelf::Rope<double> rope{reach};
  const auto norm = [](Flat way) { return std::abs(way); };
  const auto free = [](Flat place) { return place; };
  for (int n = 0; n < 600 * substeps; ++n) {
    shelf::rope_step(x, before, tension, w, 2, rope, Flat(0, -g), h, norm, free);
    if (n >= 300 * substeps) highest = std::max(highest, x[1].imag());
  }
  return 100 * (reach + highest) / (reach - reach * std::cos(1.0));
}

Promise of_a_swing() {
  const auto near = [](int substeps, double promised) {
    return std::abs(left_of_a_swing(substeps) - promised) < 0.5;
  };
  return {
      "a grapple, one link of 6 m let go at 1 rad, has 81 % of its energy in seconds 5 to 10 with "
      "one step in 1/60 s, 95 with 4 substeps, 97 with 8 and 99 with 16",
      near(1, 81) && near(4, 95) && near(8, 97) && near(16, 99), left_of_a_swing(1), 3, "%"};
}

// By which share the worst link of a sheet is ever off within a second.
double sheet_off(bool shuffled, float stiffness, int substeps) {
  Sheet sheet;
  if (shuffled) sheet.shuffle();
  double most = 0;
  for (int n = 0; n < 60 * substeps; ++n) {
    sheet.step(float(frame / substeps), 1 / stiffness, 1);
    if (n % substeps == substeps - 1) most = std::max(most, sheet.worst());
  }
  return most;
}

Promise of_a_sheet() {
  double least = 1e9, most = 0;
  for (const float stiffness : {1e5f, 1e9f}) {
    for (const int substeps : {1, 4, 16, 32}) {
      least = std::min(least, sheet_off(false, stiffness, substeps));
      most = std::max(most, sheet_off(true, stiffness, substeps));
    }
  }
  return {
      "a level sheet of 64 by 32 cells with diagonals, of floats, turned against the axes, in free "
      "fall and of 10^5 N/m or more, has links of more than twice their length within a second if "
      "they are taken cell by cell, in 1 to 32 substeps; shuffled once, none is off by 2*10^-5 of "
      "its length in a second",
      least > 1 && most < 2e-5, most};
}

Promise on_the_floor() {
  Hanging hanging(20, one_per_cent);
  double lowest = 0;
  for (int n = 0; n < 600; ++n) {
    hanging.run(frame, frame / 2, -1.5);
    lowest = std::min(lowest, *std::min_element(hanging.x.begin(), hanging.x.end()));
  }
  return {"no free point is below the floor after a step", lowest >= -1.5, -1.5 - lowest, 1, "m"};
}

}  // namespace

ShelfCard link() {
  return {"link",
          {distance(), centre(), backward_euler(), next_link(), law(), warm(), bursting(),
           in_float(), of_a_swing(), of_a_sheet(), on_the_floor()}};
}

}  // namespace measure::shelf_cards
