// SPDX-License-Identifier: MIT-0
// The list of live figures; each is made in figures/NAME.cpp.
#include "figure.h"

namespace live {

std::unique_ptr<Figure> thrown_ball();
std::unique_ptr<Figure> drone_spiral();
std::unique_ptr<Figure> suspension();
std::unique_ptr<Figure> cats();
std::unique_ptr<Figure> turning();

std::span<const Entry> figures() {
  static constexpr Entry list[] = {
      {"thrown-ball", thrown_ball}, {"drone-spiral", drone_spiral},
      {"suspension", suspension},   {"cats", cats},
  };
  return list;
}

}  // namespace live
