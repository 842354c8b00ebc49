// SPDX-License-Identifier: MIT-0
// What `choose --scene my_scene.h` compiles when it has chosen, with the scene included before it
// and -DMETHOD: takes the time of a step of that method on that scene, of one of many bodies, and
// prints it [ns].
#include <cstdio>
#include <vector>

#include "choose/cost.h"
#include "choose/own_exports.h"
#include "choose/own_scene.h"
#include "measure/methods.h"
#include "measure/time_of.h"
#include "measure/times.h"

namespace {

/// The acceleration as the reader's game would call it.
struct Called {
  Vec operator()(const Vec& x, const Vec& v, auto t) const { return Vec(acceleration(x, v, t)); }
};

/// The median of many runs [ns].
template <class Scene, class State, class Real>
double median_time(const Scene& scene, const State& start, Real h) {
  std::vector<double> runs;
  for (int n = 0; n < 15; ++n)
    runs.push_back(1e9 * measure::time_of(measure::METHOD(), scene, start, h, in_a_loop));
  return measure::quartiles(runs).median;
}

}  // namespace

int main() {
  if constexpr (::list::is_in<measure::METHOD>(::list::EveryImplicit())) {
    // These ask for derivatives, and solve for vectors of Eigen's.
    constexpr bool on_a_line = std::is_arithmetic_v<Vec>;
    using Moved = std::conditional_t<
        on_a_line, double,
        std::conditional_t<std::is_same_v<Vec, Eigen::Vector2d>, Vec, Eigen::VectorXd>>;
    const OwnScene<Moved> scene(own::force());
    std::printf("%.3g\n", median_time(scene, scene.start(), brief_step));
  } else {
    const scenes::State<Vec> start{Vec(start_x), Vec(start_v)};
    std::printf("%.3g\n", median_time(Called(), start, own::Real<Vec>(brief_step)));
  }
}
