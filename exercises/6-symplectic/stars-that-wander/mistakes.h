// SPDX-License-Identifier: MIT-0
/// @file
/// Steps that people take instead of the right one. The starter's is not among them: which stars
/// come out right is all that is told of it.
#pragma once
#include <string>
#include <vector>

#include "judge/diagnose.h"
#include "stars.h"

namespace stars {

/// How much star j of a pair counts for star i, at a distance.
using Weight = double (*)(const Stars& stars, std::size_t i, std::size_t j, double r);

inline void kick(Stars& stars, std::size_t i, double h, Weight weight) {
  for (std::size_t j = 0; j < stars.at.size(); ++j) {
    if (j == i) continue;
    const Vec to = stars.at[j].x - stars.at[i].x;
    stars.at[i].v += (h * weight(stars, i, j, length(to)) / std::pow(length(to), 3)) * to;
  }
}

inline void kick_all(Stars& stars, double h, Weight weight) {
  for (std::size_t i = 0; i < stars.at.size(); ++i) kick(stars, i, h, weight);
}

inline void move_all(Stars& stars, double h) {
  for (State& star : stars.at) star.x += h * star.v;
}

inline double by_other(const Stars& stars, std::size_t, std::size_t j, double) {
  return stars.mu[j];
}

template <Weight weight>
void kick_and_move(Stars& stars, double h) {
  kick_all(stars, h, weight);
  move_all(stars, h);
}

inline double by_own(const Stars& stars, std::size_t i, std::size_t, double) {
  return stars.mu[i];
}
inline double by_both(const Stars& stars, std::size_t i, std::size_t j, double) {
  return stars.mu[i] * stars.mu[j];
}
inline double pushed(const Stars& stars, std::size_t, std::size_t j, double) {
  return -stars.mu[j];
}
inline double one_of_pair(const Stars& stars, std::size_t i, std::size_t j, double) {
  return j > i ? stars.mu[j] : 0;
}
inline double once_over(const Stars& stars, std::size_t, std::size_t j, double r) {
  return stars.mu[j] * r;
}
inline double cubed(const Stars& stars, std::size_t, std::size_t j, double r) {
  return stars.mu[j] / r;
}

inline void without_h(Stars& stars, double) {
  kick_and_move<by_other>(stars, 1);
}
inline void move_first(Stars& stars, double h) {
  move_all(stars, h);
  kick_all(stars, h, by_other);
}
inline void move_with_old(Stars& stars, double h) {
  const std::vector<State> before = stars.at;
  kick_all(stars, h, by_other);
  for (std::size_t i = 0; i < before.size(); ++i) stars.at[i].x += h * before[i].v;
}
inline void taken_back(Stars& stars, double h) {
  const Vec before = drift(stars);
  for (std::size_t i = 0; i < stars.at.size(); ++i) {
    kick(stars, i, h, by_other);
    stars.at[i].x += h * stars.at[i].v;
  }
  const Vec more = drift(stars) - before;
  for (State& star : stars.at) star.v -= more;
}

struct Mistake {
  const char* says;
  void (*step)(Stars& stars, double h);
};

inline constexpr Mistake mistakes[] = {
    {"a star is pulled by its own mu, and not by the other's", kick_and_move<by_own>},
    {"the mu of both stars are multiplied: that is a force, and what is wanted an acceleration",
     kick_and_move<by_both>},
    {"the pull counts with the wrong sign", kick_and_move<pushed>},
    {"of each pair only the star that comes first in the list is pulled",
     kick_and_move<one_of_pair>},
    {"the pull falls off with the distance, and not with its square", kick_and_move<once_over>},
    {"the pull falls off with the cube of the distance: was its direction divided by it once more?",
     kick_and_move<cubed>},
    {"h is missing: this is a step of one second", without_h},
    {"this is symplectic Euler, position first", move_first},
    {"this is Euler's method: the stars moved with their old velocities", move_with_old},
    {"what the stars drift is taken out again: that mends what is seen, and not the mistake",
     taken_back},
};

/// Pulls that look at a distance of sqrt(r^2 + share).
inline Stars softened(Stars stars, double h, double share) {
  const std::vector<State> before = stars.at;
  for (std::size_t i = 0; i < before.size(); ++i) {
    for (std::size_t j = 0; j < before.size(); ++j) {
      const Vec to = before[j].x - before[i].x;
      if (j != i) stars.at[i].v += h * stars.mu[j] / std::pow(dot(to, to) + share, 1.5) * to;
    }
  }
  move_all(stars, h);
  return stars;
}

/// The length by which these stars' pulls are softened [m], by secants; 0 if they are not.
inline double softening(const Stars& start, const Stars& yours, const Stars& right, double h) {
  const Vec kick = yours.at[0].v - start.at[0].v;
  const auto missing = [&](double share) {
    return dot(softened(start, h, share).at[0].v - start.at[0].v - kick, kick);
  };
  double last = 0, share = 1e-3;
  for (int n = 0; n < 40 && share > -0.5 && share != last; ++n) {
    const double here = missing(share), slope = (here - missing(last)) / (share - last);
    last = share;
    if (slope != 0) share -= here / slope;
  }
  // What is left is next to nothing of what is wrong.
  const double off = apart(yours, right), left = apart(yours, softened(start, h, share));
  return share > 0 && left <= 1e-3 * off ? std::sqrt(share) : 0;
}

/// What there is to say of a student's first step.
inline std::vector<std::string> recognised(const Stars& start, const Stars& yours,
                                           const Stars& right, double h) {
  for (const Mistake& mistake : mistakes) {
    Stars theirs = start;
    mistake.step(theirs, h);
    if (apart(yours, theirs) <= 1e-10) return {mistake.says};
  }
  const double off = apart(yours, right);
  if (!std::isfinite(off))
    return {"there are numbers that are not finite: is a star pulled by itself?"};
  if (const double length = softening(start, yours, right, h); length > 0)
    return {"the pull is softened, as if the stars were " + grade::number(length, 2) +
            " m further off to one side: is something added under the root?"};
  if (judge::like_a_float(off, 1e-10))
    return {"right to seven digits and no further: a float, or a constant with an f?"};
  std::string good, bad;
  for (std::size_t i = 0; i < right.at.size(); ++i) {
    const bool held = judge::distance(yours.at[i], right.at[i]) <= 1e-10;
    (held ? good : bad) += (held ? good : bad).empty() ? "" : ", ";
    (held ? good : bad) += "star " + std::to_string(i + 1);
  }
  if (good.empty()) return {};
  if (bad.empty())
    return {"all stars are off by a share of about " +
            grade::number(off / length(right.at[0].x), 1) +
            ": is something added under the root, or to the mu?"};
  return {"right after the first step: " + good + "; wrong: " + bad};
}

}  // namespace stars
