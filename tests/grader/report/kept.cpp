// SPDX-License-Identifier: MIT-0
#include <sys/stat.h>

#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_exception.hpp>
#include <system_error>

#include "../../measure/folder.h"
#include "report/files.h"
#include "report/folder.h"
#include "report/gradescope.h"
#include "report/json.h"
#include "report/junit.h"
#include "sample.h"

using namespace grade;

namespace {

const std::set<Emit> both{Emit::gradescope, Emit::junit};

}  // namespace

TEST_CASE("a file is whole or not there") {
  const Folder folder;
  write_whole(folder.path / "a", "one");
  write_whole(folder.path / "a", "two");
  CHECK(folder.read("a") == "two");
  CHECK(folder.files() == std::set<std::string>{"a"});
  std::filesystem::create_directory(folder.path / "b");
  CHECK_THROWS_AS(write_whole(folder.path / "b", "x"), std::system_error);
  CHECK_THROWS_AS(write_whole(folder.path / "none" / "c", "x"), std::system_error);
  CHECK(folder.files() == std::set<std::string>{"a", "b"});
  CHECK(read_whole(folder.path / "a") == "two");
  CHECK_THROWS_AS(read_whole(folder.path / "b"), NotOwn);
  CHECK_FALSE(read_whole(folder.path / "none"));
}

TEST_CASE("what is no plain file, or too long to be the grader's own, is not read") {
  const Folder folder;
  write_whole(folder.path / "file", "12345");
  CHECK(read_whole(folder.path / "file", 5) == "12345");
  CHECK_THROWS_AS(read_whole(folder.path / "file", 4), NotOwn);
  std::filesystem::create_symlink("file", folder.path / "link");
  std::filesystem::create_symlink("none", folder.path / "leads nowhere");
  REQUIRE(mkfifo((folder.path / "pipe").c_str(), 0600) == 0);
  for (const char* name : {"link", "leads nowhere", "pipe"})
    CHECK_THROWS_AS(read_whole(folder.path / name), NotOwn);
  CHECK_FALSE(read_whole(folder.path / "none"));
}

TEST_CASE("a written file may be read by whom the mask allows") {
  const Folder folder;
  const mode_t mask = umask(027);
  write_whole(folder.path / "a", "one");
  umask(mask);
  struct stat about;
  REQUIRE(stat((folder.path / "a").c_str(), &about) == 0);
  CHECK((about.st_mode & 0777) == 0640);
}

TEST_CASE("a report exists from the first moment, and says that the grader was stopped") {
  const Folder folder;
  Report begun = sample();
  begun.seed = 7;
  const auto out = folder.path / "a" / "b";
  keep_provisional(begun, out, both);
  const std::optional<Report> kept = report_from(read_whole(out / "report.json").value());
  REQUIRE(kept);
  CHECK(kept->verdict == Verdict::grader_error);
  CHECK(kept->try_again);
  CHECK(kept->why.find("stopped before") != std::string::npos);
  CHECK(kept->seed == 7);
  CHECK(kept->tests[0].held == begun.tests[0].held);  // what it had come to
  for (const char* file : {"feedback.md", "junit.xml"}) {
    CHECK(read_whole(out / file).value().find("GRADER_ERROR") != std::string::npos);
  }
  CHECK_FALSE(read_whole(out / "results.json"));  // Gradescope takes no file without a score
}

TEST_CASE("a report takes the place of the one before, and so do its plots") {
  const Folder folder;
  Report report = sample();
  keep(report, folder.path, {});
  CHECK(report.tests[1].findings[0].plot.file == "plots/test-2.svg");
  CHECK(read_whole(folder.path / "plots/test-2.svg"));
  write_whole(folder.path / "plots/mine.svg", "not the grader's");
  Report full = sample();
  full.tests[1] = full.tests[0];
  keep(full, folder.path, {});
  CHECK_FALSE(read_whole(folder.path / "plots/test-2.svg"));
  CHECK(read_whole(folder.path / "plots/mine.svg"));
}

TEST_CASE("a file that is not the grader's own is in its way") {
  const Folder folder;
  CHECK(foreign_file(folder.path / "none").empty());
  std::filesystem::create_directory(folder.path / "plots");
  write_whole(folder.path / "plots/mine.svg", "not the grader's");
  CHECK(foreign_file(folder.path).empty());
  for (const char* mine :
       {"report.json", "feedback.md", "results.json", "junit.xml", "plots/test-1.svg"}) {
    write_whole(folder.path / mine, "{}");
    CHECK(foreign_file(folder.path) == mine);
    std::filesystem::remove(folder.path / mine);
  }
  Report report = sample();
  keep(report, folder.path, both);
  CHECK(foreign_file(folder.path).empty());
}

TEST_CASE("other formats are made of what report.json holds") {
  const std::optional<Report> back = report_from(to_json(sample()));
  REQUIRE(back);
  CHECK(gradescope(*back) == gradescope(sample()));
  CHECK(junit(*back) == junit(sample()));
}
