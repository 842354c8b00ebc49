// SPDX-License-Identifier: MIT-0
#include <algorithm>
#include <cstddef>

#include "printable.h"
#include "replace_all.h"
#include "report/escape.h"

namespace grade {
namespace {

/// One character, with none of Markdown's meanings. Sites make a link of `@name`, too.
std::string escaped(char c) {
  constexpr std::string_view marks = "\\`*_[]#|~$!>";
  if (marks.find(c) != std::string_view::npos) return {'\\', c};
  if (c == '\n' || c == '\t') return " ";
  if (c == '@') return "&#64;";
  if (c == '<') return "&lt;";
  return c == '&' ? "&amp;" : std::string(1, c);
}

/// Escapes the start of a line that would make it a list, a heading or a rule.
void disarm_start(std::string& line) {
  const std::size_t digits = line.find_first_not_of("0123456789");
  if (digits == std::string::npos) return;
  const bool mark = digits == 0 && std::string_view("-+=").find(line[0]) != std::string::npos;
  const bool number = digits > 0 && (line[digits] == '.' || line[digits] == ')');
  if (mark || (number && line.substr(digits + 1, 1) == " ")) line.insert(digits, "\\");
}

std::size_t longest_run(std::string_view text, char of) {
  std::size_t longest = 0, run = 0;
  for (const char c : text) {
    run = c == of ? run + 1 : 0;
    longest = std::max(longest, run);
  }
  return longest;
}

}  // namespace

std::string markdown(std::string_view text) {
  const std::string shown = printable(text);
  std::string line;
  for (const char c : std::string_view(shown)) line += escaped(c);
  line.erase(0, line.find_first_not_of(' '));
  line = replace_all(replace_all(line, "://", ":&#47;/"), "www.", "www&#46;");
  disarm_start(line);
  return line;
}

std::string markdown_code(std::string_view text) {
  const std::string block = printable(text);
  const std::string fence(std::max<std::size_t>(3, longest_run(block, '`') + 1), '`');
  return fence + "text\n" + block + (block.ends_with('\n') ? "" : "\n") + fence + "\n";
}

}  // namespace grade
