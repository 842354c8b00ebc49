// SPDX-License-Identifier: MIT-0
#include "blows.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

#include "parachute.h"

void a_second(measure::Record& record) {
  auto& table = record.table("second", {{"t", "s"}, {"chain"}, {"rope"}, {"cloth"}, {"1 Hz"}});
  const auto c = shares(steel_chain, gentle, 60, solved_once),
             r = shares(steel_rope, gentle, 60, solved_once);
  const auto cl = shares(steel_cloth, gentle, 60, solved_once);
  for (std::size_t n = 0; n <= 60; ++n) {
    const double left = std::pow(left_in_a_step(frame * swinging(1).omega), double(n));
    table.add({frame * double(n), c[n], r[n], cl[n], left});
  }
  record.number("first-chain", 100 * c[1], 2, "%");
  record.number("second-rope", 100 * r[60], 2, "%");
  record.number("second-cloth", 100 * cl[60], 2, "%");
  for (const int times : {1, 2}) {
    record.number("bdf2-" + std::to_string(times) + "hz", 100 * left_by_bdf2(swinging(times)), 2,
                  "%");
  }
  record.number("bdf2-begun-backward", 100 * left_by_bdf2(swinging(1), measure::backward_euler), 3,
                "%");
  record.number("bdf2-begun-trapezoid", 100 * left_by_bdf2(swinging(1), measure::trapezoid), 3,
                "%");
  record.number("bdf2-cloth", 100 * shares(steel_cloth, gentle, 60, bdf2_once()).back(), 2, "%");
  record.number("bdf2-rope", 100 * shares(steel_rope, gentle, 60, bdf2_once()).back(), 2, "%");
  record.number("bdf2-suspension", 100 * left_by_bdf2(undamped_suspension), 2, "%");
  const auto left = [](const scenes::Spring<>& spring) {
    return 100 * std::pow(left_in_a_step(frame * spring.omega), 60);
  };
  record.number("second-1hz", left(swinging(1)), 2, "%");
  record.number("second-2hz", left(swinging(2)), 2, "%");
  record.number("second-suspension", left(suspension), 2, "%");
}

void hard_blow(measure::Record& record) {
  auto& blow = record.table("blow", {{"t", "s"}, {"one solve"}, {"two solves"}, {"to the end"}});
  const auto once = shares(steel_rope, hard, 60, solved_once),
             end = shares(steel_rope, hard, 60, to_the_end);
  const auto twice = shares(steel_rope, hard, 60, solved_twice);
  for (std::size_t n = 0; n <= 60; ++n) {
    blow.add({frame * double(n), once[n], twice[n], end[n]});
  }
  record.number("blow-once", *std::max_element(once.begin(), once.end()), 3);
  record.number("blow-end", end[60], 2);
  record.number("blow-twice", twice[60], 2);
  record.number("blow-twice-cloth", shares(steel_cloth, hard, 60, solved_twice).back(), 2);
  const auto most = [](const auto& scene) {
    const auto left = shares(scene, hard, 60, bdf2_once());
    return *std::max_element(left.begin(), left.end());
  };
  record.number("blow-bdf2", most(steel_rope), 2);
  record.number("blow-bdf2-cloth", most(steel_cloth), 2);
  record.number("blow-trapezoid", shares(steel_rope, hard, 60, trapezoid_once).back(), 2);
  record.number("trapezoid-solves", solves_of_trapezoid(steel_rope, hard, 60), 2);
  const auto cloth_trap = shares(steel_cloth, hard, 60, trapezoid_once);
  record.number("blow-trapezoid-cloth", cloth_trap.back(), 2);
}

void newton(measure::Record& record) {
  auto& table = record.table("newton", {{"iteration", "", measure::whole},
                                        {"parachute", "m/s", 2},
                                        {"rope, gentle", "m/s", 2},
                                        {"rope, hard", "m/s", 2},
                                        {"cloth, hard", "m/s", 2}});
  const std::vector<double> all[] = {changes_of_parachute(), changes(steel_rope, gentle),
                                     changes(steel_rope, hard), changes(steel_cloth, hard)};
  for (std::size_t n = 0; n < all[3].size(); ++n) {
    std::vector<measure::Cell> row{double(n + 1)};
    for (const auto& one : all) row.push_back(n < one.size() ? one[n] : NAN);
    table.add(row);
  }
  record.number("iterations-parachute", double(all[0].size()), measure::whole);
  record.number("iterations-cloth-hard", double(all[3].size()), measure::whole);
}
