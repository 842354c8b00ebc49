// SPDX-License-Identifier: MIT-0
// What the clock steps sixty times a second: the spring, the rope, the replay.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "chain.h"
#include "judge/numbers.h"
#include "things.h"

namespace level {
namespace {

std::string after(int step) {
  return "after " + std::to_string(step / 60) + " s";
}

}  // namespace

Hour spring_hour(judge::Student& yours, judge::Student&) {
  constexpr double omega = 40, amplitude = 0.1;
  const double told = yours.call(1, {omega, h}, 1)[0];
  const std::vector<double> swing =
      yours.call(0, judge::as_numbers(amplitude, 0, h, told, 0, steps), 2 * std::size_t{steps});
  Hour hour;
  for (int n = 1; n <= steps; ++n) {
    const double x = swing[2 * static_cast<std::size_t>(n - 1)];
    hour.hold(std::abs(x - amplitude * std::cos(omega * h * n)), after(n));
  }
  return hour;
}

Hour rope_hour(judge::Student& yours, judge::Student&) {
  Hour hour;
  Chain chain;
  for (int n = 1; n <= steps && hour.whole; ++n) {
    chain.step(yours, n * h);
    hour.hold(chain.off(), after(n));
  }
  return hour;
}

Hour replay_hour(judge::Student& yours, judge::Student& right) {
  constexpr double distance = 10, turn = 20;  // [m], [s]
  constexpr int minute = 3600;
  const double rate = 2 * std::numbers::pi / turn;
  const harness::Force planet{harness::Force::orbit, {rate * rate * std::pow(distance, 3)}};
  const judge::Start start{{distance, 0, 0}, {0, rate * distance, 0}};
  const judge::Path path = yours.run(start, h, steps, minute, planet);
  const judge::Path wanted_path = right.run(start, h, steps, minute, planet);
  Hour hour;
  for (std::size_t n = 0; n < path.states.size(); ++n)
    hour.hold(length(path.states[n].x - wanted_path.states[n].x),
              after(static_cast<int>(n) * minute));
  // The last minute, wound back.
  const judge::State end = path.states.back(), wanted = path.states[path.states.size() - 2];
  const judge::Path back = yours.run({end.x, end.v, steps * h}, -h, minute, minute, planet, 1);
  hour.hold(length(back.states.back().x - wanted.x), after(steps));
  constexpr int counted = 60;
  const judge::Path watched = yours.watch(start, h, counted, planet);
  hour.evaluations = static_cast<double>(watched.evaluations.size()) / counted;
  return hour;
}

}  // namespace level
