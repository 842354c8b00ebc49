// SPDX-License-Identifier: MIT-0
/// @file
/// How large the methods leave the cat, and where they carry it.
#pragma once
#include <string>

#include "cat.h"
#include "integrate/symplectic_euler.h"
#include "measure/compiled.h"
#include "measure/record.h"

inline void cats(measure::Record& record) {
  auto& shears = record.table("shears", {{"x"}, {"v"}, {"kicked v"}, {"drifted x"}});
  for (const auto& before : closed(cat(20))) {
    auto after = before;
    integrate::symplectic_euler(after.x, after.v, 0.0, 1.0, wrecking_ball);
    shears.add({before.x, before.v, after.v, after.x});
  }
  const auto follow = [&](const std::string& name, const measure::Method& step) {
    auto& table = record.table(name, {{"third"}, {"x", "rad"}, {"v", "rad/s"}});
    for (int third = 0; third <= 3; ++third) {
      const auto now = carried(step, wrecking_ball, cat(20), cat_step, third * cat_steps / 3);
      for (const auto& point : closed(now)) table.add({double(third), point.x, point.v});
    }
  };
  record.number("cat-third", cat_steps / 3, measure::whole);
  follow("cat-euler", method::euler);
  follow("cat-symplectic", method::symplectic_euler);

  auto& table = record.table("areas", {{"method"}, {"area at the end", "%", 5}});
  const auto measured = [&](const std::string& name, const measure::Method& step) {
    const Outline start = cat(500);
    const Outline end = carried(step, wrecking_ball, start, cat_step, cat_steps);
    const double left = 100 * area(end) / area(start);
    table.add({name, left});
    return left;
  };
  measured("Euler", method::euler);
  measured("midpoint", method::midpoint);
  measured("RK4", method::rk4);
  record.number("cat-backward", measured("backward Euler", method::backward_euler_newton), 3, "%");
  measured("symplectic Euler", method::symplectic_euler);
  measured("velocity Verlet", method::velocity_verlet);
  measured("Yoshida 4", method::yoshida4);
}
