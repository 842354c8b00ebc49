// SPDX-License-Identifier: MIT-0
/// @file
/// The thrown body of chapter 6: what five ways of turning it make of its energy, and where it is.
#pragma once
#include "../cast.h"
#include "../play/crate.h"
#include "measure/record.h"
#include "measure/tumbling.h"

/// The share of its energy that the thrown body has after ten seconds.
template <class Way>
double energy_after_ten_seconds(Way way) {
  measure::Tumbling body;
  const double thrown = body.energy();
  for (int n = 0; n < 600; ++n) way(body, frame);
  return body.energy() / thrown;
}

inline void tumbling(measure::Record& record) {
  auto& table = record.table(
      "tumbling",
      {{"turned by"}, {"energy after ten seconds", "%", 4}, {"off within the first", "rad", 2}});
  const auto add = [&](const char* name, auto way) {
    table.add({name, 100 * energy_after_ten_seconds(way), measure::off_in_a_second(way)});
  };
  add("its spin at the start of the step", measure::by_its_spin);
  add("Bullet's gyroscopic step", measure::by_bullet);
  add("Jolt's gyroscopic step", measure::by_jolt);
  add("midpoint rule", measure::by_midpoint);
  add("rotations", measure::by_rotations);
}

/// The energies of the crate of the film, relative to its throw, while it is turned in three ways.
/// @param observe  called as `observe(t, naive, bullet, rotations)` at the start and after each of
/// 600 frames
template <class Observe>
void throw_a_crate(Observe&& observe) {
  play::Crate naive, bullet, rotations;
  const double thrown = naive.energy();
  for (int n = 0; n <= 600; ++n) {
    observe(n * frame, naive.energy() / thrown, bullet.energy() / thrown,
            rotations.energy() / thrown);
    measure::by_its_spin(naive, frame);
    measure::by_bullet(bullet, frame);
    measure::by_rotations(rotations, frame);
  }
}

inline void thrown_crate(measure::Record& record) {
  auto& table = record.table("thrown-crate", {{"t", "s"}, {"naive"}, {"bullet"}, {"rotations"}});
  throw_a_crate([&](double t, double naive, double bullet, double rotations) {
    table.add({t, naive, bullet, rotations});
  });
}
