// SPDX-License-Identifier: MIT-0
#include "blows.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "parachute.h"

namespace {

template <class Scene>
EnergyAfterBlow on(const Scene& scene, Solved method, double speed, unsigned draw,
                   StoppingCriterion criterion) {
  if (method == Solved::bdf2) return after_blow(scene, speed, draw, bdf2_solved(criterion));
  return after_blow(scene, speed, draw, backward_euler_solved(criterion));
}

}  // namespace

EnergyAfterBlow after_blow(const std::string& net, Solved method, double speed, unsigned draw,
                           StoppingCriterion criterion) {
  if (net == "rope") return on(steel_rope, method, speed, draw, criterion);
  if (net == "cloth") return on(steel_cloth, method, speed, draw, criterion);
  throw std::logic_error("there is no net called " + net);
}

EnergyAfterBlow worst_of_three(const std::string& net, Solved method, double speed,
                               StoppingCriterion criterion) {
  EnergyAfterBlow found;
  for (const unsigned draw : three_draws) {
    const EnergyAfterBlow one = after_blow(net, method, speed, draw, criterion);
    found.most = std::max(found.most, one.most);
    found.left = std::max(found.left, one.left);
    found.solves = std::max(found.solves, one.solves);
  }
  return found;
}

void a_second(measure::Record& record) {
  auto& table = record.table("second", {{"t", "s"}, {"chain"}, {"rope"}, {"cloth"}, {"1 Hz"}});
  const auto c = energy_shares(steel_chain, gentle, 60, solved_once),
             r = energy_shares(steel_rope, gentle, 60, solved_once);
  const auto cl = energy_shares(steel_cloth, gentle, 60, solved_once);
  for (std::size_t n = 0; n <= 60; ++n) {
    const double left = std::pow(left_in_a_step(frame * swinging(1).omega), double(n));
    table.add({frame * double(n), c[n], r[n], cl[n], left});
  }
  record.number("chain-masses", steel_chain.count, measure::whole);
  record.number("rope-masses", steel_rope.count, measure::whole);
  record.number("rope-long", steel_rope.length, measure::whole, "m");
  record.number("cloth-side", steel_cloth.side, measure::whole);
  record.number("rope-sideways", sideways_swings(steel_rope), 2);
  record.number("first-rope", 100 * r[1], 2, "%");
  record.number("second-rope-2", 100 * energy_shares(steel_rope, gentle, 120, solved_once).back(),
                2, "%");
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
  record.number("bdf2-cloth", 100 * energy_shares(steel_cloth, gentle, 60, bdf2_once()).back(), 2,
                "%");
  record.number("bdf2-rope", 100 * energy_shares(steel_rope, gentle, 60, bdf2_once()).back(), 2,
                "%");
  record.number("bdf2-suspension", 100 * left_by_bdf2(undamped_suspension), 2, "%");
  const auto left = [](const scenes::Spring<>& spring) {
    return 100 * std::pow(left_in_a_step(frame * spring.omega), 60);
  };
  record.number("second-1hz", left(swinging(1)), 2, "%");
  record.number("second-2hz", left(swinging(2)), 2, "%");
  record.number("second-suspension", left(suspension), 2, "%");
}

void hard_blows(measure::Record& record) {
  auto& table = record.table("blows", {{"net"},
                                       {"method"},
                                       {"speed", "m/s", 2},
                                       {"one solve", "", 3},
                                       {"two solves", "", 3},
                                       {"enough", "", 3},
                                       {"solves", "", 2}});
  for (const char* net : {"rope", "cloth"}) {
    for (const auto& [name, method] :
         {std::pair{"backward Euler", Solved::backward_euler}, {"BDF2", Solved::bdf2}}) {
      for (const double speed : {1.0, 2.0, 5.0, 10.0, 20.0}) {
        const EnergyAfterBlow enough = worst_of_three(net, method, speed, until_close);
        table.add({net, name, speed, worst_of_three(net, method, speed, one_solve).most,
                   worst_of_three(net, method, speed, two_solves).most, enough.most,
                   enough.solves});
      }
    }
  }
  const EnergyAfterBlow cloth = worst_of_three("cloth", Solved::backward_euler, hard, one_solve);
  record.number("blow-cloth-most", cloth.most, 2);
  record.number("blow-cloth-left", cloth.left, 2);
  const auto of_backward_euler = [&](const std::string& net, double speed, std::size_t column) {
    const auto row = std::find_if(table.rows.begin(), table.rows.end(), [&](const auto& one) {
      return one[0].words == net && one[1].words == "backward Euler" && one[2].value == speed;
    });
    return (*row)[column].value;
  };
  record.number("blow-rope-5", of_backward_euler("rope", 5, 3), 2);
  record.number("blow-cloth-5", of_backward_euler("cloth", 5, 3), 2);
  record.number("blow-cloth-5-twice", of_backward_euler("cloth", 5, 4), 2);
  const EnergyAfterBlow harsh =
      after_blow("cloth", Solved::backward_euler, 5, harsh_draw, one_solve);
  record.number("harsh-draw", harsh_draw, measure::whole);
  record.number("blow-cloth-harsh", harsh.most, 2);
  record.number("blow-cloth-harsh-left", harsh.left, 2);
  record.number("blow-cloth-harsh-twice",
                after_blow("cloth", Solved::backward_euler, 3, harsh_draw, two_solves).most, 2);
  record.number("blow-100", worst_of_three("cloth", Solved::backward_euler, 100, until_close).most,
                2);
  const auto most_solves = [&](double speed) {
    double most = 0;
    for (const auto& row : table.rows) {
      if (row[2].value == speed) most = std::max(most, row[6].value);
    }
    return most;
  };
  record.number("solves-1", most_solves(1), 2);
  record.number("solves-20", most_solves(20), 2);
  record.number("blow-trapezoid", energy_shares(steel_rope, hard, 60, trapezoid_once).back(), 2);
}

void newton(measure::Record& record) {
  auto& table = record.table("newton", {{"iteration", "", measure::whole},
                                        {"parachute", "m/s", 2},
                                        {"rope, gentle", "m/s", 2},
                                        {"rope, hard", "m/s", 2},
                                        {"cloth, hard", "m/s", 2}});
  const std::vector<double> all[] = {changes_of_parachute(), newton_changes(steel_rope, gentle),
                                     newton_changes(steel_rope, hard),
                                     newton_changes(steel_cloth, hard)};
  for (std::size_t n = 0; n < all[3].size(); ++n) {
    std::vector<measure::Cell> row{double(n + 1)};
    for (const auto& one : all) row.push_back(n < one.size() ? one[n] : NAN);
    table.add(row);
  }
  record.number("iterations-parachute", double(all[0].size()), measure::whole);
  record.number("iterations-cloth-hard", double(all[3].size()), measure::whole);
}
