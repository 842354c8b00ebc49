// SPDX-License-Identifier: MIT-0
#pragma once

const harness::Wanted<Vec(const Vec& camera, const Vec& target, double part, double fastest,
                          double frame)>
    wanted = follow;

void answer(harness::Call& call) {
  const Vec camera = call.vector(), target = call.vector();
  const double part = call.number(), fastest = call.number();
  call.answer(wanted(camera, target, part, fastest, call.number()));
}
