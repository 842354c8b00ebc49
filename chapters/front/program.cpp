// SPDX-License-Identifier: MIT-0
// The figure of the front page: every method of the talks on one orbit, at one price.
#include <string>

#include "measure/methods.h"
#include "measure/record.h"
#include "race.h"

using measure::Record;

namespace {

template <class Step>
void follow(Record& record, const std::string& name, const Step& step) {
  auto& table = record.table(name, {{"t", "s"}, {"x", "m"}, {"y", "m"}});
  race(step, price, [&](double t, const auto& s) { table.add({t, s.x.x(), s.x.y()}); });
}

}  // namespace

int main(int argc, char** argv) {
  return measure::record(argc, argv, [](Record& record) {
    follow(record, "race-euler", measure::euler);
    follow(record, "race-midpoint", measure::midpoint);
    follow(record, "race-heun", measure::heun);
    follow(record, "race-rk4", measure::rk4);
    follow(record, "race-backward-euler", measure::backward_euler);
    follow(record, "race-predicted-euler", measure::predicted_euler<1>);
    follow(record, "race-verlet", measure::velocity_verlet);
    follow(record, "race-symplectic-euler", measure::symplectic_euler);

    record.number("price", price, measure::whole);
    record.number("turn", shuttle_turn, 1, "s");
    record.number("planet", 2 * planet, 1, "m");
    record.number("length", 2 * race_shuttle.semi_major, 2, "m");
  });
}
