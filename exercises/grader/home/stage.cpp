// SPDX-License-Identifier: MIT-0
#include "home/stage.h"

#include <algorithm>
#include <cmath>

#include "replace_all.h"

namespace grade {

Stage::Stage(const View& view) : view_(view), film_(view.from, view.to, view.pace) {}

void Stage::picture(double seconds) {
  film_.picture(seconds);
}

void Stage::ball(const std::string& name, const Vec& at, double radius, const std::string& colour) {
  film_.circle(seen(name, at), radius, colour);
}

void Stage::line(const Vec& from, const Vec& to, const std::string& colour) {
  film_.line(seen("", from), seen("", to), colour);
}

void Stage::trail(const std::string& name, const Vec& to, const std::string& colour) {
  film_.trail(seen(name, to), colour);
}

void Stage::label(const Vec& centre, const std::string& words) {
  film_.label({centre.x, centre.y}, replace_all(replace_all(words, "\\", "\\\\"), "'", "\\'"));
}

play::Vec Stage::seen(const std::string& name, const Vec& at) {
  play::Vec& last = last_[name];
  const play::Vec room = view_.to - view_.from;
  if (std::isfinite(at.x) && std::isfinite(at.y))
    last = {std::clamp(at.x, view_.from.x - room.x, view_.to.x + room.x),
            std::clamp(at.y, view_.from.y - room.y, view_.to.y + room.y)};
  return last;
}

}  // namespace grade
