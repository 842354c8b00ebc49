// SPDX-License-Identifier: MIT-0
// Two stars of a title screen.
#include "home/scene.h"
#include "judge/numbers.h"

namespace {

constexpr double h = 0.1;  // [s]
constexpr std::size_t steps = 300, stars = 2;
constexpr double mu[stars] = {40, 20};  // [m^3/s^2]

std::vector<judge::State> turned(judge::Student& who) {
  const judge::State first{{-1.6, 0, 0}, {0, -1, 0}}, second{{3.2, 0, 0}, {0, 2, 0}};
  const std::vector<double> asked = judge::as_numbers(
      static_cast<int>(steps), h, static_cast<int>(stars), first, mu[0], second, mu[1]);
  std::vector<judge::State> states{first, second};
  const std::vector<judge::State> later = judge::as_states(who.call(0, asked, 6 * stars * steps));
  states.insert(states.end(), later.begin(), later.end());
  return states;
}

void film(grade::Stage& stage, judge::Student& yours, judge::Student& right) {
  const std::vector<judge::State> mine = turned(yours), best = turned(right);
  const auto centre = [](const std::vector<judge::State>& states, std::size_t n) {
    return (mu[0] * states[stars * n].x + mu[1] * states[stars * n + 1].x) / (mu[0] + mu[1]);
  };
  for (std::size_t n = 0; n <= steps; ++n) {
    stage.picture(h);
    for (std::size_t star = 0; star < stars; ++star) {
      const std::string name = "star " + std::to_string(star);
      const Vec &mine_at = mine[stars * n + star].x, &best_at = best[stars * n + star].x;
      stage.trails(name, mine_at, best_at);
      stage.balls(name, mine_at, best_at, star == 0 ? 0.3 : 0.22);
    }
    stage.balls("centre", centre(mine, n), centre(best, n), 0.08);
    stage.label({0, -4.6, 0}, "centre of mass: " +
                                  grade::shown(std::round(1000 * length(centre(mine, n))) / 1000) +
                                  " m off");
  }
}

const grade::Staged staged({
    .exercise = "6-symplectic/stars-that-wander",
    .caption =
        "Two stars turn around each other for half a minute, in steps of a tenth of a second. "
        "The small dot is their centre of mass, which should stay where it is; that of the rings "
        "does. Under a step that changes a place too early yours moves off with both stars.",
    .view = {{-8, -5}, {8, 5}, 3},
    .film = film,
});

}  // namespace
