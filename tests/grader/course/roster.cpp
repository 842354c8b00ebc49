// SPDX-License-Identifier: MIT-0
#include "course/roster.h"

#include <unistd.h>

#include <catch2/catch_test_macros.hpp>
#include <filesystem>
#include <fstream>

#include "command_line.h"

using namespace grade;

namespace {

const std::filesystem::path file =
    std::filesystem::temp_directory_path() / ("roster-" + std::to_string(::getpid()) + ".csv");

/// `key|name` of each.
std::vector<std::string> members(const std::string& text, const std::string& key = "") {
  std::ofstream(file) << text;
  std::vector<std::string> all;
  for (const Member& one : read_roster(file, key)) all.push_back(one.key + "|" + one.name);
  std::filesystem::remove(file);
  return all;
}

/// Without the file's folder.
std::string refusal(const std::string& text, const std::string& key = "") {
  try {
    members(text, key);
  } catch (const Usage& problem) {
    std::filesystem::remove(file);
    return std::string(problem.what()).substr(file.string().size());
  }
  return "";
}

using All = std::vector<std::string>;

}  // namespace

TEST_CASE("a roster by hand is a name a line, or has a column called student") {
  CHECK(members("ada\n\nbob \n") == All{"ada|", "bob|"});
  CHECK(members("student\nada\n") == All{"ada|"});
  CHECK(members("Name,Student\nAda L.,ada\n") == All{"ada|Ada L."});
}

TEST_CASE("exports of Moodle are read, in English and German, with their mark and semicolons") {
  CHECK(
      members("\xef\xbb\xbf\"First name\",\"Last name\",\"ID number\",\"Email address\",Groups\r\n"
              "Ada,Lovelace,4711,ada@example.org,\"A, B\"\r\n") ==
      All{"ada@example.org|Ada Lovelace"});
  CHECK(members("Vorname;Nachname;ID-Nummer;E-Mail-Adresse\nAda;Lovelace;;ada@example.org\n") ==
        All{"ada@example.org|Ada Lovelace"});
  CHECK(members("Identifier,\"Full name\",\"Email address\",Grade\n"
                "\"Participant 12\",\"Ada Lovelace\",ada@example.org,\n") ==
        All{"ada@example.org|Ada Lovelace"});
}

TEST_CASE("Canvas's gradebook is read without its row of what could be had") {
  const std::string text =
      "Student,ID,SIS User ID,SIS Login ID,Section,Week 1 (12)\n"
      "    Points Possible,,,,,10\n"
      "\"Lovelace, Ada\",4711,S1,ada,Spring,\n";
  CHECK(members(text) == All{"4711|Lovelace, Ada"});
  CHECK(members(text, "SIS Login ID") == All{"ada|Lovelace, Ada"});
}

TEST_CASE("any column can be the key") {
  CHECK(members("a,Matrikel\nx,12\ny,13\n", "Matrikel") == All{"12|", "13|"});
  CHECK(refusal("a,Matrikel\nx,12\n", "Martikel") ==
        ":1: there is no column 'Martikel'; did you mean 'Matrikel'?");
}

TEST_CASE("what is wrong in a roster is said with its line") {
  CHECK(refusal("").starts_with(":1: this roster is empty"));
  CHECK(refusal("student\n").starts_with(":1: this roster names nobody"));
  CHECK(refusal("a,b\n1,2\n").starts_with(":1: which column names a student? Call it 'student'"));
  CHECK(refusal("student\nada\n\nada\n") == ":4: 'ada' stands in line 2 already; take one away");
  CHECK(
      refusal("student,name\n,Ada\n").starts_with(":2: the cell that names the student is empty"));
  CHECK(refusal("student\na\xff\n").starts_with(":2: this is not UTF-8"));
}

TEST_CASE("a folder is whose it is called like, by key or as Moodle calls it, and nobody else's") {
  const std::vector<Member> roster{{"ada@x", "Ada O'Brien_Lovelace", 2},
                                   {"bob@x", "Bob", 3},
                                   {"rob@x", "Rob", 4},
                                   {"rob2@x", "Rob", 5}};
  const auto found = match(roster, {{"Ada OBrien Lovelace_4711_assignsubmission_file", {}},
                                    {"Rob_12_assignsubmission_file_", {}},
                                    {"Rob_x_assignsubmission_file_", {}},
                                    {"bob@X", {}},
                                    {"rob@x", {}}});
  REQUIRE(found.all.size() == 4);
  REQUIRE(found.all[0].folder.has_value());
  CHECK(found.all[0].folder->name == "Ada OBrien Lovelace_4711_assignsubmission_file");
  CHECK(!found.all[1].folder);
  CHECK(found.all[2].folder->name == "rob@x");
  CHECK(found.unmatched ==
        All{"Rob_12_assignsubmission_file_", "Rob_x_assignsubmission_file_", "bob@X"});
}

TEST_CASE("two folders of one member are refused") {
  CHECK_THROWS_AS(match({{"ada", "Ada", 1}}, {{"Ada_1_assignsubmission_file_", {}}, {"ada", {}}}),
                  Usage);
}
