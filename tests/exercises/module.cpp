// SPDX-License-Identifier: MIT-0
// All submissions of ways.mjs in a module for the page's judges, which is told which of them it is.
#include <cstddef>
#include <vector>

#include "steps.h"

/// The header's path, whose letters are copied to where it is told.
extern "C" [[clang::import_module("ways"), clang::import_name("length")]] std::size_t way_length();
extern "C" [[clang::import_module("ways"), clang::import_name("letters")]] void way_letters(
    char* to);

extern "C" void (*way_of(const char* header))(harness::Call&);

void answer(harness::Call& call) {
  std::vector<char> header(way_length() + 1, '\0');
  way_letters(header.data());
  way_of(header.data())(call);
}
