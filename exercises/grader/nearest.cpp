// SPDX-License-Identifier: MIT-0
#include "nearest.h"

#include <algorithm>
#include <cctype>
#include <cstddef>
#include <numeric>
#include <utility>

namespace grade {

namespace {

/// Lower case, without the ending and all that is neither a letter nor a digit.
std::string core(const std::string& name) {
  std::string letters;
  for (const char letter : name.substr(0, name.rfind('.')))
    if (std::isalnum(static_cast<unsigned char>(letter)))
      letters += static_cast<char>(std::tolower(static_cast<unsigned char>(letter)));
  return letters;
}

}  // namespace

std::size_t edit_distance(const std::string& a, const std::string& b) {
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 1; i <= a.size(); ++i) {
    std::size_t diagonal = std::exchange(row[0], i);
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t replaced = diagonal + (a[i - 1] != b[j - 1]);
      diagonal = row[j];
      row[j] = std::min({replaced, row[j] + 1, row[j - 1] + 1});
    }
  }
  return row.back();
}

std::string nearest(const std::string& wanted, const std::vector<std::string>& names) {
  const std::string sought = core(wanted);
  std::size_t least = sought.size() / 3 + 1;  // further off it is another word
  std::string best;
  for (const std::string& name : names) {
    const std::size_t away = edit_distance(sought, core(name));
    if (away >= least) continue;
    least = away;
    best = name;
  }
  return best;
}

}  // namespace grade
