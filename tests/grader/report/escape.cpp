// SPDX-License-Identifier: MIT-0
#include "report/escape.h"

#include <catch2/catch_test_macros.hpp>

#include "sample.h"

using namespace grade;

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
