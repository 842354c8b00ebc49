// SPDX-License-Identifier: MIT-0
/// @file
/// The card of each header of the shelf, each from a file that bears the header's name.
#pragma once
#include "measure/shelf_card.h"

/// What is measured of the headers of the shelf.
namespace measure::shelf_cards {

ShelfCard bounce();           ///< of bounce.h
ShelfCard damper();           ///< of damper.h
ShelfCard first_order();      ///< of first_order.h
ShelfCard fixed_step();       ///< of fixed_step.h
ShelfCard link();             ///< of link.h
ShelfCard orientation();      ///< of orientation.h
ShelfCard smooth_damp();      ///< of smooth_damp.h
ShelfCard soft_constraint();  ///< of soft_constraint.h

}  // namespace measure::shelf_cards
