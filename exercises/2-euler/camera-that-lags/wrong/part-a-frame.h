// fails: a frame of any length takes the camera as far as frames of a sixtieth would
// SPDX-License-Identifier: MIT-0
#pragma once
#include "given.h"

// The frame is not looked at: twice as fast on twice the screen. In Phaser it was like this (its
// issue 7352).
inline Vec follow(const Vec& camera, const Vec& target, double part, double frame) {
  return camera + part * (target - camera);
}
