// SPDX-License-Identifier: MIT-0
#include "film.h"

namespace level {

const grade::View film_view{{-15, -2}, {15, 15}};

namespace {

/// What stands still: the ground, a hook, two planets.
void draw_scenery(grade::Stage& stage) {
  stage.line({-15, 0, 0}, {15, 0, 0}, "scenery");
  stage.line({-4, 13, 0}, {-2, 13, 0}, "scenery");
  stage.ball("moon's planet", {10.5, 10, 0}, 0.7, "scenery");
  stage.ball("shuttle's planet", {5.2, 5.5, 0}, 0.3, "scenery");
}

constexpr double size = 0.35;
constexpr Vec camera_size{2.4, 1.5, 0};

/// As it should be, alone.
void draw_right(grade::Stage& stage, const Shown& shown, std::size_t n) {
  const auto& right = shown.right;
  for (std::size_t i = 1; i < right.size(); ++i) stage.line(right[i - 1][n], right[i][n], "true");
  const std::string& name = shown.part.name;
  const Look look = shown.part.look;
  const Vec& at = right.back()[n];
  if (look == Look::frame) return stage.box(name, at, camera_size, "true");
  if (look == Look::post) stage.line({at.x, 0, 0}, at, "true");
  if (look == Look::trail) stage.trail(name, at, "true");
  stage.ball(name, at, size, "true");
}

void draw_part(grade::Stage& stage, const Shown& shown, std::size_t n) {
  if (shown.yours.empty()) return draw_right(stage, shown, n);
  const auto& yours = shown.yours;
  const auto& right = shown.right;
  for (std::size_t i = 1; i < yours.size(); ++i) {
    stage.line(right[i - 1][n], right[i][n], "true");
    stage.line(yours[i - 1][n], yours[i][n], "yours");
  }
  const std::string& name = shown.part.name;
  const Look look = shown.part.look;
  const Vec &mine = yours.back()[n], &true_one = right.back()[n];
  if (look == Look::frame) return stage.boxes(name, mine, true_one, camera_size);
  if (look == Look::post) stage.lines({mine.x, 0, 0}, mine, true_one);
  if (look == Look::trail) stage.trails(name, mine, true_one);
  stage.balls(name, mine, true_one, size);
}

}  // namespace

void draw(grade::Stage& stage, const std::vector<Shown>& parts, const std::vector<double>& frames) {
  for (std::size_t n = 0; n < frames.size(); ++n) {
    stage.picture(frames[n]);
    draw_scenery(stage);
    for (const Shown& part : parts) draw_part(stage, part, n);
    stage.label({0, -1.2, 0}, "a clock and a camera");
    stage.label({-12, 8, 0}, "a hard spring");
    stage.label({-3, 14, 0}, "a chain");
    stage.label({10.5, 14, 0}, "a replay");
    stage.label({4, 8.6, 0}, "a shuttle");
  }
}

}  // namespace level
