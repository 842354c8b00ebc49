// SPDX-License-Identifier: MIT-0
// Chapter 4: one rope of stiff springs on a nail, moved by three methods.
// [ropes]
#include "../play.h"
#include "integrate/backward_euler.h"
#include "integrate/band_system.h"
#include "integrate/predicted_euler.h"
#include "integrate/symplectic_euler.h"
#include "scenes/rope.h"
using play::Vec;

const scenes::Rope<> rope{.count = 20, .k = 1e4};

struct Hanging {
  std::string method;
  Vec at;
  Eigen::VectorXd x = rope.start().x, v = rope.start().v;

  Vec place(int i) const { return at + Vec{x[3 * i], x[3 * i + 1]}; }
  bool whole() const { return x.allFinite() && x.lpNorm<Eigen::Infinity>() < 3; }
  void draw(play::Film& film) const {
    film.circle(at, 0.05, "scenery");
    film.label(at + Vec{0, -2.6}, whole() ? method : method + ", gone");
    if (!whole()) return;
    for (int i = 1; i < rope.count; ++i) film.line(place(i - 1), place(i), method);
  }
};
// [ropes]

// [second]
int main() {
  Hanging ropes[] = {
      {"symplectic Euler", {0, 0}}, {"predicted Euler", {3.4, 0}}, {"backward Euler", {6.8, 0}}};
  const auto jacobian = [](const auto& x, const auto& v, double t, auto add) {
    rope.jacobian(x, v, t, add);
  };
  integrate::BandSystem<5, decltype(jacobian)> system(jacobian);
  const double step = 1 / 60.0;
  play::Film film({-2.2, -4}, {9.2, 0.4}, 0.5);
  for (int frame = 0; frame < 120; ++frame) {
    film.picture(step);
    for (const Hanging& one : ropes) one.draw(film);
    for (Hanging& one : ropes) {
      if (!one.whole()) continue;
      bool done = true;
      if (one.method == "symplectic Euler")
        integrate::symplectic_euler(one.x, one.v, 0.0, step, rope);
      if (one.method == "predicted Euler")
        integrate::predicted_euler(one.x, one.v, 0.0, step, rope);
      if (one.method == "backward Euler")
        done = integrate::backward_euler(one.x, one.v, 0.0, step, rope, system);
      if (!done || !one.whole())
        std::cout << one.method << " is gone after " << frame + 1 << " frames\n";
    }
  }
  std::cout << "backward Euler: the end is " << -ropes[2].x[58] << " m below the nail\n";
  return film.write("play_rope.html");
}
// [second]
