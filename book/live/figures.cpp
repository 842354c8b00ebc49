// SPDX-License-Identifier: MIT-0
// The list of live figures; each is made in figures/NAME.cpp.
#include "figure.h"

namespace live {

std::unique_ptr<Figure> thrown_ball();
std::unique_ptr<Figure> drone_spiral();
std::unique_ptr<Figure> suspension();
std::unique_ptr<Figure> equal_cost();
std::unique_ptr<Figure> hanging_rope();

std::span<const Entry> figures() {
  static constexpr Entry list[] = {
      {"thrown-ball", thrown_ball}, {"drone-spiral", drone_spiral}, {"suspension", suspension},
      {"equal-cost", equal_cost},   {"hanging-rope", hanging_rope},
  };
  return list;
}

}  // namespace live
