// SPDX-License-Identifier: MIT-0
#include "home/stage.h"

#include <algorithm>
#include <cmath>

#include "format_values.h"
#include "replace_all.h"

namespace grade {
namespace {

bool is_somewhere(const Vec& at) {
  return std::isfinite(at.x) && std::isfinite(at.y);
}

}  // namespace

Stage::Stage(const View& view) : view_(view), film_(view.from, view.to, view.pace) {}

void Stage::picture(double seconds) {
  film_.picture(seconds);
}

void Stage::ball(const std::string& name, const Vec& at, double radius, const std::string& colour) {
  film_.circle(seen(name, at), radius, colour);
}

void Stage::line(const Vec& from, const Vec& to, const std::string& colour) {
  film_.line(seen("", from), seen("", is_somewhere(to) ? to : from), colour);
}

void Stage::box(const std::string& name, const Vec& centre, const Vec& size,
                const std::string& colour) {
  const play::Vec middle = seen(name, centre);
  const play::Vec corner{size.x / 2, size.y / 2}, other{size.x / 2, -size.y / 2};
  film_.line(middle - corner, middle + other, colour);
  film_.line(middle + other, middle + corner, colour);
  film_.line(middle + corner, middle - other, colour);
  film_.line(middle - other, middle - corner, colour);
}

void Stage::trail(const std::string& name, const Vec& to, const std::string& colour) {
  film_.trail(seen(name, to), colour);
}

void Stage::balls(const std::string& name, const Vec& yours, const Vec& right, double radius) {
  ball(name + " as it should be", right, 1.3 * radius, "true");
  ball(name, yours, radius, "yours");
}

void Stage::boxes(const std::string& name, const Vec& yours, const Vec& right, const Vec& size) {
  box(name + " as it should be", right, size, "true");
  box(name, yours, size, "yours");
}

void Stage::trails(const std::string& name, const Vec& yours, const Vec& right) {
  trail(name + " as it should be", right, "true");
  trail(name, yours, "yours");
}

void Stage::lines(const Vec& from, const Vec& yours, const Vec& right) {
  line(from, right, "true");
  line(from, yours, "yours");
}

void Stage::label(const Vec& centre, const std::string& words) {
  film_.label({centre.x, centre.y}, replace_all(replace_all(words, "\\", "\\\\"), "'", "\\'"));
}

play::Vec Stage::seen(const std::string& name, const Vec& at) {
  play::Vec& last = last_[name];
  const play::Vec room = view_.to - view_.from;
  if (is_somewhere(at))
    last = {std::clamp(at.x, view_.from.x - room.x, view_.to.x + room.x),
            std::clamp(at.y, view_.from.y - room.y, view_.to.y + room.y)};
  return last;
}

double within(double value, double low, double high) {
  return value >= low ? std::min(value, high) : low;
}

std::string shown(double value, int digits) {
  return std::isfinite(value) ? number(value, digits) : "–";
}

}  // namespace grade
