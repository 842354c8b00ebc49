// SPDX-License-Identifier: MIT-0
/// @file
/// A method on one card: its order, cost and limits, what it does to energy, all measured.
#pragma once
#include <string>
#include <vector>

#include "measure/record.h"

namespace measure {

/// One line of a card.
struct CardRow {
  std::string name;        ///< what the index of all methods and the tests know the line by
  std::string about;       ///< lines that follow each other with the same words here stand together
  std::string asked;       ///< what was measured
  Cell measured;           ///< a number, or words such as "never"
  int digits = 3;          ///< significant digits that the book shows; `whole` for a count
  std::string unit = "1";  ///< 1 if it has none
};

/// What was measured of one method.
struct Card {
  std::string method;  ///< name of the function in integrate
  std::string suits;   ///< what it is for, such as "any acceleration"
  std::vector<CardRow> rows;
  std::string timed_on;  ///< what the method moves while its steps are timed; empty if they aren't

  /// What stands in a line.
  /// @throws std::out_of_range  there is no line of this name
  const Cell& at(const std::string& name) const;
};

/// The cards of all functions in integrate that step, in the order in which the book lists them.
/// Nothing in them is a time.
std::vector<Card> every_card();

}  // namespace measure
