// SPDX-License-Identifier: MIT-0
#include "verdict.h"

#include <algorithm>
#include <utility>

namespace grade {

namespace {

constexpr std::pair<Verdict, std::string_view> names[] = {
    {Verdict::accepted, "ACCEPTED"},
    {Verdict::partial, "PARTIAL"},
    {Verdict::wrong_answer, "WRONG_ANSWER"},
    {Verdict::compile_error, "COMPILE_ERROR"},
    {Verdict::compile_limit, "COMPILE_LIMIT"},
    {Verdict::link_error, "LINK_ERROR"},
    {Verdict::rejected, "REJECTED"},
    {Verdict::runtime_error, "RUNTIME_ERROR"},
    {Verdict::time_limit, "TIME_LIMIT"},
    {Verdict::memory_limit, "MEMORY_LIMIT"},
    {Verdict::output_limit, "OUTPUT_LIMIT"},
    {Verdict::incomplete, "INCOMPLETE"},
    {Verdict::protocol_error, "PROTOCOL_ERROR"},
    {Verdict::grader_error, "GRADER_ERROR"},
};

}  // namespace

std::string_view name(Verdict verdict) {
  return std::ranges::find(names, verdict, &std::pair<Verdict, std::string_view>::first)->second;
}

std::optional<Verdict> verdict_named(std::string_view name) {
  for (const auto& [verdict, its_name] : names)
    if (its_name == name) return verdict;
  return std::nullopt;
}

bool is_judged(Verdict verdict) {
  return verdict == Verdict::accepted || verdict == Verdict::partial ||
         verdict == Verdict::wrong_answer;
}

}  // namespace grade
