// SPDX-License-Identifier: MIT-0
// Chapter 7: which to use. Every method on every scene, and what it costs.
#include <cmath>
#include <string>
#include <vector>

#include "choose/entrants.h"
#include "float_floor.h"
#include "kerb.h"
#include "level.h"
#include "level_by_choice.h"
#include "map.h"
#include "particles.h"
#include "peers.h"
#include "position_error.h"
#include "summary_table.h"
#include "verdicts.h"
#include "work_precision.h"
#include "your_spring.h"

using measure::Record;

namespace {

void one_for_all(Record& record) {
  auto& table = record.table("level", {{"method"},
                                       {"jump", "cm", 2},
                                       {"leaf", "cm", 2},
                                       {"suspension", "cm", 2},
                                       {"hatch", "cm", 2},
                                       {"lamp", "cm", 2},
                                       {"shuttle", "cm", 2}});
  for (const measure::Method* method : entrants) {
    std::vector<measure::Cell> row{method->name};
    for_each_thing([&](const auto&, const auto& scene, double seconds) {
      row.push_back(100 * max_position_error(*method, scene, frame, seconds));
    });
    table.add(row);
  }
}

void one_for_all_numbers(Record& record) {
  record.number("rate", 1 / frame, measure::whole, "Hz");
  const auto number = [&](const char* name, const measure::Method& method, const auto& scene,
                          double seconds, double unit, const char* of) {
    record.number(name, unit * max_position_error(method, scene, frame, seconds), 2, of);
  };
  number("jump-euler", method::euler, height_of_jump, 1, 100, "cm");
  number("suspension-euler", method::euler, suspension, 1, 100, "cm");
  number("lamp-euler", method::euler, lamp, 10, 1, "m");
  number("suspension-symplectic", method::symplectic_euler, suspension, 1, 100, "cm");
  number("lamp-symplectic", method::symplectic_euler, lamp, 10, 100, "cm");
  number("leaf-symplectic", method::symplectic_euler, leaf, 2, 100, "cm");
  number("shuttle-symplectic", method::symplectic_euler, shuttle, 8, 100, "cm");
  number("shuttle-backward", method::backward_euler, shuttle, 8, 1, "m");
  number("hatch-backward", method::backward_euler, hatch, 1, 100, "cm");
  number("hatch-divided", method::linear_damping_implicit_last, hatch, 1, 100, "cm");
}

}  // namespace

int main(int argc, char** argv) {
  return measure::record(argc, argv, [&](Record& record) {
    one_for_all(record);
    one_for_all_numbers(record);
    verdicts(record);
    all_work(record);
    stability_map(record);
    your_spring(record);
    floor_of_float(record);
    memory_wall(record);
    libraries(record);
    level_again(record);
    over_a_kerb(record);
    example_choice(record);
    summary_table(record);
  });
}
