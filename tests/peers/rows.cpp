// SPDX-License-Identifier: MIT-0
#include "rows.h"

#include <algorithm>
#include <cstddef>
#include <vector>

#include "measure/machine.h"

namespace peers {
namespace {

// Of two that contradict each other, the last one counts.
std::vector<std::string> with_ours_first(int count, char** arguments) {
  std::vector<std::string> all{arguments[0], "--benchmark_enable_random_interleaving=true",
                               "--benchmark_repetitions=15",
                               "--benchmark_report_aggregates_only=true"};
  all.insert(all.end(), arguments + 1, arguments + count);
  return all;
}

// What so many quarters of the values are not above.
double below(std::vector<double> values, std::size_t quarters) {
  std::ranges::sort(values);
  return values[quarters * (values.size() - 1) / 4];
}

}  // namespace

Benchmark* in_rounds(Benchmark* row) {
  const auto least = [](const std::vector<double>& v) { return *std::ranges::min_element(v); };
  const auto most = [](const std::vector<double>& v) { return *std::ranges::max_element(v); };
  const auto lower = [](const std::vector<double>& v) { return below(v, 1); };
  const auto upper = [](const std::vector<double>& v) { return below(v, 3); };
  return row->MinTime(0.02)
      ->ComputeStatistics("min", least)
      ->ComputeStatistics("lower", lower)
      ->ComputeStatistics("upper", upper)
      ->ComputeStatistics("max", most);
}

void lacks_row(const Row& row) {
  benchmark::AddCustomContext("lacks " + row.group + "/" + row.variant, row.note);
}

int measure_rows(int count, char** arguments) {
  benchmark::AddCustomContext("processor", measure::machine());
  benchmark::AddCustomContext("clock", measure::clock_rate());
  benchmark::AddCustomContext("flags", PEERS_FLAGS);
  benchmark::AddCustomContext("compiler", PEERS_COMPILER);
  benchmark::AddCustomContext("libraries", PEERS_LIBRARIES);
  std::vector<std::string> all = with_ours_first(count, arguments);
  std::vector<char*> pointers;
  for (std::string& argument : all) pointers.push_back(argument.data());
  int left = int(pointers.size());
  benchmark::Initialize(&left, pointers.data());
  if (benchmark::ReportUnrecognizedArguments(left, pointers.data())) return 2;
  benchmark::RunSpecifiedBenchmarks();
  benchmark::Shutdown();
  return 0;
}

}  // namespace peers
