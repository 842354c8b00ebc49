// SPDX-License-Identifier: MIT-0
#include "diagnostics.h"

#include <algorithm>
#include <cctype>
#include <cstddef>
#include <iterator>
#include <utility>

namespace grade {

namespace {

/// The kinds of messages; with a capital letter they are the assembler's.
constexpr std::string_view kinds_of_message[] = {"error",
                                                 "fatal error",
                                                 "internal compiler error",
                                                 "sorry, unimplemented",
                                                 "warning",
                                                 "note",
                                                 "Error",
                                                 "Fatal error",
                                                 "Internal error",
                                                 "Warning"};

std::vector<std::string_view> lines(std::string_view text) {
  std::vector<std::string_view> all;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    all.push_back(text.substr(0, end));
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return all;
}

/// Takes `12:` off the front.
std::string number(std::string_view& text) {
  std::size_t digits = 0;
  while (digits < text.size() && std::isdigit(static_cast<unsigned char>(text[digits]))) ++digits;
  if (digits == 0 || digits == text.size() || text[digits] != ':') return {};
  const std::string found(text.substr(0, digits));
  text.remove_prefix(digits + 1);
  return found;
}

void drop_blanks(std::string_view& text) {
  text.remove_prefix(std::min(text.find_first_not_of(' '), text.size()));
}

bool split_kind(std::string_view text, Diagnostic& into) {
  for (const std::string_view kind : kinds_of_message) {
    if (!text.starts_with(kind) || !text.substr(kind.size()).starts_with(": ")) continue;
    into.kind = kind;
    into.kind[0] = static_cast<char>(std::tolower(into.kind[0]));
    into.text = text.substr(kind.size() + 2);
    return true;
  }
  return false;
}

/// `file:5:3: error: text`, or without the column; true if the line is one.
bool split(std::string_view line, Diagnostic& into) {
  for (std::size_t colon = line.find(':'); colon != line.npos; colon = line.find(':', colon + 1)) {
    std::string_view rest = line.substr(colon + 1);
    into.place = number(rest);
    if (into.place.empty()) continue;
    if (const std::string column = number(rest); !column.empty()) into.place += ":" + column;
    drop_blanks(rest);
    into.file = line.substr(0, colon);
    return split_kind(rest, into);
  }
  return false;
}

/// `g++` itself may be `/usr/bin/x86_64-linux-gnu-g++-14`.
bool is_tool(std::string_view name) {
  if (name == "{standard input}") return true;  // as the assembler speaks of all that it read
  name.remove_prefix(name.rfind('/') + 1);      // none: all of it stays
  if (name.find(' ') != name.npos) return false;
  if (name == "g++" || name.find("-g++") != name.npos) return true;
  constexpr std::string_view others[] = {"cc1plus", "as", "ld", "collect2"};
  return std::ranges::find(others, name) != std::end(others);
}

/// A program of the compiler's speaks of itself: `g++: fatal error: ...`.
bool of_a_tool(std::string_view line, Diagnostic& into) {
  if (line.starts_with("virtual memory exhausted")) {
    into.kind = "error";
    into.text = line;
    return true;
  }
  const std::size_t colon = line.find(": ");
  if (colon == line.npos || line.starts_with(' ')) return false;
  if (!is_tool(line.substr(0, colon))) return false;
  const std::string_view text = line.substr(colon + 2);
  if (!split_kind(text, into)) into.text = text, into.kind = "error";
  return true;
}

bool is_excerpt(std::string_view line) {
  return line.starts_with(' ') && line.find(" | ") != line.npos;
}

bool names_includers(std::string_view line) {
  if (line.starts_with("In file included from ")) return true;
  drop_blanks(line);
  return line.starts_with("from ");
}

bool is_context(std::string_view line) {
  return line.find(": In ") != line.npos || line.find(":   required ") != line.npos ||
         line.find(":   in ") != line.npos;
}

}  // namespace

std::vector<Diagnostic> diagnostics(std::string_view said) {
  std::vector<Diagnostic> all;
  std::vector<std::string> context;
  for (const std::string_view line : lines(said)) {
    if (names_includers(line)) continue;
    Diagnostic next;
    if (is_excerpt(line)) {
      if (!all.empty()) all.back().excerpt.emplace_back(line);
    } else if (split(line, next) || (next = {}, of_a_tool(line, next))) {
      next.before = std::exchange(context, {});
      all.push_back(std::move(next));
    } else if (is_context(line)) {
      context.emplace_back(line);
    }
  }
  return all;
}

}  // namespace grade
