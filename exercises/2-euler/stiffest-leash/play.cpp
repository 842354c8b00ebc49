// SPDX-License-Identifier: MIT-0
// Dogs on leashes, with a step just below your longest one and with one just above it.
#include "home/scene.h"
#include "judge/method.h"

namespace {

struct Leash {
  const char* name;
  double lane, k, c, m;  // [N/m], [N s/m], [kg]

  double longest(judge::Student& who) const { return who.call(0, {k, c, m}, 1)[0]; }

  /// So many steps of Euler's method; with no step that it could take, the dog stays.
  judge::Path steps(double h, int steps) const {
    const Acceleration pull = [this](const Vec& x, const Vec& v, double) {
      return (-k / m) * x - (c / m) * v;
    };
    return judge::run(judge::euler, {{3, 0, 0}, {}}, h > 0 ? h : 0, steps, 1, pull);
  }
};

constexpr Leash leashes[] = {{"it swings", 4, 200, 30, 20}, {"it creeps", 0, 200, 200, 20}};

/// A dog that has left is drawn at the end of its lane.
Vec seen(const Vec& x) {
  return {std::clamp(x.x, -5.5, 5.5), 0, 0};
}

void film(grade::Stage& stage, judge::Student& yours, judge::Student& right) {
  constexpr int steps = 240;
  struct Dog {
    std::string name;
    Vec post;
    judge::Path yours, right;
  };
  std::vector<Dog> dogs;
  for (const Leash& leash : leashes) {
    const double mine = leash.longest(yours), best = leash.longest(right);
    for (const double times : {0.9, 1.1}) {
      const bool within = times < 1;
      const std::string name = std::string(leash.name) + ", " + grade::shown(times * mine) + " s";
      dogs.push_back({name,
                      {within ? 0.0 : 14.0, leash.lane, 0},
                      leash.steps(times * mine, steps),
                      leash.steps(times * best, steps)});
    }
  }
  for (std::size_t n = 0; n <= steps; ++n) {
    stage.picture(0.03);
    for (const Dog& dog : dogs) {
      const Vec mine = dog.post + seen(dog.yours.states[n].x);
      const Vec best = dog.post + seen(dog.right.states[n].x);
      stage.line(dog.post - Vec{0, 0.6, 0}, dog.post + Vec{0, 0.6, 0}, "scenery");
      stage.lines(dog.post, mine, best);
      stage.balls(dog.name, mine, best, 0.3);
      stage.label(dog.post - Vec{0, 1.1, 0}, dog.name);
    }
    stage.label({0, 6, 0}, "10 % shorter");
    stage.label({14, 6, 0}, "10 % longer");
  }
}

const grade::Staged staged({
    .exercise = "2-euler/stiffest-leash",
    .caption =
        "Two leashes by Euler's method, a picture for each step. On the left the step is 10 % "
        "shorter than your longest one, and both dogs should come to rest; on the right it is 10 "
        "% longer, and both should leave, to be drawn at most 5.5 m out. The rings take the "
        "right steps. If yours does the same on both sides, its limit lies elsewhere.",
    .view = {{-6, -2.2}, {20, 6.8}},
    .film = film,
});

}  // namespace
