// SPDX-License-Identifier: MIT-0
// The cards of all methods, each as a table with the name of its function.
#include <algorithm>
#include <string>
#include <vector>

#include "measure/card.h"

namespace {

// Notes for a reader of the card, on its lines.
std::string note(const measure::Card& card) {
  const auto& rows = card.rows;
  const bool limits = std::any_of(rows.begin(), rows.end(), [](const measure::CardRow& row) {
    return row.name.find("limit") != std::string::npos;
  });
  std::string words = limits ? "Limits are rounded down. " : "";
  if (!card.timed_on.empty()) {
    words +=
        "The time is one body's, each step waiting for the one before: in double, on one "
        "thread, compiled like the other programs of the book.";
  }
  return words.substr(0, words.find_last_not_of(' ') + 1);
}

void write(measure::Record& record, const measure::Card& card) {
  measure::Table& table = record.table(
      card.method, {{"name"}, {"about"}, {"asked"}, {"measured"}, {"digits"}, {"unit"}});
  table.add({"suits", "card", "suits", card.suits, measure::whole, "1"});
  for (const auto& [name, about, asked, measured, digits, unit] : card.rows) {
    table.add({name, about, asked, measured, double(digits), unit});
  }
  if (!card.timed_on.empty()) {
    table.add({"time", "Cost of a step", "time, on " + card.timed_on, "time:card/" + card.method, 2,
               "ns"});
  }
  if (const std::string words = note(card); !words.empty()) {
    table.add({"note", "card", "note", words, measure::whole, "1"});
  }
}

}  // namespace

int main(int argc, char** argv) {
  return measure::record(argc, argv, [](measure::Record& record) {
    for (const measure::Card& card : measure::every_card()) write(record, card);
  });
}
