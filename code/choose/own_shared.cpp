// SPDX-License-Identifier: MIT-0
// What `choose --scene my_scene.h` compiles and loads, with the scene included before it.
#include "choose/own_exports.h"

extern "C" OwnForce own_force() {
  return own::force();
}
