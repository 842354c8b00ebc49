// SPDX-License-Identifier: MIT-0
#include "compile.h"

#include <algorithm>
#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>
#include <iterator>
#include <sstream>

#include "around.h"
#include "diagnostics.h"
#include "kit/compiler.h"
#include "signature.h"

using cage::Sandbox;
using Catch::Matchers::ContainsSubstring;
using grade::Compiled;
using grade::Verdict;

namespace {

/// An exercise that asks for one function of one vector.
const std::string asks = R"(#include "call.h"
const harness::Wanted<void(Vec& x)> wanted = step;
void answer(harness::Call& call) {
  Vec x = call.vector();
  wanted(x);
  call.answer(x);
}
)";

const std::string good = "inline void step(Vec& x) { x = 2 * x; }\n";

cage::Limits usual() {
  cage::Limits limits;
  limits.processor = 10;
  limits.wall = 30;
  limits.memory = 2'500'000'000;
  return limits;
}

/// Memory ends before time does, even where a new page of memory takes long.
cage::Limits little_memory() {
  cage::Limits limits = usual();
  limits.processor = 60;
  limits.wall = 180;
  limits.memory = 1'000'000'000;
  return limits;
}

Compiled compile(const std::string& text, Sandbox sandbox = Sandbox::bubblewrap,
                 const cage::Limits& limits = usual()) {
  return grade::compile(text, "drift.h", asks, sandbox, kit(), limits);
}

/// No name of ours may be in what a student reads.
void names_nothing_of_ours(const std::string& message) {
  for (const char* ours :
       {"harness.h", "call.h", "glue", "/job", "harness/", "exercise/", "/tmp", "driver", "gch"})
    CHECK_THAT(message, !ContainsSubstring(ours));
  CHECK_THAT(message, !ContainsSubstring(kit_folder()));
}

struct Case {
  std::string text;
  Verdict verdict;
  std::vector<std::string> says;
};

void check(const Case& next, const cage::Limits& limits = usual()) {
  INFO(next.text);
  const Compiled compiled = compile(next.text, Sandbox::bubblewrap, limits);
  REQUIRE(compiled.failed);
  CHECK(name(*compiled.failed) == name(next.verdict));
  for (const std::string& part : next.says) CHECK_THAT(compiled.message, ContainsSubstring(part));
  names_nothing_of_ours(compiled.message);
  CHECK_FALSE(compiled.driver);
}

}  // namespace

TEST_CASE("A header that compiles becomes a driver, in the cage and without") {
  for (const Sandbox sandbox : {Sandbox::bubblewrap, Sandbox::none}) {
    const Compiled compiled = compile(good, sandbox);
    INFO(compiled.message);
    REQUIRE_FALSE(compiled.failed);
    CHECK(compiled.message.empty());
    cage::Process driver = cage::run(sandbox, kit(), compiled.driver, {});
    const double request[] = {0, 3, 1, 2, 3};
    double answer[5] = {};
    REQUIRE(driver.send(std::as_bytes(std::span(request))));
    REQUIRE(driver.receive(std::as_writable_bytes(std::span(answer))));
    CHECK(answer[4] == 6);
    CHECK(driver.finish().code == 0);
  }
}

TEST_CASE("The kit may lie where nobody but its owner gets to, as in root's home") {
  const Folder folder;  // has the mode 0700
  std::filesystem::copy(kit_folder(), folder / "kit", std::filesystem::copy_options::recursive);
  const std::string own = folder / "kit";
  cage::Kit closed = kit();
  closed.harness = own + "/harness";
  closed.filters = own;
  closed.canary = own + "/canary";
  closed.limited = own + "/limited";
  CHECK(cage::unsafe(closed) == std::nullopt);
  for (const Sandbox sandbox : {Sandbox::bubblewrap, Sandbox::none}) {
    const Compiled compiled = grade::compile(good, "drift.h", asks, sandbox, closed, usual());
    INFO(compiled.message);
    CHECK_FALSE(compiled.failed);
  }
}

TEST_CASE("Compiling without the sandbox leaves no folder behind") {
  // Of its own, since other tests compile beside this one.
  const Folder own;
  std::filesystem::permissions(own.path(), std::filesystem::perms::all);
  const std::string before_us = std::filesystem::temp_directory_path().string();
  ::setenv("TMPDIR", own.path().c_str(), 1);
  const auto folders = [] {
    int count = 0;
    for (const auto& next :
         std::filesystem::directory_iterator(std::filesystem::temp_directory_path()))
      count += next.path().filename().string().starts_with("compile-");
    return count;
  };
  const int before = folders();
  compile(good, Sandbox::none);
  compile("#error\n", Sandbox::none);
  CHECK(folders() == before);
  ::setenv("TMPDIR", before_us.c_str(), 1);
}

