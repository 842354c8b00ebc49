// SPDX-License-Identifier: MIT-0
#include "shelf/smooth_damp.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "measure/shelf_card.h"

namespace measure::shelf_cards {
namespace {

constexpr int rates[] = {15, 30, 60, 120, 240};
constexpr double omegas[] = {1, 2, 4, 8, 16, 30};

struct Follower {
  double x = 0, v = 0;
};

// Unity's SmoothDamp without its speed limit: the closed form with a fraction for the exponential.
// What passes the target is put onto it.
void unity(Follower& f, double target, double omega, double h) {
  const double w = omega * h, left = 1 / (1 + w + 0.48 * w * w + 0.235 * w * w * w);
  const double way = f.x - target, faster = f.v + omega * way;
  const double next = target + left * (way + h * faster);
  const bool below = f.x<target, above = next> target;
  f = below == above ? Follower{target, 0} : Follower{next, left * (f.v - omega * h * faster)};
}

void exact(Follower& f, double target, double omega, double h) {
  shelf::smooth_damp(f.x, f.v, target, 0.0, omega, h);
}

const auto product = [](double a, double b) { return a * b; };

// The same with its maxSpeed: what is further away is taken for nearer.
void unity_limited(Follower& f, double target, double omega, double top, double h) {
  const double reach = top * 2 / omega;
  const double nearer = f.x + std::clamp(target - f.x, -reach, reach);
  Follower next = f;
  unity(next, nearer, omega, h);
  f = next;
}

// The same spring in long double: the way left to a target at rest.
long double way_left(long double way, long double speed, long double omega, long double t) {
  return (way + (speed + omega * way) * t) * std::exp(-omega * t);
}

// How far a second from rest, to a target at 1, is from the truth at worst.
template <class Step>
double worst(Step step, double omega) {
  double largest = 0;
  for (const int rate : rates) {
    Follower f;
    for (int n = 1; n <= rate; ++n) {
      step(f, 1.0, omega, 1.0 / rate);
      const long double truth = 1 + way_left(-1, 0, omega, n / (long double)(rate));
      largest = std::max(largest, double(std::abs(f.x - truth)));
    }
  }
  return largest;
}

template <class Step>
double worst(Step step) {
  double largest = 0;
  for (const double omega : omegas) largest = std::max(largest, worst(step, omega));
  return largest;
}

// How far apart the ends of a run are that each rate makes of it.
template <class End>
double apart(End end) {
  double least = std::numeric_limits<double>::infinity(), most = -least;
  for (const int rate : rates) {
    least = std::min(least, end(rate));
    most = std::max(most, end(rate));
  }
  return most - least;
}

template <class Step>
double second(Step step, int rate) {
  Follower f;
  for (int n = 0; n < rate; ++n) step(f, 1.0, 4.0, 1.0 / rate);
  return f.x;
}

Promise closed_form() {
  const double ours = worst(exact), unitys = worst(unity);
  return {
      "smooth_damp from rest is the exact answer to 1e-14 of the way, for omega from 1 to 30 at "
      "15, "
      "30, 60, 120 and 240 Hz; Unity's formula is up to 0.036 of the way off",
      ours < 1e-14 && unitys < 0.036 && unitys > 0.035, ours};
}

Promise same_place() {
  const double ours = apart([](int rate) { return second(exact, rate); });
  const double unitys = apart([](int rate) { return second(unity, rate); });
  return {
      "with omega = 4 a second ends in the same place at each of these rates to 1e-14 of the way; "
      "with Unity's formula the places are 3.9e-4 of it apart",
      ours < 1e-14 && rounds_to(unitys, 3.9e-4, 1e-5), ours};
}

// Behind a target of speed 1, after twenty seconds.
template <class Step>
double lag(Step step, int rate) {
  Follower f;
  for (int n = 1; n <= 20 * rate; ++n) step(f, double(n) / rate, 4.0, 1.0 / rate);
  return 20 - f.x;
}

Promise trails() {
  const auto aimed = [](Follower& f, double target, double omega, double h) {
    shelf::smooth_damp(f.x, f.v, target - 2 / omega, 1.0, omega, h);
  };
  const double ours = apart([&](int rate) { return lag(aimed, rate); });
  const bool half_a_second = std::abs(lag(aimed, 15) - 0.5) < 1e-12;
  return {
      "behind a target that moves evenly, aimed as said, it trails by the same way at each of "
      "these "
      "rates to 1e-12; with Unity's formula, by 0.467 s at 15 Hz and 0.498 s at 240 Hz for omega = "
      "4",
      ours < 1e-12 && half_a_second && rounds_to(lag(unity, 15), 0.467, 1e-3) &&
          rounds_to(lag(unity, 240), 0.498, 1e-3),
      ours};
}

Promise from_rest() {
  double beyond = -1;
  for (const double omega : omegas) {
    for (const int rate : rates) {
      Follower f;
      for (int n = 0; n < 10 * rate; ++n) {
        exact(f, 1, omega, 1.0 / rate);
        beyond = std::max(beyond, f.x - 1);
      }
    }
  }
  return {"from rest it passes no target, at any of these rates and omegas", beyond <= 0,
          std::max(beyond, 0.0)};
}

Promise no_overshoot() {
  double beyond = -1, unlike = 0;
  for (const double times : {0.5, 1.0, 1.5, 3.0, 100.0}) {
    unlike =
        std::max(unlike, apart([&](int rate) {
                   Follower f{0, times * 4};
                   for (int n = 0; n < rate; ++n) {
                     shelf::smooth_damp_no_overshoot(f.x, f.v, 1.0, 0.0, 4.0, 1.0 / rate, product);
                     beyond = std::max(beyond, f.x - 1);
                   }
                   return f.x;
                 }));
  }
  return {
      "smooth_damp_no_overshoot passes no target at any speed up to a hundred times omega times "
      "the "
      "way, and a second of it ends in the same place at each of these rates to 1e-14 of the way",
      beyond <= 0 && unlike < 1e-14, unlike};
}

Promise smooth_alike() {
  const double ours = apart([](int rate) {
    double x = 0;
    for (int n = 0; n < rate; ++n) shelf::smooth(x, 1.0, 0.0, 4.0, 1.0 / rate);
    return x;
  });
  return {"smooth ends a second in the same place at each of these rates to 1e-14 of the way",
          ours < 1e-14, ours};
}

Promise in_float() {
  const float h = 1 / 240.0f, rate = 0.00024f;
  float ours = 0, naive = 0;
  for (int n = 0; n < 2400; ++n) {
    shelf::smooth(ours, 1.0f, 0.0f, rate, h);
    naive = naive + (1 - std::exp(-rate * h)) * (1 - naive);
  }
  const double truth = -std::expm1(-2400 * double(rate) * double(h));
  const double off = std::abs(double(ours) / truth - 1), naive_off = double(naive) / truth - 1;
  return {
      "in float, ten seconds of smooth at 240 Hz with rate h = 1e-6 are right to 1e-5 of what was "
      "moved; with 1 - exp(-rate h) in place of expm1 they are 0.013 off",
      off < 1e-5 && rounds_to(naive_off, 0.013, 1e-3), off};
}

Promise a_long_step() {
  double most = 0;
  for (const double target : {1.0, -3.7, 1e5, 1e-5}) {
    double damped = 0.3, v = 40, smoothed = 0.3;
    shelf::smooth_damp(damped, v, target, 0.0, 4.0, 1e6);
    shelf::smooth(smoothed, target, 0.0, 4.0, 1e6);
    const double unit = std::numeric_limits<double>::epsilon() * std::max(std::abs(target), 0.3);
    most = std::max({most, std::abs(damped - target) / unit, std::abs(smoothed - target) / unit});
  }
  return {"one step of a million seconds ends on a target at rest to the last bit but one",
          most <= 1, most};
}

constexpr double no_limit = std::numeric_limits<double>::infinity();

// Ten metres with omega = 4 and a top speed of 5 m/s: how far a step is off at worst, at 60 Hz,
// from steps of the limited spring itself that are a thousand times as short, by the midpoint.
template <class Step>
double worst_with_limits(Step step, double top_acceleration) {
  const auto pulled = [&](double x, double v) {
    const double wanted = std::clamp(2 * (10 - x), -5.0, 5.0);
    return std::clamp(8 * (wanted - v), -top_acceleration, top_acceleration);
  };
  double largest = 0;
  Follower f, fine;
  for (int n = 0; n < 3 * 60; ++n) {
    step(f, 1 / 60.0);
    for (int part = 0; part < 1000; ++part) {
      constexpr double h = 1 / 60.0 / 1000;
      const double middle = fine.v + h / 2 * pulled(fine.x, fine.v);
      const double there = pulled(fine.x + h / 2 * fine.v, middle);
      fine.x += h * middle;
      fine.v += h * there;
    }
    largest = std::max(largest, std::abs(f.x - fine.x));
  }
  return largest;
}

Promise top_speed() {
  const auto limited = [](Follower& f, double h) {
    shelf::smooth_damp_limited(f.x, f.v, 10.0, 0.0, 4.0, 5.0, no_limit, h, product);
  };
  const auto unitys = [](Follower& f, double h) { unity_limited(f, 10, 4, 5, h); };
  const double ours = worst_with_limits(limited, no_limit);
  const double theirs = worst_with_limits(unitys, no_limit);
  return {
      "with omega = 4 and a top speed of 5 m/s, smooth_damp_limited is never more than 2.6e-4 m "
      "off on "
      "its 10 m at 60 Hz; Unity's formula with its maxSpeed is up to 0.13 m off",
      rounds_to(ours, 2.6e-4, 1e-5) && rounds_to(theirs, 0.13, 1e-2), ours};
}

Promise top_acceleration() {
  const double ours = worst_with_limits(
      [](Follower& f, double h) {
        shelf::smooth_damp_limited(f.x, f.v, 10.0, 0.0, 4.0, 5.0, 20.0, h, product);
      },
      20);
  return {"with a top acceleration of 20 m/s^2 as well, it is never more than 9.7e-4 m off there",
          rounds_to(ours, 9.7e-4, 1e-5), ours};
}

Promise within_limits() {
  constexpr double top = 5;
  double over = 0, beyond = -1;
  for (const double omega : omegas) {
    const double most = omega * top / std::exp(1.0);
    for (const double way : {0.1, 1.0, 3.0, 10.0}) {
      for (const int rate : rates) {
        Follower f;
        for (int n = 0; n < 10 * rate; ++n) {
          const double before = f.v, h = (n % 3 + 1) / (2.0 * rate);
          shelf::smooth_damp_limited(f.x, f.v, way, 0.0, omega, top, most, h, product);
          over = std::max({over, std::abs(f.v) / top, std::abs(f.v - before) / (most * h)});
          if (omega * 1.5 / rate <= 0.5) beyond = std::max(beyond, (f.x - way) / way);
        }
      }
    }
  }
  over = over - 1;
  return {
      "towards what rests its speed and its acceleration stay within their limits from rest on, to "
      "1e-13 of them, in frames of any length, and a top acceleration of omega times the top speed "
      "over e lets it pass no target by 1e-5 of the way while omega h is 0.5 at most",
      over <= 1e-13 && beyond <= 0, std::max(over, 0.0)};
}

Promise behind_what_moves() {
  constexpr double top = 5, omega = 4;
  double over = 0;
  for (const double moves : {0.3, 1.0, 2.0, 10.0}) {
    for (const double angle : {0.02, 0.1, 0.3, 0.5, 0.8, 1.2, 2.0}) {
      const double h = angle / omega;
      for (const double start : {-10.0, -4.0, 0.0, 3.0, 10.0}) {
        for (const double sway : {0.0, 3.0}) {
          Follower f;
          for (int n = 1; n <= 300; ++n) {
            const double t = n * h, place = f.x;
            const double target = start + moves * top * t + std::sin(sway * t);
            shelf::smooth_damp_limited(f.x, f.v, target, moves * top + sway * std::cos(sway * t),
                                       omega, top, no_limit, h, product);
            over = std::max({over, std::abs(f.v), std::abs(f.x - place) / h});
          }
        }
      }
    }
  }
  over = over / top - 1;
  return {
      "behind what moves, up to ten times as fast, its speed stays within the top speed, to 1e-13 "
      "of it, for omega h up to 2",
      over <= 1e-13, std::max(over, 0.0)};
}

}  // namespace

ShelfCard smooth_damp() {
  return {"smooth_damp",
          {closed_form(), same_place(), trails(), from_rest(), no_overshoot(), smooth_alike(),
           in_float(), a_long_step(), top_speed(), top_acceleration(), behind_what_moves(),
           within_limits()}};
}

}  // namespace measure::shelf_cards
