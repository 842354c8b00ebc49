// SPDX-License-Identifier: MIT-0
#include "hosts/second_try.h"

#include <algorithm>
#include <cstddef>
#include <regex>

#include "exercise.h"

namespace grade {
namespace {

bool is_a_header(const std::string& name) {
  const auto all = exercises();
  return std::ranges::any_of(all, [&](const Exercise& one) { return one.header() == name; });
}

}  // namespace

AskedName asked_name(const std::string& file) {
  constexpr std::size_t longest_name = 255;
  static const std::regex form(R"(([^]*?)(?: ?\(([0-9]{1,4})\)|-([0-9]{1,4}))\.h)");
  std::smatch parts;
  if (file.size() > longest_name || is_a_header(file) || !std::regex_match(file, parts, form))
    return {file, 0};
  const std::string header = parts[1].str() + ".h";
  if (!is_a_header(header)) return {file, 0};
  return {header, unsigned(std::stoul(parts[2].matched ? parts[2] : parts[3]))};
}

}  // namespace grade