TEST_CASE("The precompiled header is used, and not its text") {
  const Folder folder;
  std::filesystem::copy(kit_folder() + "/harness", folder / "harness",
                        std::filesystem::copy_options::recursive);
  std::ofstream(folder / "harness/given.h") << "#error is read as text\n";
  cage::Kit own = kit();
  own.harness = folder / "harness";
  const auto fails = [&own] {
    return grade::compile(good, "drift.h", asks, Sandbox::none, own, usual()).failed.has_value();
  };
  CHECK_FALSE(fails());
  std::filesystem::remove_all(folder / "harness/given.h.gch");
  CHECK(fails());
}

TEST_CASE("A warning in the student's file is handed on, a header is not warned of its #pragma") {
  const Compiled compiled = compile(
      "#pragma once\n#include \"given.h\"\n"
      "inline void step(Vec& x) { int unused; x = 2 * x; }\n");
  REQUIRE_FALSE(compiled.failed);
  CHECK_THAT(compiled.message, ContainsSubstring("drift.h:3:32: warning: unused variable"));
  names_nothing_of_ours(compiled.message);
}

TEST_CASE("Errors name the student's file and line") {
  check({"// first\ninline void step(Vec& x) { x = 2 * x }\n",
         Verdict::compile_error,
         {"drift.h:2:37: error: expected ';'", "    2 | inline void"}});
  check({"inline void step(Vec& x) { x = y; z(); }\n",
         Verdict::compile_error,
         {"drift.h:1:32: error: 'y' was not declared", "drift.h:1:35: error: 'z'"}});
  check({"template <class V>\nvoid step(V& x) { x.none(); }\n",
         Verdict::compile_error,
         {"drift.h:2:21: error: 'struct Vec' has no member named 'none'"}});
  check({"inline void step(Vec& x) { x = x + 1; }\n",
         Verdict::compile_error,
         {"drift.h:1:34: error: no match for 'operator+'", "given.h:"}});
}

TEST_CASE("What follows from the student's own error is left out") {
  CHECK_THAT(compile("#error stop\n").message,
             ContainsSubstring("#error stop") && !ContainsSubstring("step is missing"));
}

TEST_CASE("A function that cannot be called as asked for is shown beside the one that can") {
  check({"inline void step(Vec& x, Vec& v) {}\n",
         Verdict::compile_error,
         {"wanted is void step(Vec&), but found is void step(Vec&, Vec&)"}});
  check({"inline double step(double) { return 0; }\n",
         Verdict::compile_error,
         {"but found is double step(double)"}});
  check({"template <class V> void step(V&, V&) {}\n",
         Verdict::compile_error,
         {"wanted is void step(Vec&)"}});
  grade::Diagnostic error;
  error.text =
      "conversion from 'void(Vec&)' to non-scalar type 'const harness::Wanted<void(Vec&, "
      "const std::function<Vec(const Vec&, const Vec&, double)>&)>' requested";
  error.excerpt = {
      "    6 |   const harness::Wanted<void(Vec&, const Acceleration&)> wanted = step;"};
  CHECK(grade::wanted_and_found(error) ==
        "wanted is void step(Vec&, const Acceleration&), but found is void step(Vec&)");
  check({"// nothing\n", Verdict::compile_error, {"step is missing: the header has to define it"}});
  check({"namespace mine { inline void step(Vec&) {} }\n",
         Verdict::compile_error,
         {"step is missing", "did you mean 'mine::step'"}});
}

TEST_CASE("Another form that can be called as asked for is called, with a warning") {
  for (const char* text :
       {"inline void step(Vec x) {}\n", "inline double step(const Vec&) { return 0; }\n",
        "inline constexpr auto step = [](Vec& x) { x = 2 * x; };\n",
        "inline const std::function<void(Vec&)> step = [](Vec& x) { x = 2 * x; };\n"}) {
    const Compiled compiled = compile(text);
    INFO(text << compiled.message);
    CHECK(!compiled.failed);
    CHECK_THAT(compiled.message, ContainsSubstring("step is declared in another way"));
  }
  CHECK_THAT(compile("template <class V> void step(V& x) { x = 2 * x; }\n").message,
             !ContainsSubstring("another way"));
}

TEST_CASE("A main is refused, whatever its kind") {
  for (const char* kind :
       {"int main() {}\n", "inline int main() {}\n", "__attribute__((weak)) int main() {}\n",
        "static int main() {}\n", "asm(\".globl main\\nmain: ret\");\n"})
    check({kind + good, Verdict::rejected, {"remove main()", "#ifndef GRADING"}});
  CHECK_FALSE(compile("#ifndef GRADING\nint main() {}\n#endif\n" + good).failed);
}

