// SPDX-License-Identifier: MIT-0
#pragma once
#include <benchmark/benchmark.h>

#include <string>

namespace peers {

/// One row of the report.
struct Row {
  std::string group;    ///< rows of a group do the same work; the first is what there is to reach
  std::string variant;  ///< who does the work, and how
  std::string note;     ///< what else to know, in one line
};

using Benchmark = benchmark::internal::Benchmark;

/// Long enough rounds, and the shortest and the longest of them for the report.
Benchmark* in_rounds(Benchmark* row);

/// Adds a row to the report.
/// @param steps  how many steps one call of `work` makes
/// @param work  called again and again
template <class Work>
Benchmark* add_row(const Row& row, long steps, Work work) {
  const auto measure = [note = row.note, steps, work](benchmark::State& state) {
    for (auto _ : state) work();
    using benchmark::Counter;
    state.counters["seconds_per_step"] =
        Counter(double(steps), Counter::kIsIterationInvariantRate | Counter::kInvert);
    state.SetLabel(note);
  };
  return in_rounds(benchmark::RegisterBenchmark((row.group + "/" + row.variant).c_str(), measure));
}

/// Says in the report that this system cannot measure a row, and why.
void lacks_row(const Row& row);

/// Measures all rows in turns, in random order.
/// @param arguments  those of Google Benchmark, stronger than the ones chosen here
/// @return the program's exit code
int measure_rows(int count, char** arguments);

}  // namespace peers
