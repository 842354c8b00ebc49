// SPDX-License-Identifier: MIT-0
// The cards of all methods, each as a table with the name of its function.
#include "measure/card.h"
#include "measure/cost.h"

namespace {

void write(measure::Record& record, const measure::Card& card) {
  measure::Table& table = record.table(
      card.method, {{"name"}, {"about"}, {"asked"}, {"measured"}, {"digits"}, {"unit"}});
  table.add({"suits", "card", "suits", card.suits, measure::whole, "1"});
  for (const auto& [name, about, asked, measured, digits, unit] : card.rows) {
    table.add({name, about, asked, measured, double(digits), unit});
  }
  if (!card.seconds_per_step) return;
  table.add({"time", "Cost of a step", "time, on " + card.timed_on, 1e9 * card.seconds_per_step(),
             2, "ns"});
  table.add({"note", "card", "note",
             "The time is the best of nine runs on " + measure::machine() +
                 ": in double, on one thread, compiled like the other programs of the book.",
             measure::whole, "1"});
}

}  // namespace

int main(int argc, char** argv) {
  return measure::record(argc, argv, [](measure::Record& record) {
    for (const measure::Card& card : measure::every_card()) write(record, card);
  });
}
