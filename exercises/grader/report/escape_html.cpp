// SPDX-License-Identifier: MIT-0
#include "printable.h"
#include "report/escape.h"

namespace grade {
namespace {

std::string_view entity(char c) {
  switch (c) {
    case '&':
      return "&amp;";
    case '<':
      return "&lt;";
    case '>':
      return "&gt;";
    case '"':
      return "&quot;";
    case '\'':
      return "&#39;";
    default:
      return {};
  }
}

}  // namespace

std::string html_to_the_letter(std::string_view text) {
  std::string result;
  for (const char c : text) {
    const std::string_view replacement = entity(c);
    result += replacement.empty() ? std::string_view(&c, 1) : replacement;
  }
  return result;
}

std::string html(std::string_view text) {
  return html_to_the_letter(printable(text));
}

}  // namespace grade
