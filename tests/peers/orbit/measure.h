// SPDX-License-Identifier: MIT-0
// What both programs about orbits do.
#pragma once
#include <algorithm>
#include <cstdio>
#include <map>

#include "orbit/variants.h"

namespace orbit {

/// Everyone's versions that make sense of so many planets.
template <std::size_t count>
std::vector<Variant> variants() {
  std::vector<Variant> all;
  for (const auto& some : {symplectic_euler_variants<count>(), velocity_verlet_variants<count>(),
                           rk4_variants<count>(), dopri5_variants<count>(), sprk_variants()}) {
    all.insert(all.end(), some.begin(), some.end());
  }
  std::erase_if(all, [](const Variant& variant) {
    return variant.planets == (count == 1 ? For::many : For::one);
  });
  return all;
}

/// Ten coarse steps, where no two formulas look alike. Each rounds numbers of up to 2 some thirty
/// times, which comes to 1e-13; the rest is for roundings that grow on their way.
inline bool agree(const std::vector<Variant>& variants, std::size_t count) {
  std::map<std::string, std::vector<State>> by_hand;
  bool all = true;
  for (const auto& [row, run, planets, _] : variants) {
    const std::vector<State> end = run(start(count), 10, 0.05);
    const std::vector<State>& wanted = by_hand.try_emplace(row.group, end).first->second;
    double away = 0;
    for (std::size_t i = 0; i < count; ++i) away = std::max(away, distance(end[i], wanted[i]));
    if (away <= 1e-12) continue;
    std::fprintf(stderr, "%s: %s ends %g from where the formula by hand ends\n", row.group.c_str(),
                 row.variant.c_str(), away);
    all = false;
  }
  return all;
}

/// Measures each row.
/// @return the program's exit code
template <std::size_t count>
int measure(int argument_count, char** arguments) {
  constexpr long steps = count == 1 ? 20'000 : 200;
  const std::vector<Variant> all = variants<count>();
  if (!agree(all, count)) return 1;
  for (const Variant& variant : all) {
    peers::Row row = variant.row;
    if (count > 1) row.group = std::to_string(count) + " orbits, " + row.group;
    peers::add_row(row, steps * long(count) / variant.steps_for_one, [run = variant.run] {
      benchmark::DoNotOptimize(run(start(count), steps, 1e-3));
    });
  }
  return peers::measure_rows(argument_count, arguments);
}

}  // namespace orbit
