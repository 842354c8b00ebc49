// SPDX-License-Identifier: MIT-0
// What `choose --scene my_scene.h` compiles when it has chosen, with -DSCENE and -DONLY: takes the
// time of a step of that method on that scene, of one of many bodies, and prints it [ns].
#include SCENE

#include <cstdio>
#include <vector>

#include "choose/cost.h"
#include "choose/own_scene.h"
#include "measure/methods.h"
#include "measure/time_of.h"
#include "measure/times.h"

int main() {
  const OwnScene scene;
  list::for_each(list::Among<list::EveryGeneral, list::is_chosen>(), [&](auto method) {
    std::vector<double> runs;
    for (int n = 0; n < 15; ++n)
      runs.push_back(1e9 * measure::time_of(method, scene, scene.start(), brief_step, in_a_loop));
    std::printf("%.3g\n", measure::quartiles(runs).median);
  });
}
