// SPDX-License-Identifier: MIT-0
/// @file
/// In the page the judges' tests register themselves here, where else they do so in Catch2.
#ifndef CATCH_TEST_MACROS_HPP_INCLUDED
#define CATCH_TEST_MACROS_HPP_INCLUDED
#include "page/registered.h"

#define PAGE_TEST_OF(line) page_test_##line
#define PAGE_TEST_AT(line, name, tags)                                                  \
  static void PAGE_TEST_OF(line)();                                                     \
  static const page::Registered page_registered_##line(PAGE_TEST_OF(line), name, tags); \
  static void PAGE_TEST_OF(line)()
#define PAGE_EXPANDED(line, name, tags) PAGE_TEST_AT(line, name, tags)
#define TEST_CASE(name, tags) PAGE_EXPANDED(__LINE__, name, tags)

#define REQUIRE(held)              \
  do {                             \
    if (!(held)) page::end_test(); \
  } while (false)

#endif