TEST_CASE("What lacks inline works, and is told why a header needs it") {
  for (const auto& [text, name] :
       {std::pair{std::string("void step(Vec& x) { x = 2 * x; }\n"), "step"},
        std::pair{"double gravity = 9.81;\n" + good, "gravity"}}) {
    const Compiled compiled = compile(text);
    CHECK_FALSE(compiled.failed);
    CHECK_THAT(compiled.message, ContainsSubstring(name + std::string(" lacks the word inline")) &&
                                     ContainsSubstring("two files of one program"));
  }
  CHECK(compile(good).message.empty());
}

TEST_CASE("A function of C that the library has is refused") {
  check(
      {"#include <cstdio>\nextern \"C\" long write(int, const void*, unsigned long) "
       "{ return 0; }\n" +
           good,
       Verdict::link_error,
       {"write is a function of C"}});
}

TEST_CASE("What is declared and not defined is named") {
  check({"void helper(int);\ninline void step(Vec& x) { helper(1); }\n",
         Verdict::link_error,
         {"helper(int) is declared, but never defined"}});
}

TEST_CASE("A compiler without end is stopped") {
  check({"#include __FILE__\n#include __FILE__\n", Verdict::compile_limit, {"depth of #include"}});
  check(
      {"constexpr long f() { long s = 0; for (long i = 0; i >= 0; ++i) ++s; return s; }\n"
       "constexpr long n = f();\n",
       Verdict::compile_limit,
       {"computation at compile time"}});
  check({"template <int n> struct A : A<n + 1> {};\nA<0> a;\n",
         Verdict::compile_limit,
         {"depth of templates"}});
  check({"inline int big[1 << 28] = {1};\ninline void step(Vec& x) { x.x = big[0]; }\n",
         Verdict::compile_limit,
         {"room for its output"}});
  check({"#define A x x x x x x x x x x\n#define B A A A A A A A A A A\n"
         "#define C B B B B B B B B B B\n#define D C C C C C C C C C C\n"
         "#define E D D D D D D D D D D\n#define F E E E E E E E E E E\n"
         "#define G F F F F F F F F F F\n#define H G G G G G G G G G G\nH H H H H H H H H H\n",
         Verdict::compile_limit,
         {"ran out of memory"}},
        little_memory());
}

TEST_CASE("Whatever stops the assembler is said") {
  check({"asm(\".macro m a\\n m \\\\a+1\\n m \\\\a+2\\n.endm\\n m 0\");\n" + good,
         Verdict::compile_limit,
         {"depth of assembler macros"}});
  check({"asm(\".rept 100000000\\n.quad 1\\n.endr\");\n" + good,
         Verdict::compile_limit,
         {"ran out of memory"}},
        little_memory());
  const auto all = grade::diagnostics(
      "{standard input}:5: Fatal error: one\n{standard input}: Internal error: two\n"
      "a.h:1:2: internal compiler error: three\na.h:1:2: sorry, unimplemented: four\n");
  REQUIRE(all.size() == 4);
  CHECK_THAT(grade::errors(all, "a.h"),
             ContainsSubstring("fatal error: one") && ContainsSubstring("internal error: two") &&
                 ContainsSubstring("three") && ContainsSubstring("four"));
}

// What stands in such a section is compiled by the linker, with options that stand there as well.
TEST_CASE("Bytecode for the linker is refused") {
  for (const char* section : {".gnu.lto_.opts", ".gnu.lto_main.1", ".llvmbc"})
    check({std::string("asm(\".pushsection ") + section +
               R"(,\"e\",@progbits\n.string \"'-fno-pie'\"\n.popsection");)" + "\n" + good,
           Verdict::rejected,
           {"bytecode", "write it in C++"}});
}

TEST_CASE("The kit and the grader name no folder of whoever built them") {
  std::vector<std::filesystem::path> files;
  for (const auto& next : std::filesystem::recursive_directory_iterator(kit_folder()))
    if (next.is_regular_file()) files.push_back(next.path());
#ifdef GRADE  // which another user may not be able to read
  if (::access(GRADE, R_OK) == 0) files.emplace_back(GRADE);
#endif
  REQUIRE(files.size() > 10);
  for (const auto& file : files) {
    INFO(file);
    std::ifstream stream(file, std::ios::binary);
    const std::string content{std::istreambuf_iterator<char>(stream), {}};
    REQUIRE(!content.empty());
    for (const char* folder : {SOURCE_FOLDER "/", BUILD_FOLDER "/"})
      CHECK(content.find(folder) == content.npos);
  }
}

TEST_CASE("A compiler that takes too long is stopped") {
  cage::Limits limits = usual();
  limits.processor = 1;
  const std::string slow =
      "template <unsigned long a, int b> constexpr unsigned long g() { if constexpr (b == 0) "
      "return a; else return g<2 * a, b - 1>() + g<2 * a + 1, b - 1>(); }\n"
      "constexpr unsigned long n = g<1, 22>();\n";
  const Compiled compiled = compile(slow, Sandbox::bubblewrap, limits);
  REQUIRE(compiled.failed);
  CHECK(name(*compiled.failed) == "COMPILE_LIMIT");
  CHECK(compiled.processor < 3);
}

