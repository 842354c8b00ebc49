// SPDX-License-Identifier: MIT-0
#include "time_limits.h"

#include <array>
#include <charconv>
#include <system_error>

#include "judge/session.h"

namespace grade {
namespace {

std::array<double*, 4> times(Request& request) {
  return {&request.compile_limits.processor, &request.compile_limits.wall,
          &request.run_limits.processor, &request.run_limits.wall};
}

}  // namespace

std::string write_limits(const Request& request) {
  std::string text;
  Request copy = request;
  for (const double* time : times(copy)) {
    char digits[32];
    const char* const end = std::to_chars(digits, digits + sizeof digits, *time).ptr;
    text += (text.empty() ? "" : ",") + std::string(digits, std::size_t(end - digits));
  }
  return text;
}

double longest_run(const Request& request) {
  const std::size_t tests = judge::tests_of(request.exercise.name).size();
  return static_cast<double>(tests) * request.run_limits.wall;
}

double longest_grading(const Request& request) {
  return 2 * (request.compile_limits.wall + request.runs * longest_run(request));
}

bool read_limits(std::string_view text, Request& request) {
  for (double* time : times(request)) {
    const auto [end, problem] = std::from_chars(text.data(), text.data() + text.size(), *time);
    if (problem != std::errc() || !(*time > 0)) return false;
    text.remove_prefix(static_cast<std::size_t>(end - text.data()));
    if (text.starts_with(',')) text.remove_prefix(1);
  }
  return text.empty();
}

}  // namespace grade
