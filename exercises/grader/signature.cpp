// SPDX-License-Identifier: MIT-0
#include "signature.h"

#include <cstddef>
#include <optional>
#include <string_view>

namespace grade {

namespace {

/// What stands in quotes behind these words.
std::optional<std::string> quoted(const std::string& text, std::string_view before) {
  const std::size_t start = text.find(before);
  if (start == text.npos) return std::nullopt;
  const std::size_t from = start + before.size(), to = text.find('\'', from);
  return to == text.npos ? std::nullopt : std::optional(text.substr(from, to - from));
}

void replace_all(std::string& text, std::string_view from, std::string_view to) {
  for (std::size_t at = text.find(from); at != text.npos; at = text.find(from, at + to.size()))
    text.replace(at, from.size(), to);
}

/// The function's name: the last word of the excerpt's first line.
std::string function(const Diagnostic& error) {
  if (error.excerpt.empty()) return {};
  const std::string& line = error.excerpt.front();
  const std::size_t start = line.rfind("= "), end = line.find(';');
  return start == line.npos || end == line.npos || end < start
             ? ""
             : line.substr(start + 2, end - start - 2);
}

/// `void (*)(Vec&)` as one would write it: `void step(Vec&)`.
std::string declaration(std::string type, const std::string& name) {
  replace_all(type, "(* const)", name);
  replace_all(type, "(*)", name);
  replace_all(type, "struct ", "");
  replace_all(type, "class ", "");
  return type;
}

}  // namespace

std::string wanted_and_found(const Diagnostic& error) {
  const std::string name = function(error);
  if (name.empty()) return {};
  if (const auto wanted =
          quoted(error.text, "no matches converting function '" + name + "' to type '"))
    return "wanted is " + declaration(*wanted, name);
  const auto found = quoted(error.text, "conversion from '"), wanted = quoted(error.text, " to '");
  if (!found || !wanted) return {};
  return "wanted is " + declaration(*wanted, name) + ", but found is " + declaration(*found, name);
}

}  // namespace grade
