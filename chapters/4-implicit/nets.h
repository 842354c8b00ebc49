// SPDX-License-Identifier: MIT-0
/// @file
/// Names of the times of a frame of a net in chapter 4.
#pragma once
#include <string>

/// What the time of a frame of a net is called, for each unknown.
/// @param net  "chain", "rope" or "cloth"
/// @param function  of the method
inline std::string frame_name(const std::string& net, const std::string& function) {
  return "frame of a " + net + "/" + function;
}
