// SPDX-License-Identifier: MIT-0
/// @file
/// A sledge, as it should be stepped, as others step it, and as the student does.
#pragma once
#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "format_values.h"
#include "judge/describe.h"
#include "judge/diagnose.h"
#include "judge/random.h"
#include "judge/student.h"

namespace sledge {

using judge::State;

struct Sledge {
  Vec along;
  double c_along, c_across;

  static Sledge draw(judge::Random& random) {
    const Vec way = random.start().x;
    return {way / length(way), random.between(0.5, 1.5), random.between(50, 150)};
  }

  Vec braked(const Vec& v, double h, double (*factor)(double)) const {
    const Vec glide = dot(v, along) * along;
    return factor(c_along * h) * glide + factor(c_across * h) * (v - glide);
  }
};

inline double divided(double ch) {
  return 1 / (1 + ch);
}
inline double taken_off(double ch) {
  return 1 - ch;
}
inline double cut_off(double ch) {
  return std::max(0.0, 1 - ch);
}
inline double exponential(double ch) {
  return std::exp(-ch);
}

inline double twice(double ch) {
  return 1 / ((1 + ch) * (1 + ch));
}
inline double driven(double ch) {
  return 1 / (1 - ch);
}

/// What comes after what. A push that depends on the velocity also tells when it was asked.
enum Order {
  push_first,
  asked_then_brake,
  brake_then_asked,
  move_before_brake,
  move_with_old,
  push_braked_along,
  push_at_the_end,
  moves_first
};

// What people make of the two drags.
inline Sledge as_it_is(const Sledge& sledge, double) {
  return sledge;
}
inline Sledge swapped(const Sledge& sledge, double) {
  return {sledge.along, sledge.c_across, sledge.c_along};
}
inline Sledge easy(const Sledge& sledge, double) {
  return {sledge.along, sledge.c_along, sledge.c_along};
}
inline Sledge stiff(const Sledge& sledge, double) {
  return {sledge.along, sledge.c_across, sledge.c_across};
}
inline Sledge glides_freely(const Sledge& sledge, double) {
  return {sledge.along, 0, sledge.c_across};
}
inline Sledge brakes_by_c(const Sledge& sledge, double h) {
  return {sledge.along, sledge.c_along / h, sledge.c_across / h};
}
inline Sledge glides_by_c(const Sledge& sledge, double h) {
  return {sledge.along, sledge.c_along / h, sledge.c_across};
}
inline Sledge grips_by_c(const Sledge& sledge, double h) {
  return {sledge.along, sledge.c_along, sledge.c_across / h};
}
inline Sledge in_the_plane(const Sledge& sledge, double) {
  return {{sledge.along.x, sledge.along.y, 0}, sledge.c_along, sledge.c_across};
}
inline Sledge turned_into_the_plane(const Sledge& sledge, double h) {
  Sledge flat = in_the_plane(sledge, h);
  flat.along = flat.along / length(flat.along);
  return flat;
}
inline Sledge twice_along(const Sledge& sledge, double h) {
  const double both = sledge.c_along + sledge.c_across + sledge.c_along * sledge.c_across * h;
  return {sledge.along, both, sledge.c_across};
}

/// A way to brake.
struct Way {
  std::string name;
  double (*factor)(double);
  Order order;
  Sledge (*as)(const Sledge&, double h) = as_it_is;

