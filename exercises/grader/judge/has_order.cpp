// SPDX-License-Identifier: MIT-0
#include <algorithm>
#include <array>
#include <cmath>

#include "format_values.h"
#include "judge/describe.h"
#include "judge/random.h"
#include "judge/session.h"
#include "judge/tests.h"

namespace judge {
namespace {

using grade::number;

constexpr std::size_t runs = 4;
constexpr double within = 0.1;

struct Errors {
  std::array<double, runs> h{}, error{};

  double order(std::size_t n) const { return std::log2(error[n] / error[n + 1]); }
};

double largest_error(const Path& path, const Path& exact) {
  double largest = 0;
  for (std::size_t n = 1; n < exact.states.size(); ++n) {
    const double error = distance(path.states[n], exact.states[n]);
    largest = std::isfinite(error) ? std::max(largest, error) : error;
  }
  return largest;
}

// One second, at the times of the coarsest run, so that no single time decides.
Errors measure(Student& student, const Start& start, const harness::Force& force, int most_steps,
               int function) {
  const int fewest = most_steps >> (runs - 1);
  const Path exact = truth(start, 1.0 / fewest, fewest, 1, force);
  Errors errors;
  for (std::size_t n = 0; n < runs; ++n) {
    const int parts = 1 << n;
    errors.h[n] = 1.0 / (fewest * parts);
    const Path path = student.run(start, errors.h[n], fewest * parts, parts, force, function);
    errors.error[n] = largest_error(path, exact);
  }
  return errors;
}

std::string listed(const Errors& errors) {
  std::string text = "errors";
  for (const double error : errors.error) text += " " + number(error, 3);
  text += "; orders";
  for (std::size_t n = 0; n + 1 < runs; ++n) text += " " + number(errors.order(n), 3);
  return text;
}

grade::Plot plot(const Errors& errors, double p) {
  grade::Curve yours{
      "yours", {errors.h.begin(), errors.h.end()}, {errors.error.begin(), errors.error.end()}};
  grade::Curve wanted{"order " + number(p), yours.x, {}};
  for (const double h : yours.x) {
    wanted.y.push_back(errors.error.front() * std::pow(h / yours.x.front(), p));
  }
  grade::Plot plot{"Error and step", "step [s]", "largest error", {yours, wanted}};
  plot.logarithmic = true;
  return plot;
}

}  // namespace

void has_order(Student& student, double p, int most_steps, const std::string& hint, int function) {
  Random random;
  const Start start = random.start();
  const harness::Force force = random.wild();
  const Errors errors = measure(student, start, force, most_steps, function);
  const double order = errors.order(runs - 2);
  const bool settled = std::abs(order - errors.order(runs - 3)) <= within;

  grade::Finding finding;
  finding.held = settled && std::abs(order - p) <= within;
  finding.asked = "order " + number(p) + ": one second in " + std::to_string(most_steps / 8) +
                  " to " + std::to_string(most_steps) + " steps, " + describe(force);
  finding.input = describe(start);
  finding.expected = "half the step divides the error by " + number(std::exp2(p));
  finding.got = listed(errors);
  finding.error = settled ? "order " + number(order, 3) + " instead of " + number(p)
                          : "the error does not settle to a power of the step";
  finding.tolerance = number(within);
  finding.tolerance_from = "successive estimates of the right method differ by less at these steps";
  if (!finding.held) {
    finding.hint = hint;
    finding.plot = plot(errors, p);
    if (!std::isfinite(errors.error.back())) finding.diagnoses = {"the path is not finite"};
  }
  check(finding);
}

}  // namespace judge
