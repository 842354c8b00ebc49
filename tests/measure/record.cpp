// SPDX-License-Identifier: MIT-0
#include "measure/record.h"

#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_exception.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>
#include <cstdlib>
#include <fstream>
#include <limits>
#include <sstream>

#include "folder.h"

using Catch::Matchers::ContainsSubstring;
using measure::Record;
namespace fs = std::filesystem;

namespace {

Record two_tables() {
  Record record;
  record.number("speed", 12.5, 3, "m/s");
  record.number("turns", 480, measure::whole);
  auto& path = record.table("path", {{"t", "s"}, {"x", "m", 5}});
  path.add({0.0, 1.0});
  path.add({0.1, -2.5e-7});
  record.table("planets", {{"name"}, {"mass", "kg", 2}}).add({"Jupiter", 1.9e27});
  return record;
}

// Runs what a chapter's main runs.
int run_main(std::vector<std::string> arguments, bool& filled) {
  std::vector<char*> argv;
  for (auto& argument : arguments) argv.push_back(argument.data());
  return measure::record(static_cast<int>(argv.size()), argv.data(), [&filled](Record& record) {
    filled = true;
    record.number("speed", 1, 3);
  });
}

}  // namespace

TEST_CASE("Numbers and tables are written as the book reads them") {
  const Folder folder;
  two_tables().write(folder.path);
  CHECK(folder.files() == std::set<std::string>{"numbers.csv", "path.csv", "planets.csv",  //
                                                "tables.csv"});
  CHECK(folder.read("numbers.csv") == "name,value,unit,digits\nspeed,12.5,m/s,3\nturns,480,,0\n");
  CHECK(folder.read("path.csv") == "t,x\n0,1\n0.1,-2.5e-07\n");
  CHECK(folder.read("planets.csv") == "name,mass\nJupiter,1.9e+27\n");
  CHECK(folder.read("tables.csv") ==
        "table,column,unit,digits\n"
        "path,t,s,3\npath,x,m,5\nplanets,name,,text\nplanets,mass,kg,2\n");
}

TEST_CASE("A word above a column's numbers leaves it a column of numbers") {
  const Folder folder;
  Record record;
  auto& errors = record.table("errors", {{"method"}, {"error", "m", 2}});
  errors.add({"exact", "rounding"});
  errors.add({"Euler", 0.25});
  record.write(folder.path);
  CHECK(folder.read("errors.csv") == "method,error\nexact,rounding\nEuler,0.25\n");
  CHECK(folder.read("tables.csv") ==
        "table,column,unit,digits\nerrors,method,,text\nerrors,error,m,2\n");
}

TEST_CASE("A number that is read back is the same number, to the last bit") {
  const Folder folder;
  Record record;
  const double values[] = {1.0 / 3,
                           6.02214076e23,
                           -5e-324,
                           0.1 + 0.2,
                           std::numeric_limits<double>::max(),
                           std::numeric_limits<double>::infinity()};
  int n = 0;
  for (const double value : values) record.number("value-" + std::to_string(n++), value, 3);
  record.write(folder.path);
  std::istringstream lines(folder.read("numbers.csv"));
  std::string line;
  std::getline(lines, line);
  for (const double value : values) {
    std::getline(lines, line);
    CHECK(std::strtod(line.c_str() + line.find(',') + 1, nullptr) == value);
  }
}

TEST_CASE("Words with a comma stay one cell") {
  const Folder folder;
  Record record;
  record.table("cards", {{"when to use it"}}).add({"never, or nearly"});
  record.write(folder.path);
  CHECK(folder.read("cards.csv") == "when to use it\n\"never, or nearly\"\n");
}

TEST_CASE("A column's name with a comma stays one name") {
  const Folder folder;
  Record record;
  record.table("newton", {{"rope, gentle"}, {"cloth"}}).add({1.0, 2.0});
  record.write(folder.path);
  CHECK(folder.read("newton.csv") == "\"rope, gentle\",cloth\n1,2\n");
  CHECK_THAT(folder.read("tables.csv"),
             Catch::Matchers::ContainsSubstring("newton,\"rope, gentle\",,3\n"));
}

