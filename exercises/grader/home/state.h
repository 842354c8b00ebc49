// SPDX-License-Identifier: MIT-0
/// @file
/// The files in which the grader remembers something for whoever calls it.
#pragma once
#include <filesystem>
#include <string>

namespace grade {

/// Its place: beside the program, or, where this user can't write there, in the user's own state,
/// `$XDG_STATE_HOME/one-step-at-a-time` or `~/.local/state/one-step-at-a-time`.
std::filesystem::path state_file(const std::string& name);

/// What it holds; empty if it is not there.
/// @throws NotOwn  it is none of ours
std::string read_state(const std::string& name);

/// Where it can't be written, nothing is remembered.
void write_state(const std::string& name, const std::string& text);

}  // namespace grade
