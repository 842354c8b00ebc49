// SPDX-License-Identifier: MIT-0
/// @file
/// Where the recorded times of a scene are.
#pragma once
#include "scenes/linear_drag.h"
#include "scenes/orbit.h"
#include "scenes/pendulum.h"
#include "scenes/spring.h"
#include "scenes/toss.h"

/// The thing of chapter 7's level that a scene is like, since times were recorded of these.
inline const char* timed_as(const scenes::Spring<>&) {
  return "suspension";
}
inline const char* timed_as(const scenes::Orbit<>&) {
  return "shuttle";
}
inline const char* timed_as(const scenes::Pendulum<>&) {
  return "lamp";
}
inline const char* timed_as(const scenes::LinearDrag<>&) {
  return "leaf";
}
inline const char* timed_as(const scenes::Toss&) {
  return "jump";
}

template <class Scene>
const char* timed_as(const Scene&) {
  return nullptr;  // nobody took the time of such a scene
}
