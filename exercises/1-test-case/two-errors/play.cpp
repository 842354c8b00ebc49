// SPDX-License-Identifier: MIT-0
// A throw and a drone that may end so far beside the truth, in the steps that two runs foretell.
#include "format_values.h"
#include "home/scene.h"
#include "judge/method.h"

namespace {

constexpr double duration = 2, wanted = 0.4;  // [s], [m]

struct Flight {
  const char* name;
  judge::Method method;
  int per_step;
  judge::Start start;
  harness::Force force;
  Vec at;  ///< where its origin is in the picture

  judge::Path by(int steps) const {
    return judge::run(method, start, duration / steps, steps, 1, force);
  }
  Vec end() const { return judge::truth(start, duration, 1, 1, force).states.back().x; }
  double error(int steps) const { return length(by(steps).states.back().x - end()); }

  /// As many steps as two runs, of a hundredth and a 160th of the duration, lead to.
  int steps(judge::Student& who) const {
    const double h1 = duration / 100, h2 = duration / 160, e1 = error(100), e2 = error(160);
    const double order = grade::within(who.call(0, {h1, e1, h2, e2}, 1)[0], 0.5, 8);
    const double h = grade::within(who.call(1, {wanted, h1, e1, order}, 1)[0], 1e-4, 1);
    const double all = who.call(2, {duration, h, static_cast<double>(per_step)}, 1)[0];
    return static_cast<int>(grade::within(all / per_step, 1, 400));
  }
};

void draw(grade::Stage& stage, const Flight& flight, const judge::Path& path,
          const std::string& colour, double share) {
  const std::size_t steps = path.states.size() - 1, apart = 1 + steps / 60;
  const auto now = static_cast<std::size_t>(share * static_cast<double>(steps));
  for (std::size_t n = 0; n < now; n += apart)
    stage.ball("", flight.at + path.states[n].x, colour == "true" ? 0.16 : 0.12, colour);
  const std::string name = flight.name + colour;
  stage.trail(name, flight.at + path.states[now].x, colour);
  stage.ball(name, flight.at + path.states[now].x, colour == "true" ? 0.3 : 0.22, colour);
}

void film(grade::Stage& stage, judge::Student& yours, judge::Student& right) {
  const Flight flights[] = {
      {"Euler",
       judge::euler,
       1,
       {{0, 0, 0}, {8, 9, 0}},
       {harness::Force::falling, {9.81, 0, 0.01}},
       {}},
      {"Heun",
       judge::heun,
       2,
       {{4, 0, 0}, {0, 16, 0}},
       {harness::Force::spring, {4, 0}},
       {21, 3, 0}},
  };
  constexpr int pictures = 100;
  std::vector<judge::Path> mine, best;
  for (const Flight& one : flights) {
    mine.push_back(one.by(one.steps(yours)));
    best.push_back(one.by(one.steps(right)));
  }
  for (int picture = 0; picture <= pictures; ++picture) {
    stage.picture(duration / pictures);
    for (std::size_t n = 0; n < mine.size(); ++n) {
      const Flight& one = flights[n];
      stage.ball("target", one.at + one.end(), wanted, "scenery");
      draw(stage, one, best[n], "true", picture / double(pictures));
      draw(stage, one, mine[n], "yours", picture / double(pictures));
      stage.label({n == 0 ? 7.0 : 21.0, -2.3, 0},
                  std::string(one.name) + ": " + grade::counted(mine[n].states.size() - 1, "step"));
    }
  }
}

const grade::Staged staged({
    .exercise = "1-test-case/two-errors",
    .caption =
        "Two flights, by Euler's method and by Heun's, in as many steps as your three functions "
        "make of two trial runs. Each dot is a step. The grey disc has the radius of the wanted "
        "error, 0.4 m around the true end, and the right number of steps ends at its rim: too "
        "few end outside it, and too many cost more than they must.",
    .view = {{-1, -3}, {26.5, 8}, 0.5},
    .film = film,
});

}  // namespace
