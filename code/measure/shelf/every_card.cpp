// SPDX-License-Identifier: MIT-0
// All cards of the shelf.
#include "measure/shelf/every_card.h"

namespace measure {

std::vector<ShelfCard> every_shelf_card() {
  using namespace shelf_cards;
  return {
      bounce(), damper(),      first_order(), fixed_step(),
      link(),   orientation(), smooth_damp(), soft_constraint(),
  };
}

}  // namespace measure
