// SPDX-License-Identifier: MIT-0
// Chapter 1: the same jump, in steps of one length under frames of any.
// [machine]
#include "../play/jumper.h"
#include "shelf/fixed_step.h"
using play::Jumper;
using play::Vec;

struct Machine {
  int rate;  // frames a second
  Jumper before, now;
  shelf::FixedStep<> clock{.h = 1.0 / 60};
  double highest = 0;

  void frame() {
    clock.frame(1.0 / rate, [&](double) {
      before = now;
      now.step(clock.h);
    });
    highest = drawn().y > highest ? drawn().y : highest;
  }

  Vec drawn() const { return before.x + clock.blend() * (now.x - before.x); }
};
// [machine]

// [main]
Machine at(double x, int rate) {
  const Jumper start{.x = {x, 0}};
  return {.rate = rate, .before = start, .now = start};
}

void draw(const Machine& machine, play::Film& film) {
  const double x = machine.now.x.x;
  film.circle(machine.drawn(), 0.12, "Euler");
  film.line({x - 0.2, machine.highest}, {x + 0.2, machine.highest}, "Euler");
  film.label({x, -0.45}, std::to_string(machine.rate) + " Hz");
}

int main() {
  Machine machines[] = {at(0, 20), at(1, 30), at(2, 60), at(3, 144)};
  play::Film film({-0.6, -0.6}, {3.8, 1.7}, 0.25);
  for (int tick = 0; tick < 792; ++tick) {
    for (Machine& machine : machines)
      if (tick % (720 / machine.rate) == 0) machine.frame();
    if (tick % 3 != 0) continue;
    film.picture(3 / 720.0);
    film.line({-0.6, 1.33}, {3.8, 1.33}, "scenery");
    for (const Machine& machine : machines) draw(machine, film);
  }
  for (const Machine& machine : machines)
    std::cout << machine.rate << " Hz: " << machine.highest << " m\n";
  return film.write("play.html");
}
// [main]
