// SPDX-License-Identifier: MIT-0
/// @file
/// Stars that pull on each other, as the judge steps them, and as the student's code does; and the
/// areas between neighbouring starts, which a step keeps.
#pragma once
#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "format_values.h"
#include "judge/describe.h"
#include "judge/numbers.h"
#include "judge/random.h"
#include "judge/student.h"

namespace stars {

using judge::State;

struct Stars {
  std::vector<State> at;
  std::vector<double> mu;
};

// Stars in a ring, so that no two meet within the second or two of a test.
inline Stars draw(judge::Random& random, int count) {
  Stars stars;
  for (int i = 0; i < count; ++i) {
    const double angle = (i + random.between(-0.2, 0.2)) * 2 * std::numbers::pi / count;
    const double r = random.between(1.5, 2);
    stars.at.push_back({{r * std::cos(angle), r * std::sin(angle), random.between(-0.5, 0.5)},
                        random.vector(-0.4, 0.4)});
    stars.mu.push_back(random.between(0.5, 2));
  }
  return stars;
}

// Stars with any distances between them, each of any mass and any velocity; some in one row along
// an axis.
inline Stars draw_anywhere(judge::Random& random, int count) {
  constexpr harness::Bounds apart{"apart", 0.01, 100}, v{"v", 0, 100}, mu{"mu", 0, 100};
  Stars stars;
  Vec x;
  for (int i = 0; i < count; ++i) {
    stars.at.push_back({x, random.vector_anywhere(v)});
    stars.mu.push_back(random.anywhere(mu));
    x += random.vector_anywhere(apart);
  }
  return stars;
}

// The size of the numbers that are summed up in a step: the positions, the ways, and the kicks.
inline double size(const Stars& stars, double h) {
  double sum = 0;
  for (std::size_t i = 0; i < stars.at.size(); ++i) {
    sum += length(stars.at[i].x) + length(stars.at[i].v);
    for (std::size_t j = 0; j < i; ++j) {
      const Vec to = stars.at[j].x - stars.at[i].x;
      sum += h * (stars.mu[i] + stars.mu[j]) / dot(to, to);
    }
  }
  return sum;
}

// Two stars that turn around each other on ellipses in four seconds or so, and together stay.
inline Stars draw_pair(judge::Random& random) {
  const double a = random.between(0.5, 1), b = random.between(1.5, 2);
  const double apart = random.between(1, 1.2), speed = std::sqrt((a + b) / apart) * 1.15;
  const Vec side{apart, 0, 0}, along{0, 0.8 * speed, 0.6 * speed};
  const double share = b / (a + b);
  return {{{-share * side, -share * along}, {(1 - share) * side, (1 - share) * along}}, {a, b}};
}

inline void right_step(Stars& stars, double h) {
  const std::vector<State> before = stars.at;
  for (std::size_t i = 0; i < before.size(); ++i) {
    Vec a;
    for (std::size_t j = 0; j < before.size(); ++j) {
      const Vec to = before[j].x - before[i].x;
      if (j != i) a += (stars.mu[j] / (dot(to, to) * length(to))) * to;
    }
    stars.at[i].v += h * a;
    stars.at[i].x += h * stars.at[i].v;
  }
}

// The right states after each step.
inline std::vector<Stars> by_method(Stars stars, double h, int steps) {
  std::vector<Stars> run;
  for (int n = 0; n < steps; ++n) {
    right_step(stars, h);
    run.push_back(stars);
  }
  return run;
}

inline std::vector<Stars> by(judge::Student& student, const Stars& stars, double h, int steps) {
  const std::size_t count = stars.mu.size(), all = static_cast<std::size_t>(steps) * count;
  std::vector<double> arguments = judge::as_numbers(steps, h, count);
  for (std::size_t i = 0; i < count; ++i)
    judge::append(arguments, judge::as_numbers(stars.at[i], stars.mu[i]));
  const std::vector<State> states = judge::as_states(student.call(0, arguments, 6 * all));
  std::vector<Stars> run;
  for (std::size_t n = 0; n < all; n += count) {
    const auto first = states.begin() + static_cast<std::ptrdiff_t>(n);
    run.push_back({{first, first + static_cast<std::ptrdiff_t>(count)}, stars.mu});
  }
  return run;
}

inline std::string describe(const Stars& stars, double h) {
  std::string text;
  for (std::size_t i = 0; i < stars.mu.size(); ++i) {
    text += "star " + std::to_string(i + 1) + ": " + judge::describe(stars.at[i]) + ", " +
            judge::named("mu", stars.mu[i]) + "; ";
  }
  return text + judge::named("h", h);
}

/// The largest difference of a star's state; infinite if a number is not finite.
inline double apart(const Stars& a, const Stars& b) {
  double largest = 0;
  for (std::size_t i = 0; i < a.at.size(); ++i) {
    const double now = judge::distance(a.at[i], b.at[i]);
    largest = std::isfinite(now) ? std::max(largest, now) : INFINITY;
  }
  return largest;
}

// The velocity of the whole.
inline Vec drift(const Stars& stars) {
  Vec momentum;
  double mass = 0;
  for (std::size_t i = 0; i < stars.mu.size(); ++i) {
    momentum += stars.mu[i] * stars.at[i].v;
    mass += stars.mu[i];
  }
  return momentum / mass;
}

inline Stars turned_round(Stars stars) {
  std::reverse(stars.at.begin(), stars.at.end());
  std::reverse(stars.mu.begin(), stars.mu.end());
  return stars;
}

/// A small way from one start to another, for each star; or what a step made of it.
using Aside = std::vector<State>;

inline Aside draw_aside(judge::Random& random, std::size_t count) {
  Aside aside(count);
  for (State& star : aside) star = {random.vector(-1, 1), random.vector(-1, 1)};
  return aside;
}

/// The area that two of them span, each star's times its mass.
inline double area(const std::vector<double>& mu, const Aside& a, const Aside& b) {
  double sum = 0;
  for (std::size_t i = 0; i < mu.size(); ++i) {
    sum += mu[i] * (dot(a[i].x, b[i].v) - dot(a[i].v, b[i].x));
  }
  return sum;
}

/// The ways aside after a step: the difference of two steps from a little to either side.
/// @param step  callable `(Stars) -> Stars`
template <class Step>
Aside carried(const Step& step, const Stars& start, const Aside& aside, double share) {
  Stars there = start, opposite = start;
  for (std::size_t i = 0; i < aside.size(); ++i) {
    there.at[i].x += share * aside[i].x;
    there.at[i].v += share * aside[i].v;
    opposite.at[i].x -= share * aside[i].x;
    opposite.at[i].v -= share * aside[i].v;
  }
  const Stars a = step(there), b = step(opposite);
  Aside result;
  for (std::size_t i = 0; i < aside.size(); ++i) {
    result.push_back(
        {(a.at[i].x - b.at[i].x) / (2 * share), (a.at[i].v - b.at[i].v) / (2 * share)});
  }
  return result;
}

}  // namespace stars
