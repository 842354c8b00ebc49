// SPDX-License-Identifier: MIT-0
/// @file
/// Frames of changing length, and where they lead.
#pragma once
#include <algorithm>
#include <cmath>

#include "../places.h"
#include "judge/random.h"

namespace judge::verlet::uneven_jumps {

/// What the student's step is given.
struct Flight {
  harness::Force force;
  Vec x, x_previous;
  double t = 0, h_previous = 0;  ///< [s]
  std::vector<double> frames;    ///< lengths [s]

  std::vector<Vec> by(Student& student) const {
    std::vector<double> request{static_cast<double>(force.kind)};
    request.insert(request.end(), force.a.begin(), force.a.end());
    request.insert(request.end(), {x.x, x.y, x.z, x_previous.x, x_previous.y, x_previous.z, t,
                                   h_previous, static_cast<double>(frames.size())});
    request.insert(request.end(), frames.begin(), frames.end());
    return as_places(student.call(0, request, 3 * frames.size()));
  }

  /// What the force is asked for.
  enum Asked { as_it_should, one_frame_later, with_next_frame };

  /// The same frames where the next place is x + far (x - x_previous) + push a.
  /// @param far, push  callable `(h, h_previous)`
  template <class Far, class Push>
  std::vector<Vec> by(Far far, Push push, Asked asked = as_it_should) const {
    std::vector<Vec> places{x_previous, x};
    double now = t, last = h_previous;
    for (const double h : frames) {
      const Vec here = places.back(), distance = here - places[places.size() - 2];
      places.push_back(here + far(h, last) * distance +
                       push(h, last) * force(here, distance / (asked == with_next_frame ? h : last),
                                             asked == one_frame_later ? now + h : now));
      now += h;
      last = h;
    }
    return {places.begin() + 2, places.end()};
  }

  /// When each frame ends, from the start on [s].
  std::vector<double> ends() const {
    std::vector<double> ends;
    double now = 0;
    for (const double h : frames) ends.push_back(now += h);
    return ends;
  }

  std::string in_words() const {
    std::string text = "x = " + describe(x, 17) + ", x_previous = " + describe(x_previous, 17) +
                       ", t = " + grade::number(t, 17) +
                       ", h_previous = " + grade::number(h_previous, 17) + ", then h =";
    for (const double h : frames) text += " " + grade::number(h, 17);
    return text;
  }
};

inline double ratio(double h, double last) {
  return h / last;
}
inline double none(double, double) {
  return 1;
}
inline double half_of_both(double h, double last) {
  return h * (h + last) / 2;
}
inline double squared(double h, double) {
  return h * h;
}
inline double nothing(double, double) {
  return 0;
}

/// What people make of it.
inline std::vector<Places> mistakes(const Flight& flight) {
  const auto with_last = [](double h, double last) { return h * last; };
  const auto upside_down = [](double h, double last) { return last / h; };
  const auto times = [](double factor) {
    return [factor](double h, double last) { return factor * half_of_both(h, last); };
  };
  const auto middles_alone = [](double h, double last) { return (h + last) / 2; };
  const auto squares = [](double h, double last) { return (h * h + last * last) / 2; };
  Flight forgetful = flight;
  forgetful.h_previous = flight.frames[0];
  return {
      {"the distance corrected and the push not: the starter", flight.by(ratio, squared)},
      {"the push corrected and the distance not", flight.by(none, half_of_both)},
      {"no correction at all", flight.by(none, squared)},
      {"a push of h h_previous: as if both halves were the last frame's",
       flight.by(ratio, with_last)},
      {"the ratio of the frames upside down", flight.by(upside_down, half_of_both)},
      {"a push by the mean of both frames' squares", flight.by(ratio, squares)},
      {"the corrected distance and no push at all: 1 / 2 is 0 in whole numbers",
       flight.by(ratio, nothing)},
      {"twice the push: from middle to middle it is half of both frames",
       flight.by(ratio, times(2))},
      {"half the push", flight.by(ratio, times(0.5))},
      {"a push to the other side", flight.by(ratio, times(-1))},
      {"a push of the time between the middles alone: it changes the velocity, which still has to "
       "last a frame",
       flight.by(ratio, middles_alone)},
      {"the right formula with a force at t + h",
       flight.by(ratio, half_of_both, Flight::one_frame_later)},
      {"the right formula with a drag that sees the last distance over h, not over h_previous",
       flight.by(ratio, half_of_both, Flight::with_next_frame)},
      {"right from the second frame on: in the first, h_previous is taken for h",
       forgetful.by(ratio, half_of_both)},
  };
}

/// Where the places move in some frames as they should, and in others not: what is different about
/// those.
inline std::vector<std::string> kept_within(const Flight& flight, const std::vector<Vec>& yours,
                                            const Tolerance& tolerance) {
  double low = 1, high = 1, too_low = 0, too_high = INFINITY;  // ratios of frames
  int wrong = 0;
  Flight one = flight;
  for (std::size_t n = 0; n < yours.size(); ++n) {
    one.frames = {flight.frames[n]};
    const double now = one.frames[0] / one.h_previous;
    const bool right = length(one.by(ratio, half_of_both)[0] - yours[n]) <= tolerance.value;
    if (right) {
      low = std::min(low, now);
      high = std::max(high, now);
    } else if (++wrong; now < 1) {
      too_low = std::max(too_low, now);
    } else {
      too_high = std::min(too_high, now);
    }
    one.x_previous = one.x;
    one.x = yours[n];
    one.h_previous = one.frames[0];
  }
  const bool bounds = low < high && too_low < low && high < too_high;
  if (!bounds || wrong < 3) return {};
  return {"right while a frame is " + grade::number(low, 2) + " to " + grade::number(high, 2) +
          " times as long as the one before, and wrong beyond: is something kept within bounds?"};
}

}  // namespace judge::verlet::uneven_jumps
