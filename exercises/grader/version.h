// SPDX-License-Identifier: MIT-0
/// @file
/// Hashes of what was compiled in; versions.cmake writes version.cpp when any of it changes.
#pragma once
#include <map>
#include <string>

namespace grade {

/// Of each exercise that this grader can judge, by its name: the version of the book, and SHA-256
/// over the grader's own files and those of the exercise, the first sixteen digits.
const std::map<std::string, std::string>& versions();

}  // namespace grade
