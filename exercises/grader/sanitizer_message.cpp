// SPDX-License-Identifier: MIT-0
#include "sanitizer_message.h"

#include <algorithm>
#include <cctype>
#include <regex>

#include "failed_assertion.h"
#include "printable.h"

namespace grade {
namespace {

bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != text.npos;
}

// The word behind what the checker's report begins with, such as heap-buffer-overflow.
std::string kind_of(const std::string& printed) {
  const std::string mark = "ERROR: AddressSanitizer: ";
  const std::size_t at = printed.find(mark);
  if (at == printed.npos) return {};
  const std::size_t begin = at + mark.size();
  std::size_t end = begin;
  while (end < printed.size() &&
         (std::isalpha(static_cast<unsigned char>(printed[end])) || printed[end] == '-')) {
    ++end;
  }
  return printed.substr(begin, end - begin);
}

// The message of the checker of undefined behaviour, such as: index 2 out of bounds for type 'Vec
// [2]'.
std::string undefined(const std::string& printed) {
  const std::string mark = ": runtime error: ";
  const std::size_t at = printed.find(mark);
  if (at == printed.npos) return {};
  // The student's code may have printed it, and made it long; a regular expression goes as deep.
  constexpr std::size_t most = 200;
  const std::size_t begin = at + mark.size();
  const std::size_t length = std::min(printed.find('\n', begin) - begin, most);
  // Addresses are others in every run.
  return printable(std::regex_replace(printed.substr(begin, length),
                                      std::regex("address 0x[0-9a-f]+"), "an address"),
                   most);
}

// The first line of the header that is named, as ", in line 12".
std::string line_of(const std::string& printed, const std::string& header) {
  const std::size_t at = printed.find(header + ":");
  if (at == printed.npos) return {};
  std::string line;
  for (std::size_t n = at + header.size() + 1;
       n < printed.size() && std::isdigit(static_cast<unsigned char>(printed[n])) &&
       line.size() < 6;
       ++n) {
    line += printed[n];
  }
  return line.empty() ? "" : ", in line " + line;
}

std::string what_happened(const std::string& kind, bool writes) {
  const std::string does = writes ? "writes" : "reads";
  if (contains(kind, "overflow") && kind != "stack-overflow")
    return does + " outside of the memory that it has";
  if (contains(kind, "use-after")) return does + " memory that is no longer its own";
  if (kind == "SEGV") return "uses an address where there is no memory";
  if (kind == "requested") return "asks for more memory than there can be";
  if (kind == "stack-overflow") return "calls itself without end";
  return "uses memory wrongly";
}

}  // namespace

std::string sanitizer_message(const std::string& printed, const std::string& header) {
  if (const std::string error = undefined(printed); !error.empty())
    return "Your code does what C++ gives no meaning to" + line_of(printed, header) + ": " + error +
           ".";
  const std::string kind = kind_of(printed);
  if (kind.empty() || kind == "hard") return {};
  if (kind == "ABRT") {
    const std::string rule = failed_assertion(printed);
    return "Your code " + (rule.empty() ? "calls abort" : rule) + line_of(printed, header) + ".";
  }
  return "Your code " + what_happened(kind, contains(printed, "WRITE of size")) +
         line_of(printed, header) + ". AddressSanitizer calls this " + kind + ".";
}

std::string without_warnings(const std::string& printed) {
  std::string rest;
  for (std::size_t begin = 0, end = 0; begin < printed.size(); begin = end) {
    end = std::min(printed.find('\n', begin), printed.size() - 1) + 1;
    const std::string line = printed.substr(begin, end - begin);
    // As in ==12==WARNING: reading executable name failed.
    const bool warning = line.starts_with("==") && contains(line.substr(0, 24), "==WARNING: ");
    if (!warning) rest += line;
  }
  return rest;
}

bool ran_out_of_memory(std::string& printed) {
  // As in ==12==AddressSanitizer: hard rss limit exhausted; behind it stands a map of the memory.
  const std::size_t at = printed.find("==AddressSanitizer: hard rss limit exhausted");
  if (at == printed.npos) return false;
  const std::size_t line = printed.rfind('\n', at);
  printed.erase(line == printed.npos ? 0 : line + 1);
  return true;
}

}  // namespace grade
