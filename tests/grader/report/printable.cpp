// SPDX-License-Identifier: MIT-0
#include "printable.h"

#include <catch2/catch_test_macros.hpp>
#include <vector>

using namespace grade;

TEST_CASE("printable text hides nothing") {
  CHECK(printable("a\x1b[31mb\a\x7f") == "a\\x1b[31mb\\x07\\x7f");
  CHECK(printable("\xff\xc0\x80\xed\xa0\x80") == "\\xff\\xc0\\x80\\xed\\xa0\\x80");
  CHECK(printable("\xe2\x80\xae"
                  "abc"
                  "\xef\xbb\xbf") == "\\u{202e}abc\\u{feff}");
  CHECK(printable("\xc2\x85") == "\\x85");
  CHECK(printable("r\xc3\xa9sum\xc3\xa9 \xce\xb8\n\ttab\r\nline") ==
        "r\xc3\xa9sum\xc3\xa9 \xce\xb8\n\ttab\nline");
  CHECK(printable("\r") == "\\x0d");
  CHECK(printable("") == "");
}

TEST_CASE("printable text spells out characters without a shape") {
  CHECK(printable("\xc2\xad") == "\\u{ad}");
  CHECK(printable("\xe2\x80\x8b") == "\\u{200b}");
  for (const char last : {'\xa0', '\xa1', '\xa2', '\xa3', '\xa4', '\xa5'}) {
    const std::string shown = printable(std::string("\xe2\x81") + last);
    CHECK(shown == std::string("\\u{206") + char('0' + (last & 0xf)) + "}");
  }
}

TEST_CASE("printable text is cut at so many bytes, and says so") {
  CHECK(printable("abcd", 4) == "abcd");
  CHECK(printable("abcde", 4) == "abcd [cut]");
  CHECK(printable("abc\xc3\xa9", 4) == "abc [cut]");
  CHECK(printable("\x1b\x1b", 4) == "\\x1b [cut]");
  CHECK(printable("::x", 2) == ": : [cut]");
}

TEST_CASE("printable text is printable as it stands") {
  const std::string shown = printable("\x1b\t::a\r\n::b \xe2\x80\x8b##[c]");
  CHECK(printable(shown) == shown);
}

TEST_CASE("printable text holds no command for a CI service") {
  CHECK(printable("::error::x") == ": :error::x");
  CHECK(printable("a\n  \t::stop-commands::x") == "a\n  \t: :stop-commands::x");
  CHECK(printable("see ##[error]x") == "see ## [error]x");
  CHECK(printable("###[x] ##vso[x] ##teamcity[x]") == "### [x] ## vso[x] ## teamcity[x]");
  CHECK(printable("std::vector # 3") == "std::vector # 3");
}

TEST_CASE("no two names become the same printable name") {
  const std::vector<std::string> names{"a\nb", "a\\x0ab", "a\\\\x0ab", "##[x",  "## [x",
                                       ":a",   "\\x3aa",  "\xff",      "\\xff", "# #"};
  for (const auto& a : names) {
    for (const auto& b : names) CHECK((&a == &b || printable_name(a) != printable_name(b)));
    CHECK(printable_name(a).find_first_of("\n\xff") == std::string::npos);
    CHECK(printable(printable_name(a)) == printable_name(a));
  }
}
