// SPDX-License-Identifier: MIT-0
#include <cmath>

#include "format_values.h"
#include "judge/diagnose.h"
#include "judge/session.h"
#include "judge/tests.h"

namespace judge {

using grade::number;

void is_exact(const std::string& asked, const std::string& input, double got, double expected,
              const Tolerance& tolerance, const std::string& hint) {
  grade::Finding finding = off_by(std::abs(got - expected), tolerance);
  if (got == expected) finding.held = true;  // two infinities have no difference
  finding.asked = asked;
  finding.input = input;
  finding.expected = number(expected, 12);
  finding.got = number(got, 12);
  if (!finding.held) {
    finding.hint = hint;
    finding.diagnoses = diagnose(got, expected);
  }
  check(finding);
}

void is_at_most(const std::string& asked, const std::string& input, double got,
                const Tolerance& bound, const std::string& hint) {
  grade::Finding finding;
  finding.held = got <= bound.value;
  finding.asked = asked;
  finding.input = input;
  finding.expected = "at most " + number(bound.value);
  finding.got = number(got);
  finding.error = number(got - bound.value, 3) + " too much";
  finding.tolerance = number(bound.value);
  finding.tolerance_from = bound.from;
  if (!finding.held) finding.hint = hint;
  check(finding);
}

}  // namespace judge
