// SPDX-License-Identifier: MIT-0
#pragma once

const harness::Wanted<Vec(const Vec& from, const Vec& target, const Vec& runner, const Vec& a,
                          double time)>
    wanted = throw_velocity;

void answer(harness::Call& call) {
  const Vec from = call.vector(), target = call.vector(), runner = call.vector(), a = call.vector();
  call.answer(wanted(from, target, runner, a, call.number()));
}
