// SPDX-License-Identifier: MIT-0
// What is timed for the cards: every method of the list, on the scene that its card names.
#include "measure/card_lines.h"
#include "measure/methods.h"
#include "measure/time_of.h"
#include "times.h"

namespace {

template <class List, class Scene>
void add_each(std::vector<measure::Timed>& all, List methods, const Scene& scene) {
  list::for_each(methods, [&](auto method) {
    all.push_back({"card/" + std::string(method.function), [method, scene] {
                     return measure::time_of(method, scene, scene.start(), 1e-5);
                   }});
  });
}

}  // namespace

void add_card_times(std::vector<measure::Timed>& all) {
  using namespace measure::card_lines;
  add_each(all, list::General(), orbit);
  add_each(all, list::OnSprings(), damped);
  add_each(all, list::Damping(), damped);
}
