// SPDX-License-Identifier: MIT-0
#include "csv.h"

#include <catch2/catch_test_macros.hpp>

#include "command_line.h"

using namespace grade;

namespace {

using Cells = std::vector<std::string>;

std::vector<Cells> cells(std::string_view text) {
  std::vector<Cells> all;
  for (const CsvRow& row : csv_rows(text, "a.csv")) all.push_back(row.cells);
  return all;
}

std::string refusal(std::string_view text) {
  try {
    csv_rows(text, "a.csv");
  } catch (const Usage& problem) {
    return problem.what();
  }
  return "";
}

}  // namespace

TEST_CASE("a table is read with quotes, separators and line ends as spreadsheets write them") {
  CHECK(cells("a,b\r\n1,2\r\n") == std::vector<Cells>{{"a", "b"}, {"1", "2"}});
  CHECK(cells("a;b,c\n1;2;3") == std::vector<Cells>{{"a;b", "c"}, {"1;2;3"}});
  CHECK(cells("a;b;c,d\n1;2;3") == std::vector<Cells>{{"a", "b", "c,d"}, {"1", "2", "3"}});
  CHECK(cells("a\tb\r1\t2\r") == std::vector<Cells>{{"a", "b"}, {"1", "2"}});
  CHECK(cells("\"Lovelace, \"\"Ada\"\"\",b\n") == std::vector<Cells>{{"Lovelace, \"Ada\"", "b"}});
  CHECK(cells("\"one\r\ntwo\",b\n") == std::vector<Cells>{{"one\r\ntwo", "b"}});
  CHECK(cells("a,,\n") == std::vector<Cells>{{"a", "", ""}});
  CHECK(cells("") == std::vector<Cells>{});
}

TEST_CASE("rows that are empty are left out, and the others know their lines") {
  const auto rows = csv_rows("a,b\n\n,\n\"x\ny\",2\nz,3\n", "a.csv");
  REQUIRE(rows.size() == 3);
  CHECK(rows[1].line == 4);
  CHECK(rows[2].line == 6);
}

TEST_CASE("what is not UTF-8, and a quote without an end, are refused with their line") {
  CHECK(refusal("a\nM\xfcller\n") == "a.csv:2: this is not UTF-8; save it as 'CSV UTF-8'");
  CHECK(refusal(std::string_view("\xff\xfe"
                                 "a\0",
                                 4))
            .starts_with("a.csv:1: this is not UTF-8"));
  CHECK(refusal("a,b\n1,\"2\n3\n") == "a.csv:2: this quote is never closed; put a \" at its end");
}

TEST_CASE("what is written is read as it was, but for what a spreadsheet would compute") {
  CHECK(csv_line({"a,b", "\"q\"", "", "plain"}) == "\"a,b\",\"\"\"q\"\"\",,plain\r\n");
  CHECK(csv_line({"=1+1", "-rf"}) == "'=1+1,'-rf\r\n");
  CHECK(cells(csv_line({"a,b", "\"q\"", "c;d"})) == std::vector<Cells>{{"a,b", "\"q\"", "c;d"}});
  for (const char* text : {"=1+1", "-rf", "'quoted", "'", "", "plain"})
    CHECK(as_was(cells(csv_line({text, "x"}))[0][0]) == text);
}
