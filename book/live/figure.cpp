// SPDX-License-Identifier: MIT-0
#include "figure.h"

#include <algorithm>

#include "live/own.h"

namespace live {

std::vector<Setting> Figure::all_settings() {
  auto all = settings();
  all.push_back({"own", &own_, names_of_stands()});
  return all;
}

void Figure::begin() {
  put_standing(own_);
  start();
}

void Figure::advance(int steps) {
  for (int n = 0; n < steps; ++n) step();
  show_state();
}

double Figure::work(int, int) {
  return 0;
}

void Figure::put(const char* name, std::span<const double> values, bool reproducible) {
  const auto same_name = [name](const Shown& s) { return std::string_view(s.name) == name; };
  auto found = std::find_if(shown_.begin(), shown_.end(), same_name);
  if (found == shown_.end()) found = shown_.insert(found, Shown{name, {}, reproducible});
  found->values.assign(values.begin(), values.end());
  ++found->changes;
}

}  // namespace live
