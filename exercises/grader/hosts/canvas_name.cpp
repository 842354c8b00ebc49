// SPDX-License-Identifier: MIT-0
#include "hosts/canvas_name.h"

#include <algorithm>
#include <cctype>
#include <cstddef>
#include <vector>

namespace grade {
namespace {

struct Part {
  std::size_t begin;
  std::string text;
};

std::vector<Part> parts_of(const std::string& text) {
  std::vector<Part> parts;
  for (std::size_t begin = 0; begin <= text.size();) {
    const std::size_t end = std::min(text.find('_', begin), text.size());
    parts.push_back({begin, text.substr(begin, end - begin)});
    begin = end + 1;
  }
  return parts;
}

bool all_digits(const std::string& text) {
  return !text.empty() &&
         std::ranges::all_of(text, [](unsigned char c) { return std::isdigit(c) != 0; });
}

/// Without names: `anon_x1Y2z_98765_orbit-drift.h`, perhaps with `LATE_` before it.
bool is_anonymous(const std::vector<Part>& parts, std::size_t id) {
  const std::size_t before = parts[0].text == "LATE" ? 1 : 0;
  return id == before + 1 && parts[before].text == "anon";
}

bool is_late(const std::vector<Part>& parts, std::size_t id) {
  if (is_anonymous(parts, id)) return id == 2;
  return parts[id - 1].text == "LATE";
}

/// Where the student's number or anonymous word may stand, the number of the file behind it.
std::vector<std::size_t> ids_in(const std::vector<Part>& parts) {
  std::vector<std::size_t> found;
  for (std::size_t i = 1; i + 2 < parts.size(); ++i)
    if (all_digits(parts[i + 1].text) && (all_digits(parts[i].text) || is_anonymous(parts, i)))
      found.push_back(i);
  return found;
}

}  // namespace

CanvasName canvas_name(const std::string& text) {
  const std::vector<Part> parts = parts_of(text);
  const std::vector<std::size_t> ids = ids_in(parts);
  if (ids.empty()) return {"", false, "", "it is not called as Canvas calls what was handed in"};
  if (ids.size() > 1)
    return {"", false, "", "it could be another student's; put it into that student's folder"};
  const std::size_t id = ids[0];
  const std::string student = (is_anonymous(parts, id) ? "anon_" : "") + parts[id].text;
  return {student, is_late(parts, id), text.substr(parts[id + 2].begin), ""};
}

}  // namespace grade
