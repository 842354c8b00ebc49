// SPDX-License-Identifier: MIT-0
#include "class/print_some.h"

#include <algorithm>
#include <cstddef>
#include <cstdio>

#include "printable.h"

namespace grade {

void print_some(const char* what, const std::vector<std::string>& names) {
  constexpr std::size_t most = 10;
  for (std::size_t i = 0; i < std::min(most, names.size()); ++i) {
    std::printf("%s: %s\n", what, printable_name(names[i]).c_str());
  }
  if (names.size() > most) std::printf("%s: %zu more\n", what, names.size() - most);
}

}  // namespace grade