  void step(const Sledge& real, State& s, double t, double h, const harness::Force& push) const {
    const Sledge sledge = as(real, h);
    const Vec old = s.v;
    if (order == moves_first) s.x += h * old;
    Vec kick = h * push(s.x, old, order == push_at_the_end ? t + h : t);
    if (order == brake_then_asked) kick = h * push(s.x, sledge.braked(old, h, factor), t);
    if (order == push_first || order == move_with_old || order == push_at_the_end ||
        order == moves_first) {
      s.v = sledge.braked(old + kick, h, factor);
    } else if (order == move_before_brake) {
      s.v = old + kick;
    } else if (order == push_braked_along) {
      s.v = sledge.braked(old, h, factor) + factor(sledge.c_along * h) * kick;
    } else {
      s.v = sledge.braked(old, h, factor) + kick;
    }
    if (order != moves_first) s.x += h * (order == move_with_old ? old : s.v);
    if (order == move_before_brake) s.v = sledge.braked(s.v, h, factor);
  }
};

inline const Way right{"drag divided after the push", divided, push_first};
inline const std::vector<Way> others{
    {"drag divided before the push", divided, brake_then_asked},
    {"drag divided before the push", divided, asked_then_brake},
    {"drag divided after the move", divided, move_before_brake},
    {"the right velocity, and a move with the one before it", divided, move_with_old},
    {"drag by 1 - c h, after the push", taken_off, push_first},
    {"drag as one of the forces, or by 1 - c h before the push", taken_off, asked_then_brake},
    {"drag by 1 - c h before the push", taken_off, brake_then_asked},
    {"drag by 1 - c h cut off at zero, after the push", cut_off, push_first},
    {"drag by 1 - c h cut off at zero, before the push", cut_off, brake_then_asked},
    {"drag by 1 - c h cut off at zero, before the push", cut_off, asked_then_brake},
    {"drag by exp(-c h), after the push", exponential, push_first},
    {"drag by exp(-c h), before the push", exponential, brake_then_asked},
    {"drag by exp(-c h), before the push", exponential, asked_then_brake},
    {"drag with the wrong sign: over 1 - c h, it drives", driven, push_first},
    {"drag over 1 + c, without h", divided, push_first, brakes_by_c},
    {"drag over 1 + c, without h, along the runners", divided, push_first, glides_by_c},
    {"drag over 1 + c, without h, across the runners", divided, push_first, grips_by_c},
    {"drag across the runners, and none along them", divided, push_first, glides_freely},
    {"the two drags at each other's places", divided, push_first, swapped},
    {"one drag for all directions, that along the runners", divided, push_first, easy},
    {"one drag for all directions, that across the runners", divided, push_first, stiff},
    {"both brakes, each of them twice", twice, push_first},
    {"runners without a third coordinate: z counts in along, too", divided, push_first,
     in_the_plane},
    {"runners that are turned into the plane: z counts in along, too", divided, push_first,
     turned_into_the_plane},
    {"both drags on what glides, one after the other", divided, push_first, twice_along},
    {"a velocity that was split before the push, and the push braked along as a whole", divided,
     push_braked_along},
    {"the right brake, and a push of the time at the step's end", divided, push_at_the_end},
    {"the right lines, and the move before them", divided, moves_first},
};

struct Ride {
  Sledge sledge;
  judge::Start start;
  harness::Force push;
  double h = 0;
  int steps = 0, every = 1;

  std::vector<State> by(const Way& way) const {
    State s{start.x, start.v};
    std::vector<State> states;
    for (int n = 0; n < steps; ++n) {
      way.step(sledge, s, start.t + n * h, h, push);
      if ((n + 1) % every == 0) states.push_back(s);
    }
    return states;
  }

  std::vector<State> by(judge::Student& student) const {
    const Vec &d = sledge.along, &x = start.x, &v = start.v;
    std::vector<double> arguments{
        d.x, d.y, d.z, sledge.c_along, sledge.c_across, static_cast<double>(push.kind)};
    arguments.insert(arguments.end(), push.a.begin(), push.a.end());
    arguments.insert(arguments.end(), {x.x, x.y, x.z, v.x, v.y, v.z, start.t, h,
                                       static_cast<double>(steps), static_cast<double>(every)});
    const auto count = static_cast<std::size_t>(steps / every);
    const std::vector<double> said = student.call(0, arguments, 6 * count);
    std::vector<State> states;
    for (auto next = said.begin(); next != said.end(); next += 6) {
      states.push_back({{next[0], next[1], next[2]}, {next[3], next[4], next[5]}});
    }
    return states;
  }

  std::string input() const {
    return judge::describe(start) + ", h = " + grade::number(h, 17) + "; runners along " +
           judge::describe(sledge.along, 17) + ", drag " + grade::number(sledge.c_along, 17) +
           "/s and " + grade::number(sledge.c_across, 17) + "/s";
  }
};

/// How far the states are apart, beside their size.
inline double apart(const std::vector<State>& yours, const std::vector<State>& theirs) {
  double apart = 0, size = 1;
  for (std::size_t n = 0; n < yours.size(); ++n) {
    const double now = judge::distance(yours[n], theirs[n]);
    apart = std::isfinite(now) ? std::max(apart, now) : INFINITY;
    size = std::max(size, judge::distance(theirs[n], State{}));
  }
  return apart / size;
}

/// Which of the ways this is, to ten digits.
inline std::vector<std::string> recognised(const Ride& ride, const std::vector<State>& yours) {
  for (const Way& way : others) {
    if (apart(yours, ride.by(way)) <= 1e-10) return {"this is " + way.name};
  }
  const double off = apart(yours, ride.by(right));
  if (judge::like_a_float(off))
    return {"right to seven digits and no further: a float, or a constant with an f?"};
  return {};
}

}  // namespace sledge
