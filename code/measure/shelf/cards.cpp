// SPDX-License-Identifier: MIT-0
// The cards of the shelf, each as a table with the name of its header.
#include "measure/shelf_card.h"

int main(int argc, char** argv) {
  return measure::record(argc, argv, [](measure::Record& record) {
    for (const measure::ShelfCard& card : measure::every_shelf_card()) {
      measure::Table& table =
          record.table(card.header, {{"promise"}, {"kept"}, {"measured"}, {"digits"}, {"unit"}});
      for (const auto& [words, kept, measured, digits, unit] : card.promises) {
        table.add({words, kept ? "yes" : "no", measured, double(digits), unit});
      }
    }
  });
}
