// SPDX-License-Identifier: MIT-0
#include <sys/stat.h>
#include <sys/sysmacros.h>

#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>

#include "around.h"
#include "submission.h"

using Catch::Matchers::ContainsSubstring;
using grade::Submission;
namespace fs = std::filesystem;

namespace {

const std::string text = "inline void step() {}\n";
const std::string header = "orbit-drift.h";

Submission take(const fs::path& path) {
  return grade::read_submission(path, "2-euler", header);
}

/// What is said of a file with this content.
std::string said_of(const std::string& content) {
  const Folder folder;
  return take(folder.write(header, content)).refused;
}

}  // namespace

TEST_CASE("A header is taken as it is, under any name, with its mark and its line ends") {
  const Folder folder;
  for (const std::string& content : {text, "\xef\xbb\xbf" + text,
                                     std::string("// Gr\xc3\xb6\xc3\x9f"
                                                 "e\r\nint x;\r\n")}) {
    const Submission taken = take(folder.write("my_euler.h", content));
    CHECK(taken.refused.empty());
    CHECK(taken.text == content);
  }
}

TEST_CASE("A folder gives its header, or its chapter's, and the names of what is ignored") {
  const Folder folder;
  folder.write(header, text);
  folder.write("README.md", "hello");
  folder.write(".DS_Store", "x");
  folder.write("a\n\x1b[31m.o", "x");
  Submission taken = take(folder.path());
  CHECK(taken.text == text);
  CHECK(taken.ignored == std::vector<std::string>{".DS_Store", "README.md", "a\n\\x1b[31m.o"});
  CHECK(take(folder.path() / "").text == text);
  CHECK(take(folder.path() / ".").text == text);

  const Folder deeper;
  deeper.write("2-euler/" + header, text);
  CHECK(take(deeper.path()).text == text);
}

TEST_CASE("A path that is not there is the caller's mistake") {
  const Folder folder;
  for (const fs::path& path : {folder / "none", folder / "none/none.h", fs::path("/no/such")}) {
    const Submission taken = take(path);
    CHECK(taken.unreadable);
    CHECK_THAT(taken.refused, ContainsSubstring("No such file"));
  }
}

TEST_CASE("A folder without the header says which names were expected and found") {
  const Folder folder;
  CHECK_THAT(take(folder.path()).refused,
             ContainsSubstring("2-euler/" + header) && ContainsSubstring("the folder is empty"));
  folder.write("notes.txt", text);
  CHECK_THAT(take(folder.path()).refused, ContainsSubstring("there is notes.txt"));
  for (const char* name : {"Orbit-Drift.h", "orbit_drift.h", "orbit-drift.hpp", "orbit-drfit.h",
                           "2-euler/ORBIT-DRIFT.H"}) {
    const Folder near;
    near.write(name, text);
    const std::string last = fs::path(name).filename();
    CHECK_THAT(take(near.path()).refused, ContainsSubstring("is it " + last + "?"));
  }
}

TEST_CASE("No symbolic link is followed, and another hard link is noted") {
  const Folder folder;
  folder.write("real/" + header, text);
  fs::create_symlink(folder / "real" / header, folder / "link.h");
  CHECK_THAT(take(folder / "link.h").refused, ContainsSubstring("is a symbolic link"));

  fs::create_directory(folder / "a");
  fs::create_symlink(folder / "real" / header, folder / "a" / header);
  CHECK_THAT(take(folder / "a").refused, ContainsSubstring("is a symbolic link"));

  fs::create_directory_symlink(folder / "real", folder / "b");
  CHECK_FALSE(take(folder / "b").refused.empty());

  fs::create_directory(folder / "c");
  fs::create_directory_symlink(folder / "real", folder / "c" / "2-euler");
  CHECK_THAT(take(folder / "c").refused, ContainsSubstring("2-euler is a symbolic link"));

  fs::create_hard_link(folder / "real" / header, folder / "hard.h");
  CHECK(take(folder / "hard.h").text == text);
  CHECK(take(folder / "hard.h").linked);
  CHECK_FALSE(take(folder.write("alone.h", text)).linked);
}

TEST_CASE("What is no plain file is refused, and does not hold the grader up") {
  const Folder folder;
  const Clock clock;
  REQUIRE(::mkfifo((folder / header).c_str(), 0644) == 0);
  CHECK_THAT(take(folder.path()).refused, ContainsSubstring("is no regular file"));
  CHECK_THAT(take("/dev/zero").refused, ContainsSubstring("is no regular file"));
  CHECK(clock.seconds() < 1);

  const Folder other;
  fs::create_directory(other / header);
  CHECK_THAT(take(other.path()).refused, ContainsSubstring("is a folder"));

  const fs::path file = other.write("own.h", text);
  REQUIRE(::chmod(file.c_str(), S_ISUID | 0755) == 0);
  CHECK_THAT(take(file).refused, ContainsSubstring("setuid"));
}

TEST_CASE("What is no text is named as what it is") {
  using namespace std::literals;
  CHECK_THAT(said_of("PK\x03\x04"s + text), ContainsSubstring("is a zip archive; hand in the"));
  CHECK_THAT(said_of("\x1f\x8b\x08"s + text), ContainsSubstring("is a gzip archive"));
  CHECK_THAT(said_of("\x7f"
                     "ELF"s +
                     text),
             ContainsSubstring("is a compiled program"));
  CHECK_THAT(said_of(std::string(257, 'x') + "ustar"), ContainsSubstring("is a tar archive"));
  CHECK_THAT(said_of("\xff\xfei\0n\0t\0"s), ContainsSubstring("save it as UTF-8"));
  CHECK_THAT(said_of("\xff\xfe\0\0i\0\0\0"s), ContainsSubstring("is saved as UTF-32"));
  CHECK_THAT(said_of("\xef\xbb\xbf\xef\xbb\xbfint x;\n"),
             ContainsSubstring("two byte order marks"));
  CHECK_THAT(said_of("int x;\n\x1a"), ContainsSubstring("Ctrl-Z"));
  CHECK_THAT(said_of("i\0n\0t\0 \0x\0;\0"s), ContainsSubstring("is saved as UTF-16"));
  CHECK_THAT(said_of("int x;\0"s), ContainsSubstring("zero byte"));
  CHECK_THAT(said_of("int x;\n// Gr\xf6\xdf"
                     "e\n"),
             ContainsSubstring("see line 2"));
  CHECK_THAT(said_of("// \xed\xa0\x80\n"), ContainsSubstring("not UTF-8"));
  CHECK_THAT(said_of("// \xc0\xaf\n"), ContainsSubstring("not UTF-8"));
}

TEST_CASE("An empty file and one that is too long are refused, the longest is not") {
  for (const char* nothing : {"", " \t\r\n\n", "\xef\xbb\xbf\n"})
    CHECK_THAT(said_of(nothing), ContainsSubstring("is empty; it must define"));
  CHECK(said_of(std::string(65536, '\n').replace(0, 1, ";")).empty());
  CHECK_THAT(said_of(std::string(65537, '\n').replace(0, 1, ";")), ContainsSubstring("64 KiB"));
}
