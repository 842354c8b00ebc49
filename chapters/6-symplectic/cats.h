// SPDX-License-Identifier: MIT-0
/// @file
/// How large the methods leave the cat, and where they carry it.
#pragma once
#include <string>

#include "cat.h"
#include "measure/implicit_methods.h"
#include "measure/methods_with_memory.h"
#include "measure/record.h"

inline void cats(measure::Record& record) {
  auto& shears = record.table("shears", {{"x"}, {"v"}, {"kicked v"}, {"drifted x"}});
  for (const auto& before : closed(cat(20))) {
    auto after = before;
    integrate::symplectic_euler(after.x, after.v, 0.0, 1.0, wrecking_ball);
    shears.add({before.x, before.v, after.v, after.x});
  }
  const auto follow = [&](const std::string& name, auto step) {
    auto& table = record.table(name, {{"third"}, {"x", "rad"}, {"v", "rad/s"}});
    for (int third = 0; third <= 3; ++third) {
      const auto now = carried(step, wrecking_ball, cat(20), cat_step, third * cat_steps / 3);
      for (const auto& point : closed(now)) table.add({double(third), point.x, point.v});
    }
  };
  follow("cat-euler", measure::euler);
  follow("cat-symplectic", measure::symplectic_euler);

  auto& table = record.table("areas", {{"method"}, {"area at the end", "%", 5}});
  const auto measured = [&](const std::string& name, auto step) {
    const Outline start = cat(500);
    const Outline end = carried(step, wrecking_ball, start, cat_step, cat_steps);
    const double left = 100 * area(end) / area(start);
    table.add({name, left});
    return left;
  };
  measured("Euler", measure::euler);
  measured("midpoint", measure::midpoint);
  measured("RK4", measure::rk4);
  record.number("cat-backward", measured("backward Euler", measure::backward_euler_newton), 3, "%");
  measured("symplectic Euler", measure::symplectic_euler);
  measured("velocity Verlet", measure::velocity_verlet);
  measured("Yoshida 4", measure::yoshida4);
}
