// SPDX-License-Identifier: MIT-0
/// @file
/// Commands of this program, as a shell finds it from here.
#pragma once
#include <initializer_list>
#include <string>

namespace grade {

/// The program: its name alone where a shell finds it by that, else its path from here.
std::string own_name();

/// The program with what stands behind it, each as one word for a shell.
std::string own_command(std::initializer_list<std::string> words);

}  // namespace grade
