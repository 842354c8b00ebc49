// SPDX-License-Identifier: MIT-0
#include "judge/session.h"

#include <catch2/catch_test_macros.hpp>
#include <cmath>

#include "format_values.h"
#include "judge/student.h"

namespace judge {
namespace {

// Returns whether what was wrong is right in a program that has just begun.
bool is_remembered() {
  const Exchange* wrong = Known::first_wrong(session().exercise, session().programs);
  if (!wrong || !wrong->evaluations.empty()) return false;
  Exchange alone = *wrong;
  Student fresh;
  alone.answer = fresh.call(alone.function, alone.arguments, alone.answer.size());
  return Known::is_right(session().exercise, alone);
}

// The diagnoses: a known wrong way's first, then what the judge says besides, but for the same
// again.
std::vector<std::string> with_known(const std::vector<std::string>& others) {
  std::vector<std::string> all = Known::recognised(session().exercise, session().programs);
  if (all.empty() && is_remembered())
    all = {"in a program that has just begun this is right: what is remembered?"};
  const std::string known = all.empty() ? "" : all[0];
  for (const std::string& other : others)
    if (known.empty() || (!other.starts_with(known) && known.find(other) == known.npos))
      all.push_back(other);
  return all;
}

}  // namespace

Session& session() {
  static Session session;
  return session;
}

grade::Finding off_by(double off, const Tolerance& tolerance, const std::string& unit) {
  grade::Finding finding;
  finding.held = off <= tolerance.value && std::isfinite(tolerance.value);
  finding.error = grade::number(off, 3) + unit;
  finding.tolerance = grade::number(tolerance.value, 2) + unit;
  finding.tolerance_from = tolerance.from;
  return finding;
}

// Of the hundreds that may hold, a report needs no more than a dozen.
void check(grade::Finding finding) {
  constexpr std::size_t most = 12;
  const bool held = finding.held;
  auto& findings = session().tests.back().findings;
  if (findings.size() >= most) findings.pop_back();
  if (!held && session().diagnoses) finding.diagnoses = with_known(finding.diagnoses);
  finding.input += session().given;
  findings.push_back(std::move(finding));
  REQUIRE(held);
}

}  // namespace judge
