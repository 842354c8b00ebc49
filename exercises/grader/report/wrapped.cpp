// SPDX-License-Identifier: MIT-0
#include "report/wrapped.h"

#include <algorithm>
#include <sstream>
#include <string_view>

#include "printable.h"

namespace grade {
namespace {

constexpr std::size_t columns = 80;

std::size_t characters(std::string_view text) {
  std::size_t count = 0;
  for (; !text.empty(); ++count) {
    text.remove_prefix(std::max<std::size_t>(1, utf8_character(text)));
  }
  return count;
}

}  // namespace

std::string wrapped(const std::string& text, std::size_t indent) {
  std::istringstream words(printable(text));
  std::string result;
  std::size_t column = indent;
  for (std::string word; words >> word;) {
    const std::size_t length = characters(word);
    const bool first = column == indent;
    if (!first && column + 1 + length > columns) {
      result += "\n" + std::string(indent, ' ');
      column = indent;
    } else if (!first) {
      result += " ";
      ++column;
    }
    result += word;
    column += length;
  }
  return result + "\n";
}

}  // namespace grade