TEST_CASE("Messages are cut, and control characters in them are not passed on") {
  std::string text = "inline void step(Vec& x) { x = y; } // \x1b[31m red \xe2\x80\xae turned\n";
  const Compiled compiled = compile(text);
  CHECK_THAT(compiled.message, ContainsSubstring("\\x1b[31m red \\u{202e} turned"));
  text = "inline void step(Vec& x) { x = " + std::string(30000, 'y') + "; }\n";
  CHECK(compile(text).message.size() < 5000);
}

TEST_CASE("The cage shows nothing of the machine but its compiler") {
  for (const char* path :
       {"/etc/passwd", "/proc/self/status", "/dev/null", "/tmp", "/root", "/home", "/var"}) {
    const std::string text =
        std::string("#if __has_include(\"") + path + "\")\n#error it is there\n#endif\n" + good;
    CHECK_FALSE(compile(text).failed);
  }
  check({"#include \"/etc/passwd\"\n", Verdict::compile_error, {"No such file"}});
  check({"asm(\".incbin \\\"/etc/passwd\\\"\");\n" + good, Verdict::compile_error, {}});
  check({"#include \"../solution.h\"\n", Verdict::compile_error, {"No such file"}});
  check({"#include \"/usr/lib/os-release\"\n",
         Verdict::compile_error,
         {"includes a file that is no header"}});
  check({"#line 1 \"/etc/shadow\"\n#error no\n",
         Verdict::compile_error,
         {"names it by #line: /etc/shadow"}});
}

TEST_CASE("Known mistakes get a hint") {
  check({"#include <windows.h>\n", Verdict::compile_error, {"exists only on Windows"}});
  check({"#include \"stdafx.h\"\n", Verdict::compile_error, {"exists only on Windows"}});
  const std::string says = "inline void step(Vec& x) { std::println(\"{}\", x.x); }\n";
  check({"#include <print>\n" + says, Verdict::compile_error, {"C++23", "compiled as C++20"}});
}

// As g++ 14 has <print>, g++ 12 has <expected>: there, and empty before C++23.
TEST_CASE("A header of the next standard that is there gets the same hint") {
  const std::string uses =
      "inline void step(Vec& x) { x.x = std::expected<double, int>(1).value(); }\n";
  check({"#if !__has_include(<expected>)\n#error it is not there\n#endif\n#include <expected>\n" +
             uses,
         Verdict::compile_error,
         {"'expected' is not a member of 'std'", "C++23", "compiled as C++20"}});
}

namespace {

/// g++, whose part that compiles lies elsewhere: in `parts`, and leaves a trace.
cage::Kit scattered(const Folder& folder) {
  cage::Kit kit = ::kit();
  const auto script = [&](const std::string& name, const std::string& text) {
    const std::string path = folder.write(name, "#!/bin/sh\n" + text);
    std::filesystem::permissions(path, std::filesystem::perms(0755));
    return path;
  };
  const std::string parts = folder / "parts/";
  kit.compiler = script("bin/g++", "exec " + kit.compiler + " -B" + parts + " \"$@\"\n");
  script("parts/cc1plus", "exec " CC1PLUS " -DFROM_ELSEWHERE \"$@\"\n");
  std::filesystem::permissions(folder.path(), std::filesystem::perms(0755));
  return kit;
}

}  // namespace

TEST_CASE("A compiler whose parts lie elsewhere finds them in the cage") {
  const Folder folder;
  cage::Kit kit = scattered(folder);
  const std::string text = "#ifndef FROM_ELSEWHERE\n#error another cc1plus\n#endif\n" + good;
  kit.shown = grade::folders_of(kit.compiler);
  const Compiled whole = grade::compile(text, "drift.h", asks, Sandbox::bubblewrap, kit, usual());
  INFO(whole.message);
  CHECK_FALSE(whole.failed);

  std::erase(kit.shown, (folder / "parts").string());
  const Compiled lacking = grade::compile(text, "drift.h", asks, Sandbox::bubblewrap, kit, usual());
  REQUIRE(lacking.failed);
  CHECK_THAT(lacking.message, ContainsSubstring("another cc1plus"));
}

TEST_CASE("A kit that is not whole is our own error") {
  cage::Kit broken = kit();
  broken.harness = "/no/such/folder";
  const Compiled compiled =
      grade::compile(good, "drift.h", asks, Sandbox::bubblewrap, broken, usual());
  REQUIRE(compiled.failed);
  CHECK(name(*compiled.failed) == "GRADER_ERROR");
}
