// SPDX-License-Identifier: MIT-0
// What is timed for chapter 7 besides steps: particles in several layouts.
#include "../times.h"

#include <algorithm>
#include <chrono>
#include <memory>
#include <string>

#include "particles.h"

namespace {

/// Particles in one layout; each step moves all of them.
template <class Particles, class Step>
measure::Timed timed(const std::string& layout, const Particles& start, long count, Step step,
                     int substeps = 1) {
  const auto particles = std::make_shared<Particles>(start);
  return {particles_name(layout, count), [=] {
            using Clock = std::chrono::steady_clock;
            const long passes = std::max(1L, 200'000 / count);
            const float h = frame_of_float / float(substeps);
            step(*particles, h);  // others have been in the caches since
            const auto begin = Clock::now();
            for (long pass = 0; pass < passes; ++pass) step(*particles, h);
            const std::chrono::duration<double> elapsed = Clock::now() - begin;
            return elapsed.count() / double(passes * count * substeps);
          }};
}

/// The best of several runs: what can't be undercut.
measure::Timed best_of_five(const measure::Timed& timed) {
  return {timed.name, [run = timed.run] {
            double best = run();
            for (int n = 1; n < 5; ++n) best = std::min(best, run());
            return best;
          }};
}

}  // namespace

void add_particle_times(std::vector<measure::Timed>& all) {
  for (const long count : particle_counts) {
    const auto structs = cloud(count);
    const auto packs = packed(structs);
    all.push_back(timed("structs", structs, count, step_structs));
    all.push_back(
        timed("packs", packs, count, [](auto& all_packs, float h) { step_packs(all_packs, h); }));
    all.push_back(best_of_five(timed("memory", packs, count, touch)));
    all.push_back(timed("blocks", packs, count, step_blocks, steps_a_visit));
  }
}

void forget_disturbed(measure::Times& times) {
  forget_if_disturbed(times);
}
