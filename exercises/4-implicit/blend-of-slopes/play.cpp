// SPDX-License-Identifier: MIT-0
// Things on brakes and springs, stepped with a share of the slope at the end.
#include "home/scene.h"

namespace {

constexpr int steps = 90;
constexpr double reach = 4, farthest = 5.2;  // of the first swing, and that is drawn [m]
constexpr double brake = 20;                 // c h
enum Function { left_of_brake, left_of_swing, longest_step, least_theta };

using Places = std::vector<double>;

/// What is left after each step if each leaves the same share.
Places shares(double left) {
  Places places{reach};
  while (places.size() <= steps) places.push_back(left * places.back());
  return places;
}

/// A damped spring, x'' = -omega^2 x - 2 zeta omega x'; with no step to take, it stays.
Places spring(double theta, double omega, double zeta, double h) {
  Places places{reach};
  double x = reach, v = 0;
  if (!(h > 0 && std::isfinite(h))) h = 0;
  while (places.size() <= steps) {
    const double k = omega * omega, c = 2 * zeta * omega, at_end = theta * h;
    const double x_known = x + (1 - theta) * h * v;
    const double v_known = v - (1 - theta) * h * (k * x + c * v);
    v = (v_known - at_end * k * x_known) / (1 + at_end * c + at_end * at_end * k);
    x = x_known + at_end * v;
    places.push_back(x);
  }
  return places;
}

/// All six, from left to right and from above.
std::vector<Places> moved(judge::Student& who, judge::Student& right) {
  constexpr double theta = 0.3, omega = 5, light = 0.3, heavy = 1.5;
  const double least = who.call(least_theta, {brake, 0, 0}, 1)[0];
  Places swing = shares(who.call(left_of_swing, {0.55, 0.5, 0}, 1)[0]);
  for (std::size_t n = 0; n < swing.size(); ++n) swing[n] *= std::cos(0.5 * static_cast<double>(n));
  const double h = who.call(longest_step, {theta, omega, light}, 1)[0];
  return {shares(who.call(left_of_brake, {0.5, brake, 0}, 1)[0]),
          shares(right.call(left_of_brake, {least, brake, 0}, 1)[0]),
          swing,
          spring(theta, omega, heavy, 1.1 * who.call(longest_step, {theta, omega, heavy}, 1)[0]),
          spring(theta, omega, light, 0.9 * h),
          spring(theta, omega, light, 1.1 * h)};
}

void film(grade::Stage& stage, judge::Student& yours, judge::Student& right) {
  const auto theta_of = [](judge::Student& who) {
    return who.call(least_theta, {brake, 0, 0}, 1)[0];
  };
  const double theta = theta_of(yours), its_theta = theta_of(right);
  const std::string least = "brake, θ = " + grade::shown(theta);
  const std::string names[] = {"brake, trapezoid rule", least,
                               "swing, θ = 0.55",       "ζ = 1.5, 10 % longer",
                               "ζ = 0.3, 10 % shorter", "ζ = 0.3, 10 % longer"};
  const auto on_dial = [](double share) { return Vec{8 + 8 * share, 7.2, 0}; };
  const std::vector<Places> mine = moved(yours, right), best = moved(right, right);
  for (std::size_t n = 0; n <= steps; ++n) {
    stage.picture(0.08);
    stage.lines(on_dial(0), on_dial(theta), on_dial(its_theta));
    stage.balls("dial", on_dial(theta), on_dial(its_theta), 0.13);
    for (std::size_t thing = 0; thing < mine.size(); ++thing) {
      const Vec rest{12 * static_cast<double>(thing % 2), 3 * (2 - static_cast<double>(thing / 2)),
                     0};
      const Vec at = rest + Vec{std::clamp(mine[thing][n], -farthest, farthest), 0, 0};
      const Vec ring = rest + Vec{std::clamp(best[thing][n], -farthest, farthest), 0, 0};
      stage.line(rest - Vec{0, 0.5, 0}, rest + Vec{0, 0.5, 0}, "scenery");
      stage.lines(rest, at, ring);
      stage.balls(names[thing], at, ring, 0.28);
      stage.label(rest - Vec{0, 1.1, 0}, names[thing]);
    }
  }
}

const grade::Staged staged({
    .exercise = "4-implicit/blend-of-slopes",
    .caption =
        "A picture for each step. Above, a velocity on a brake: by the trapezoid rule it "
        "trembles, and with the least θ, which yours turns the dial to, it is gone at once. "
        "Below them a swing that your factor damps, and springs with θ = 0.3 at steps around "
        "your longest: what is 10 % shorter comes to rest, and what is 10 % longer leaves, and "
        "is drawn at most 5.2 m out. The rings have the right numbers.",
    .view = {{-5.5, -1.8}, {17.5, 7.7}},
    .film = film,
});

}  // namespace
