// SPDX-License-Identifier: MIT-0
// The frames after a hitch, on machines that do and do not keep up.
#include "home/scene.h"

namespace {

constexpr double h = 1.0 / 240, draw = 0.02, hitch = 0.3;  // [s]
constexpr int most = 16, frames = 34, hitch_at = 8;

struct Machine {
  const char* name;
  double at, cost;  // of a step [s]

  /// The frames, each long enough to be drawn with the steps that the one before is owed.
  std::vector<double> lengths(judge::Student& who) const {
    std::vector<double> lengths{draw};
    double saved = 0;
    while (lengths.size() < frames) {
      const bool hitches = lengths.size() == hitch_at;
      const std::vector<double> answer =
          who.call(0, {saved, lengths.back(), h, static_cast<double>(most)}, 2);
      saved = answer[1];
      constexpr double longest = 0.6;
      lengths.push_back(hitches ? hitch : grade::within(draw + answer[0] * cost, 0, longest));
    }
    return lengths;
  }

  double settled(judge::Student& who) const {
    return who.call(1, {draw, cost, h, static_cast<double>(most)}, 1)[0];
  }

  /// Where a frame is drawn: a metre is four milliseconds.
  Vec top(double frame, double length) const { return {at + frame, 250 * length, 0}; }
};

void film(grade::Stage& stage, judge::Student& yours, judge::Student& right) {
  constexpr double apart = frames + 8;
  const Machine machines[] = {{"0.5 h a step", 0, 0.5 * h},
                              {"0.97 h a step", apart, 0.97 * h},
                              {"1.3 h a step", 2 * apart, 1.3 * h}};
  std::vector<std::vector<double>> all[2];
  std::vector<double> settled[2];
  for (const int who : {0, 1}) {
    for (const Machine& machine : machines) {
      all[who].push_back(machine.lengths(who == 0 ? yours : right));
      settled[who].push_back(machine.settled(who == 0 ? yours : right));
    }
  }
  for (std::size_t picture = 0; picture < frames; ++picture) {
    stage.picture(0.15);
    for (std::size_t m = 0; m < std::size(machines); ++m) {
      const Machine& machine = machines[m];
      const std::vector<double>&mine = all[0][m], &best = all[1][m];
      stage.line(machine.top(-1, 0), machine.top(frames, 0), "scenery");
      for (std::size_t n = 0; n <= picture; ++n) {
        const double frame = static_cast<double>(n);
        stage.lines(machine.top(frame, 0), machine.top(frame, mine[n]),
                    machine.top(frame, best[n]));
      }
      const double now = static_cast<double>(picture), foretold = settled[0][m];
      stage.balls(machine.name, machine.top(now, mine[picture]), machine.top(now, best[picture]),
                  0.7);
      stage.line(machine.top(-1, settled[1][m]), machine.top(frames, settled[1][m]), "true");
      stage.line(machine.top(-1, foretold), machine.top(frames, foretold), "yours");
      stage.label(machine.top(frames / 2, -0.02), machine.name);
      stage.label(machine.top(frames / 2, 0.32), grade::shown(1000 * foretold) + " ms");
    }
  }
}

const grade::Staged staged({
    .exercise = "1-test-case/too-long-a-frame",
    .caption =
        "Each bar is a frame, as high as it is long, on three machines that need 0.5 h, 0.97 h "
        "and 1.3 h to take a step of h; the ninth frame of each is a hitch of 300 ms. Your "
        "steps_due says how many steps the next frame pays for, and your settled_frame where the "
        "level line lies. What yours does not cover is right: bars that never come down are a "
        "debt that was kept, and a line where no bars end was foretold wrong.",
    .view = {{-3, -9}, {3 * frames + 18, 85}},
    .film = film,
});

}  // namespace
