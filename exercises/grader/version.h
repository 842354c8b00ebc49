// SPDX-License-Identifier: MIT-0
/// @file
/// Hashes of what was compiled in; versions.cmake writes version.cpp when any of it changes.
#pragma once
#include <string>

namespace grade {

/// The version of the book, and SHA-256 over the grader's own files and those of one exercise, the
/// first sixteen digits.
std::string version_of(const std::string& exercise);

}  // namespace grade
