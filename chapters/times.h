// SPDX-License-Identifier: MIT-0
/// @file
/// What the chapters have timed.
#pragma once
#include <vector>

#include "measure/times.h"

/// The cards: a step of every method, called `card/...`.
void add_card_times(std::vector<measure::Timed>& all);

/// Chapter 3: steps of one spring, called `spring/...`.
void add_spring_times(std::vector<measure::Timed>& all);

/// Chapter 4: a frame of a net, for each unknown, called as `frame_name` says.
void add_net_times(std::vector<measure::Timed>& all);

/// Chapter 7: a step of each method, called as `step_name` says, and of many particles, called
/// `particles/...`.
void add_step_times(std::vector<measure::Timed>& all);
void add_particle_times(std::vector<measure::Timed>& all);

/// Forgets times that can't be right.
void forget_disturbed(measure::Times& times);
