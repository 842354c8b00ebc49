// SPDX-License-Identifier: MIT-0
#include "course/zip.h"

#include <catch2/catch_test_macros.hpp>
#include <stdexcept>

#include "course/base64.h"
#include "course/student_page.h"

using namespace grade;

TEST_CASE("the checksum is that of archives") {
  CHECK(crc32("123456789") == 0xcbf43926);
  CHECK(crc32("") == 0);
}

TEST_CASE("an archive is the same for the same files, and of too many is refused") {
  CHECK(zip({{"a/b", "text"}}) == zip({{"a/b", "text"}}));
  CHECK_THROWS_AS(zip(std::vector<ZipFile>(65535)), std::length_error);
  CHECK_NOTHROW(zip(std::vector<ZipFile>(65534)));
}

TEST_CASE("bytes become Base64 as the standard's examples do") {
  CHECK(base64("") == "");
  CHECK(base64("f") == "Zg==");
  CHECK(base64("fo") == "Zm8=");
  CHECK(base64("foo") == "Zm9v");
  CHECK(base64("foobar") == "Zm9vYmFy");
  CHECK(base64("\xff\xfe\xfd") == "//79");
}

TEST_CASE("a student's file has a name that leads nowhere, and no other student's") {
  CHECK(page_name("ada@example.org") == "ada@example.org.html");
  CHECK(page_name("../x") == "%2E.%2Fx.html");
  CHECK(page_name("%2E.%2Fx") == "%252E.%252Fx.html");
  CHECK(page_name("a b\n") == "a%20b%0A.html");
  const std::string long_key(255, '/');
  CHECK(page_name(long_key).size() < 200);
  CHECK(page_name(long_key) != page_name(long_key + "/"));
}
