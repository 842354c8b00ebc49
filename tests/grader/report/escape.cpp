// SPDX-License-Identifier: MIT-0
#include "report/escape.h"

#include <catch2/catch_test_macros.hpp>

#include "sample.h"

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

TEST_CASE("Markdown means no more than its letters") {
  CHECK(markdown("*a* _b_ `c` [d](e) ~f~ |g| $h$") ==
        "\\*a\\* \\_b\\_ \\`c\\` \\[d\\](e) \\~f\\~ \\|g\\| \\$h\\$");
  CHECK(markdown("<b>&amp;") == "&lt;b\\>&amp;amp;");
  CHECK(markdown("@name https://x www.x") == "&#64;name https:&#47;/x www&#46;x");
  CHECK(markdown("# a") == "\\# a");
  CHECK(markdown("- a") == "\\- a");
  CHECK(markdown("1. a") == "1\\. a");
  CHECK(markdown("1e-13, 0.5") == "1e-13, 0.5");
  CHECK(markdown("a\nb\n\n# c") == "a b  \\# c");
}

TEST_CASE("a fence is longer than any in the text") {
  CHECK(markdown_code("a") == "```text\na\n```\n");
  CHECK(markdown_code("a ```` b\n") == "`````text\na ```` b\n`````\n");
}

TEST_CASE("HTML and XML are escaped in quotes too") {
  CHECK(html("<a href=\"x\">'&") == "&lt;a href=&quot;x&quot;&gt;&#39;&amp;");
}
