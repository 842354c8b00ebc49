// SPDX-License-Identifier: MIT-0
// The times of chapter 4: a frame of each net after a blow, in the fewest substeps that hold it and
// in one solved step.
#include "../times.h"

#include <chrono>
#include <cstdlib>
#include <string>
#include <vector>

#include "integrate/bdf2.h"
#include "integrate/trapezoid.h"
#include "measure/time_of.h"
#include "net/nets.h"
#include "net/substeps.h"

namespace {

/// Frames after a blow, before the net is struck anew: so few that what is damped does not die away
/// to numbers with which the processor is slow.
constexpr int frames_of_a_blow = 20;

constexpr int blows = 5;  ///< in one run

/// The time of a frame for each unknown, in one run [s].
/// @param make  gives the step of a frame after a blow, called as `step(state, scene, system)`,
/// true if it could be taken
template <class Scene, class Make>
double time_of_frame(const Scene& scene, Make make) {
  const MassSpringState start = with_random_velocities(scene, gentle);
  auto system = system_of(scene);
  std::chrono::duration<double> elapsed{0};
  for (int blow = 0; blow < blows; ++blow) {
    MassSpringState s = start;
    auto step = make(s, scene);
    measure::forget(s);
    const auto begin = std::chrono::steady_clock::now();
    for (int n = 0; n < frames_of_a_blow; ++n) {
      if (!step(s, scene, system)) std::abort();
    }
    measure::forget(s);
    elapsed += std::chrono::steady_clock::now() - begin;
  }
  return elapsed.count() / (blows * frames_of_a_blow) / double(start.x.size());
}

constexpr auto make_substeps = [](const MassSpringState&, const auto& net) {
  return [steps = substeps_for(net)](MassSpringState& s, const auto& scene, auto&) {
    for (int n = 0; n < steps; ++n) {
      integrate::symplectic_euler(s.x, s.v, 0.0, frame / steps, scene);
    }
    return true;
  };
};

constexpr auto make_backward_euler = [](const MassSpringState&, const auto&) {
  return solved_once;
};

constexpr auto make_trapezoid = [](const MassSpringState&, const auto&) {
  return [](MassSpringState& s, const auto& scene, auto& system) {
    return integrate::trapezoid(s.x, s.v, 0.0, frame, scene, system);
  };
};

constexpr auto make_bdf2 = [](const MassSpringState& start, const auto& net) {
  return [previous = integrate::bdf2_start(start.x, start.v, 0.0, frame, net)](
             MassSpringState& s, const auto& scene, auto& system) mutable {
    return integrate::bdf2(s.x, s.v, previous, 0.0, frame, frame, scene, system);
  };
};

template <class Scene>
void add_net(std::vector<measure::Timed>& all, const std::string& net, const Scene& scene) {
  const auto add = [&](const char* function, auto make) {
    all.push_back({frame_name(net, function), [=] { return time_of_frame(scene, make); }});
  };
  add("symplectic_euler", make_substeps);
  add("backward_euler", make_backward_euler);
  add("bdf2", make_bdf2);
  add("trapezoid", make_trapezoid);
}

}  // namespace

void add_net_times(std::vector<measure::Timed>& all) {
  add_net(all, "chain", steel_chain);
  add_net(all, "rope", steel_rope);
  add_net(all, "cloth", steel_cloth);
}
