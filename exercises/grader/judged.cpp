// SPDX-License-Identifier: MIT-0
#include "judged.h"

#include <algorithm>
#include <cstddef>

namespace grade {
namespace {

/// The findings of a test, as far as it tells one run from another.
std::string seen(const TestResult& test) {
  std::string all = test.held ? "held" : "failed";
  for (const Finding& finding : test.findings)
    if (!finding.held) all += "\n" + finding.got;
  return all;
}

bool alike(const Judged& one, const Judged& other) {
  return one.verdict == other.verdict && std::ranges::equal(one.tests, other.tests, {}, seen, seen);
}

std::string scores(const std::vector<Judged>& runs) {
  std::string text;
  for (std::size_t n = 0; n < runs.size(); ++n) {
    if (n > 0) text += n + 1 < runs.size() ? ", " : " and ";
    text += std::to_string(runs[n].score());
  }
  return text;
}

}  // namespace

int Judged::score() const {
  int sum = 0;
  for (const TestResult& test : tests) sum += test.held ? test.points : 0;
  return sum;
}

Verdict verdict(const Judged& judged) {
  const bool all = std::ranges::all_of(judged.tests, &TestResult::held);
  if (all) return Verdict::accepted;
  return judged.score() > 0 ? Verdict::partial : Verdict::wrong_answer;
}

Judged worst(std::vector<Judged> runs) {
  Judged least = *std::ranges::min_element(runs, {}, &Judged::score);
  const bool same =
      std::ranges::all_of(runs, [&](const Judged& run) { return alike(run, runs.front()); });
  if (same) return least;
  if (!least.why.empty()) least.why += "\n";
  const bool slow = std::ranges::any_of(
      runs, [](const Judged& run) { return run.verdict == Verdict::time_limit; });
  if (slow) {
    least.why += "Of " + std::to_string(runs.size()) +
                 " runs not all came to their end: it takes about as long as it may.";
    return least;
  }
  least.why += "your answer is random: asked the same " + std::to_string(runs.size()) +
               " times, it gave different answers, for " + scores(runs) +
               " points, and the fewest count. Is there a variable that nothing was written to, an "
               "index out of range, a clock, dice?";
  return least;
}

}  // namespace grade
