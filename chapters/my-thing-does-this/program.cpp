// SPDX-License-Identifier: MIT-0
// The pictures of the page of complaints, a table for each.
#include <cstddef>
#include <vector>

#include "measure/record.h"
#include "sketch.h"

int main(int argc, char** argv) {
  return measure::record(argc, argv, [](measure::Record& record) {
    for (const Sketch& one : every_sketch()) {
      std::vector<measure::Column> columns{{one.across, "", 4}};
      for (const Line& line : one.lines) columns.push_back({line.label, one.unit, 4});
      measure::Table& table = record.table(one.name, columns);
      const std::size_t count = one.lines.front().values.size();
      for (std::size_t i = 0; i < count; ++i) {
        std::vector<measure::Cell> row{one.length * double(i) / double(count - 1)};
        for (const Line& line : one.lines) row.push_back(line.values[i]);
        table.add(row);
      }
    }
  });
}
