// SPDX-License-Identifier: MIT-0
#include "live/own.h"

#include <cstddef>

namespace live {
namespace {

const Stand* now = nullptr;

}  // namespace

const Stand* standing() {
  return now;
}

void put_standing(double which) {
  now = which > 0 ? &mistakes()[static_cast<std::size_t>(which) - 1] : nullptr;
}

std::vector<const char*> names_of_stands() {
  std::vector<const char*> names{"none"};
  for (const Stand& mistake : mistakes()) names.push_back(mistake.name);
  return names;
}

}  // namespace live