TEST_CASE("A second write replaces the first") {
  const Folder folder;
  two_tables().write(folder.path);
  Record other;
  other.number("speed", 13, 3);
  other.write(folder.path);
  CHECK(folder.read("numbers.csv") == "name,value,unit,digits\nspeed,13,,3\n");
}

TEST_CASE("The first table stays good while others are added") {
  const Folder folder;
  Record record;
  auto& first = record.table("first", {{"n"}});
  for (int n = 0; n < 100; ++n) record.table("other-" + std::to_string(n), {{"n"}});
  first.add({7.0});
  record.write(folder.path);
  CHECK(folder.read("first.csv") == "n\n7\n");
}

TEST_CASE(
    "Where a file can't be written, one line says which and why, and nothing is left behind") {
  const Folder folder;
  SECTION("in a folder that is not there") {
    const fs::path missing = folder.path / "missing";
    CHECK_THROWS_WITH(two_tables().write(missing),
                      ContainsSubstring(missing.string()) && ContainsSubstring("No such file"));
    CHECK(folder.files().empty());
  }
  SECTION("in a file") {
    std::ofstream(folder.path / "file") << "mine";
    CHECK_THROWS_WITH(two_tables().write(folder.path / "file"), ContainsSubstring("Not a dir"));
    CHECK(folder.files() == std::set<std::string>{"file"});
    CHECK(folder.read("file") == "mine");
  }
  SECTION("where the last of the files is in the way") {
    std::ofstream(folder.path / "numbers.csv") << "old";
    fs::create_directories(folder.path / "tables.csv.part" / "full");
    CHECK_THROWS_WITH(two_tables().write(folder.path), ContainsSubstring("tables.csv"));
    CHECK(folder.files() == std::set<std::string>{"numbers.csv", "tables.csv.part"});
    CHECK(folder.read("numbers.csv") == "old");
  }
  SECTION("where a folder has the name of a table") {
    fs::create_directories(folder.path / "tables.csv" / "full");
    CHECK_THROWS_WITH(two_tables().write(folder.path), ContainsSubstring("tables.csv"));
    for (const std::string& name : folder.files()) CHECK_FALSE(name.ends_with(".part"));
  }
}

TEST_CASE("A chapter's program writes into the folder it is given") {
  const Folder folder;
  bool filled = false;
  CHECK(run_main({"program", folder.path.string()}, filled) == 0);
  CHECK(folder.files() == std::set<std::string>{"numbers.csv", "tables.csv"});
}

TEST_CASE("A chapter's program refuses what it does not know before it does any work") {
  const Folder folder;
  const std::string given = folder.path.string();
  bool filled = false;
  CHECK(run_main({"program", "--help"}, filled) == 2);
  CHECK(run_main({"program", given, "more"}, filled) == 2);
  CHECK(run_main({"program", given + "/missing"}, filled) == 2);
  CHECK_FALSE(filled);
  CHECK(folder.files().empty());
}

TEST_CASE("A name that is recorded twice and a row of the wrong length are told by name") {
  Record record = two_tables();
  CHECK_THROWS_WITH(record.number("speed", 1, 3), "the number \"speed\" is recorded twice");
  CHECK_THROWS_WITH(record.table("path", {{"t"}}), "the table \"path\" is recorded twice");
  CHECK_THROWS_WITH(record.table("pair", {{"a"}, {"b"}}).add({1.0}),
                    "table \"pair\": a row of 1 cells for 2 columns");
}

TEST_CASE("A chapter's program that records a name twice says so and exits with 2") {
  char program[] = "program";
  char* argv[] = {program};
  CHECK(measure::record(1, argv, [](Record& record) {
          record.number("speed", 1, 3);
          record.number("speed", 2, 3);
        }) == 2);
}
