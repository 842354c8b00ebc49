// SPDX-License-Identifier: MIT-0
// The page of the engines: what ten steps of free fall tell.
#include "drop.h"
#include "measure/methods.h"
#include "measure/record.h"

int main(int argc, char** argv) {
  return measure::record(argc, argv, [](measure::Record& record) {
    auto& table = record.table("drop", {{"a step of"}, {"falls, in g h²", "", 4}});
    table.add({"symplectic Euler, velocity first", fallen(measure::symplectic_euler)});
    table.add({"the same in two substeps", fallen(measure::symplectic_euler, 2)});
    table.add({"the same in four", fallen(measure::symplectic_euler, 4)});
    table.add({"backward Euler", fallen(measure::backward_euler_newton)});
    table.add({"velocity Verlet", fallen(measure::velocity_verlet)});
    table.add({"RK4", fallen(measure::rk4)});
    table.add({"symplectic Euler's twin, position first",
               fallen(measure::symplectic_euler_position_first)});
    table.add({"Euler", fallen(measure::euler)});
  });
}
