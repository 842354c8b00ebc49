// SPDX-License-Identifier: MIT-0
#include <fcntl.h>

#include <algorithm>
#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>
#include <functional>

#include "around.h"
#include "cage/command.h"

using cage::File;
using cage::Words;
using Catch::Matchers::ContainsSubstring;

namespace {

File part(const std::string& name) {
  return File(::open((kit_folder() + "/" + name).c_str(), O_RDONLY | O_CLOEXEC));
}

/// What the canary says in the run cage after a change to its command line, and with more open.
std::string canary(const std::function<void(Words&)>& change,
                   const std::vector<std::pair<int, int>>& more = {}) {
  const File program = part("canary"), filter = part("run.bpf");
  Words command = cage::run_command(cage::Sandbox::bubblewrap, {});
  change(command);
  std::vector<std::pair<int, int>> files = {{program.get(), 8}, {filter.get(), 9}};
  files.insert(files.end(), more.begin(), more.end());
  cage::Process process(command, files, within(10));
  return process.receive_all(1000);
}

void remove(Words& command, const std::string& word, int following) {
  const auto at = std::ranges::find(command, word);
  REQUIRE(at != command.end());
  command.erase(at, at + 1 + following);
}

std::string said_under(const Words& wrapper) {
  Words command = wrapper;
  command.push_back(beside("say_unsafe"));
  command.push_back(kit_folder());
  return cage::Process(command, {}, within(20)).finish().out;
}

}  // namespace

TEST_CASE("The cage holds here") {
  CHECK(cage::unsafe(kit()) == std::nullopt);
}

TEST_CASE("The canary is ready only in the whole cage") {
  CHECK(canary([](Words&) {}) == "READY");
}

TEST_CASE("The canary tells when the filter is left off") {
  const std::string said = canary([](Words& command) { remove(command, "--seccomp", 1); });
  for (const char* what : {"LEAK", " open", " fork", " kill", " prlimit", " descriptor"})
    CHECK_THAT(said, ContainsSubstring(what));
}

TEST_CASE("The canary tells when a descriptor is left open") {
  const File secret(::open("/etc/passwd", O_RDONLY | O_CLOEXEC));
  CHECK(canary([](Words&) {}, {{secret.get(), 7}}) == "LEAK descriptor");
}

TEST_CASE("The canary tells when memory is not limited") {
  const std::string said = canary([](Words& command) {
    std::erase_if(command, [](const std::string& word) { return word.starts_with("--as="); });
  });
  CHECK(said == "LEAK memory");
}

TEST_CASE("The canary tells when it sees the processes of the machine") {
  const std::string said = canary(
      [](Words& command) { *std::ranges::find(command, "--unshare-all") = "--unshare-uts"; });
  CHECK(said == "LEAK processes");
}

TEST_CASE("A filter that lets everything through makes the cage unsafe") {
  const Folder folder;
  const char allow_all[] = {0x06, 0, 0, 0, 0, 0, -1, 0x7f};  // BPF_RET, SECCOMP_RET_ALLOW
  folder.write("run.bpf", std::string(allow_all, sizeof allow_all));
  cage::Kit broken = kit();
  broken.filters = folder.path();
  const auto said = cage::unsafe(broken);
  REQUIRE(said);
  CHECK_THAT(*said, ContainsSubstring("does not hold") && ContainsSubstring("LEAK"));
}

TEST_CASE("A kit that is not whole is named") {
  cage::Kit broken = kit();
  broken.canary = "/no/such/canary";
  CHECK_THAT(cage::unsafe(broken).value_or(""), ContainsSubstring("/no/such/canary"));
  broken = kit();
  broken.harness = "/no/such/harness";
  CHECK_THAT(cage::unsafe(broken).value_or(""), ContainsSubstring("/no/such/harness"));
  broken = kit();
  broken.limited = "/no/such/limited";
  CHECK_THAT(cage::unsafe(broken).value_or(""), ContainsSubstring("/no/such/limited"));
}

TEST_CASE("Without user namespaces the grader says how to turn them on") {
  const std::string said =
      said_under({"unshare", "--user", "--map-root-user", "sh", "-c",
                  "echo 0 > /proc/sys/user/max_user_namespaces && exec \"$0\" \"$@\""});
  CHECK_THAT(said, ContainsSubstring("cannot start") &&
                       ContainsSubstring("sysctl -w user.max_user_namespaces"));
}

TEST_CASE("In a container without namespaces the grader says what it needs") {
  const std::string said = said_under({beside("like_docker")});
  CHECK_THAT(said, ContainsSubstring("cannot start") &&
                       ContainsSubstring("--security-opt seccomp=unconfined"));
}
