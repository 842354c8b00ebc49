// SPDX-License-Identifier: MIT-0
// What is timed for the cards: every method of the list, on the scene that its card names.
#include "measure/card_lines.h"
#include "measure/cost.h"
#include "measure/methods.h"
#include "times.h"

namespace {

template <class Listed, class Scene>
void add(std::vector<measure::Timed>& all, const Scene& scene) {
  all.push_back({"card/" + std::string(Listed::function),
                 [scene] { return measure::seconds_per_step(Listed(), scene, 1e-5); }});
}

template <class... Listed, class Scene>
void add_each(std::vector<measure::Timed>& all, std::tuple<Listed...>, const Scene& scene) {
  (add<Listed>(all, scene), ...);
}

}  // namespace

void add_card_times(std::vector<measure::Timed>& all) {
  using namespace measure::card_lines;
  add_each(all, list::General(), orbit);
  add_each(all, list::OnSprings(), damped);
  add_each(all, list::Damping(), damped);
}
