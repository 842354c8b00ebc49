// SPDX-License-Identifier: MIT-0
/// @file
/// The headers of the standard library that programs of the book include, and exercises. The build
/// precompiles them for the compiler of the page, which would take half a minute for them.
#pragma once

// Without what libc++ includes for old programs alone: a fifth less to load.
#define _LIBCPP_REMOVE_TRANSITIVE_INCLUDES

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <functional>
#include <initializer_list>
#include <iostream>
#include <limits>
#include <map>
#include <numbers>
#include <span>
#include <sstream>
#include <string>
#include <type_traits>
#include <typeinfo>
#include <utility>
#include <vector>

/// What is thrown ends the program: there is nothing in the page to catch it.
extern "C" {
[[gnu::weak]] void* __cxa_allocate_exception(std::size_t) noexcept {
  __builtin_trap();
}
[[gnu::weak, noreturn]] void __cxa_throw(void*, std::type_info*, void (*)(void*)) {
  __builtin_trap();
}
}
