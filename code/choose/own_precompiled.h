// SPDX-License-Identifier: MIT-0
/// @file
/// What is compiled together with a reader's scene, and takes longer to read than the scene: read
/// once, when `choose` is built.
#pragma once
#include <Eigen/Dense>
#include <cmath>
#include <concepts>
#include <cstdio>
#include <stdexcept>
#include <vector>

#include "choose/cost.h"
#include "choose/own_scene.h"
#include "measure/methods.h"
#include "measure/time_of.h"
#include "measure/times.h"
