// SPDX-License-Identifier: MIT-0
#include "failed_assertion.h"

#include <string_view>
#include <utility>

#include "printable.h"

namespace grade {
namespace {

constexpr std::size_t most = 200;  // The student's code may have printed it, and made it long.

/// The text between two marks; empty if one of them is missing.
std::string between(const std::string& text, std::string_view begin, std::string_view end) {
  const std::size_t mark = text.find(begin);
  if (mark == text.npos) return {};
  const std::size_t from = mark + begin.size(), to = text.find(end, from);
  return to == text.npos ? "" : printable(text.substr(from, to - from), most);
}

std::string thrown(const std::string& printed) {
  const std::string type =
      between(printed, "terminate called after throwing an instance of '", "'");
  const std::string what = between(printed, "  what():  ", "\n");
  if (type.empty()) return {};
  return "throws " + type + " and catches it nowhere" + (what.empty() ? "" : " (" + what + ")");
}

}  // namespace

std::string failed_assertion(const std::string& printed) {
  constexpr std::pair<std::string_view, const char*> known[] = {
      {"__hi < __lo", "gives std::clamp its bounds in the wrong order"},
      {"empty()", "takes an element of an empty container"},
      {"size()", "uses an index that is past the end of its vector, array or string"},
      {"_M_is_engaged()", "takes the value of an empty std::optional"}};
  const std::string asserted = between(printed, ": Assertion '", "' failed.");
  if (asserted.empty()) return thrown(printed);
  for (const auto& [part, says] : known)
    if (asserted.find(part) != asserted.npos) return says;
  return "breaks a rule of the library: '" + asserted + "' does not hold";
}

}  // namespace grade
