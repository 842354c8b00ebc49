// SPDX-License-Identifier: MIT-0
// The list of live figures; each is made in figures/NAME.cpp.
#include "figure.h"

namespace live {

std::unique_ptr<Figure> thrown_ball();
std::unique_ptr<Figure> drone_spiral();
std::unique_ptr<Figure> suspension();
std::unique_ptr<Figure> equal_cost();
std::unique_ptr<Figure> hanging_rope();
std::unique_ptr<Figure> rope_to_drag();
std::unique_ptr<Figure> cats();
std::unique_ptr<Figure> turning();
std::unique_ptr<Figure> your_spring();

std::span<const Entry> figures() {
  static constexpr Entry list[] = {
      {"thrown-ball", thrown_ball},
      {"drone-spiral", drone_spiral},
      {"suspension", suspension},
      {"equal-cost", equal_cost},
      {"hanging-rope", hanging_rope},
      {"rope-to-drag", rope_to_drag},
      {"cats", cats},
      {"turning", turning},
      {"your-spring", your_spring},
  };
  return list;
}

}  // namespace live
