// SPDX-License-Identifier: MIT-0
/// @file
/// The promises of a header of the shelf, and what was measured of each.
#pragma once
#include <cmath>
#include <string>
#include <vector>

#include "measure/record.h"

namespace measure {

/// One promise of a header.
struct Promise {
  std::string words;       ///< as they stand in the header's list
  bool kept;               ///< whether what was measured is what the words say
  Cell measured;           ///< a number, or words such as "none"
  int digits = 2;          ///< significant digits that the book shows; `whole` for a count
  std::string unit = "1";  ///< 1 if it has none
};

/// All promises of one header.
struct ShelfCard {
  std::string header;  ///< its name without the ending
  std::vector<Promise> promises;
};

/// Whether a number is what the words say, within half a unit of their last digit.
inline bool rounds_to(double found, double said, double unit) {
  return std::abs(found - said) <= unit / 2;
}

/// The cards of all headers of the shelf. Each is measured by `shelf_cards::NAME()`, which stands
/// in code/measure/shelf/NAME.cpp.
std::vector<ShelfCard> every_shelf_card();

}  // namespace measure
