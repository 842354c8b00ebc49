// SPDX-License-Identifier: MIT-0
#include <fcntl.h>
#include <signal.h>
#include <sys/wait.h>

#include <algorithm>
#include <catch2/catch_test_macros.hpp>
#include <cmath>
#include <span>

#include "around.h"
#include "cage/command.h"
#include "cage/process_tree.h"

using How = cage::Ended::How;
using cage::Ended;
using cage::Process;

namespace {

Ended end_of(const std::string& script, double seconds = 10) {
  return Process(shell(script), {}, within(seconds)).finish();
}

std::vector<std::string> leashed(const std::string& script, const cage::Limits& limits) {
  std::vector<std::string> command = cage::limits_prefix(cage::Sandbox::none, limits, 64);
  for (const std::string& word : shell(script)) command.push_back(word);
  return command;
}

}  // namespace

TEST_CASE("What a program is sent comes back as it answers") {
  Process process(shell("cat >&3"), {}, within(10));
  const double sent[] = {1, -0.0, 3e300};
  double got[3] = {};
  REQUIRE(process.send(std::as_bytes(std::span(sent))));
  REQUIRE(process.receive(std::as_writable_bytes(std::span(got))));
  CHECK(got[2] == 3e300);
  CHECK(std::signbit(got[1]));
  const Ended ended = process.finish();
  CHECK(ended.how == How::exited);
  CHECK(ended.code == 0);
  CHECK(ended.unread == 0);
}

TEST_CASE("A megabyte goes there and back while nobody waits for the other") {
  Process process(shell("cat >&3"), {}, within(20));
  std::string all(1 << 20, 'x'), back(all.size(), ' ');
  // The program can hold only what fits into its pipes, so that both ends have to move.
  for (std::size_t at = 0; at < all.size(); at += 65536) {
    REQUIRE(process.send(std::as_bytes(std::span(all).subspan(at, 65536))));
    REQUIRE(process.receive(std::as_writable_bytes(std::span(back).subspan(at, 65536))));
  }
  CHECK(back == all);
}

TEST_CASE("A program ends with its exit code") {
  CHECK(end_of("exit 7").how == How::exited);
  CHECK(end_of("exit 7").code == 7);
}

TEST_CASE("A program ends by a signal") {
  const Ended ended = end_of("kill -SEGV $$");
  CHECK(ended.how == How::signalled);
  CHECK(ended.code == SIGSEGV);
}

TEST_CASE("A program that sleeps is killed at its time on the clock") {
  const Ended ended = end_of("trap '' TERM HUP INT; sleep 1000; sleep 1000", 0.3);
  CHECK(ended.how == How::wall_limit);
  CHECK(ended.wall >= 0.3);
  CHECK(ended.wall < 3);
}

TEST_CASE("A program that computes is ended at its processor time, even if it ignores the signal") {
  cage::Limits limits = within(30);
  limits.processor = 1;
  for (const char* trap : {"", "trap '' XCPU; "}) {
    const Ended ended =
        Process(leashed(std::string(trap) + "while :; do :; done", limits), {}, limits).finish();
    CHECK(ended.how == How::processor_limit);
    CHECK(ended.processor > 0.5);
    CHECK(ended.processor < 3);
  }
}

TEST_CASE("A program that prints without end is killed, and its first and last words are kept") {
  const Ended ended = end_of("yes; yes >&2");
  CHECK(ended.how == How::output_limit);
  CHECK(ended.out.size() == 2 * 16384 + 7);
}

TEST_CASE("Of a long text its start and its end are kept") {
  const Ended ended = end_of("echo first; head -c 100000 /dev/zero | tr '\\0' x; echo; echo last");
  CHECK(ended.out.starts_with("first\nxxx"));
  CHECK(ended.out.find("x\n[...]\nx") != std::string::npos);
  CHECK(ended.out.ends_with("xxx\nlast\n"));
}

TEST_CASE("A program that answers without end is killed, whether asked or not") {
  CHECK(end_of("yes >&3").how == How::output_limit);
  Process process(shell("yes >&3"), {}, within(10));
  CHECK(process.receive_all(1000).size() == 1000);
  CHECK(process.finish().how == How::output_limit);
}

TEST_CASE("A program that answers instead of reading meets the deadline, and not our memory") {
  Process process(shell("yes >&3"), {}, within(0.5));
  const std::string much(1 << 20, 'x');
  CHECK_FALSE(process.send(std::as_bytes(std::span(much))));
  const Ended ended = process.finish();
  CHECK(ended.how == How::wall_limit);
  CHECK(ended.unread < (3 << 20));
}

TEST_CASE("A program that never reads meets the deadline") {
  Process process(shell("sleep 1000"), {}, within(0.3));
  const std::string much(1 << 20, 'x');
  CHECK_FALSE(process.send(std::as_bytes(std::span(much))));
  CHECK(process.finish().how == How::wall_limit);
}

TEST_CASE("A program that closes all it was given is not waited for") {
  const Clock clock;
  Process process(shell("exec 0<&- 1>&- 2>&- 3>&-; sleep 1000"), {}, within(0.5));
  double number = 0;
  CHECK_FALSE(process.receive(std::as_writable_bytes(std::span(&number, 1))));
  CHECK(process.finish().how == How::wall_limit);
  CHECK(clock.seconds() < 5);
}

TEST_CASE("Bytes that nobody asked for are counted") {
  CHECK(end_of("printf 12345 >&3").unread == 5);
}

TEST_CASE("What a program leaves behind dies with it") {
  const std::string script[] = {
      "sleep MARK & exit 0",
      "setsid sh -c 'trap \"\" TERM; setsid sleep MARK & setsid sleep MARK' & exit 0",
      "(setsid setsid sh -c 'sleep MARK & exec sleep MARK' &) ; sleep 0.2"};
  for (std::string text : script) {
    const std::string name = mark();
    for (auto at = text.find("MARK"); at != text.npos; at = text.find("MARK"))
      text.replace(at, 4, name);
    const Clock clock;
    const Ended ended = end_of(text);
    CHECK(ended.how == How::exited);
    CHECK(clock.seconds() < 5);
    CHECK_FALSE(running(name));
    CHECK(cage::children().empty());
  }
}

TEST_CASE("A program dies with its object") {
  const std::string name = mark();
  {
    Process process(shell("printf 1 >&3; sleep " + name + "; true"), {}, within(100));
    std::byte started;
    REQUIRE(process.receive({&started, 1}));
    CHECK(running(name));
  }
  CHECK_FALSE(running(name));
}

TEST_CASE("Our other children live on") {
  const pid_t other = ::fork();
  if (other == 0) {
    ::pause();
    ::_exit(0);
  }
  end_of("sleep 0");
  CHECK(::waitpid(other, nullptr, WNOHANG) == 0);
  ::kill(other, SIGKILL);
  CHECK(::waitpid(other, nullptr, 0) == other);
}

TEST_CASE("A program inherits no descriptor, no ignored signal and no environment") {
  const cage::File low(::open("/dev/null", O_RDONLY)), middle(::fcntl(low.get(), F_DUPFD, 6)),
      high(::fcntl(low.get(), F_DUPFD, 77));
  ::setenv("SECRET", "42", 1);
  ::signal(SIGTERM, SIG_IGN);
  const Ended ended = end_of(
      "for n in $(seq 0 99); do [ -e /proc/$$/fd/$n ] && echo open $n; done; env; kill -TERM $$");
  ::signal(SIGTERM, SIG_DFL);
  CHECK(ended.out.starts_with("open 0\nopen 1\nopen 2\nopen 3\n"));
  CHECK(ended.out.find("open", 4 * 7) == std::string::npos);
  CHECK(ended.out.find("SECRET") == std::string::npos);
  CHECK(ended.how == How::signalled);
}

TEST_CASE("A program that cannot be started says why") {
  const Ended missing = Process({"/no/such/program"}, {}, within(10)).finish();
  CHECK(missing.how == How::never_started);
  CHECK(missing.err == "cannot start /no/such/program: No such file or directory");
  const Ended sandbox =
      Process({"bwrap", "--json-status-fd", "4", "/no/such/program"}, {}, within(10)).finish();
  CHECK(sandbox.how == How::never_started);
}

TEST_CASE("bubblewrap's codes are the program's own") {
  const auto in_bubblewrap = [](const std::string& script) {
    return Process({"bwrap", "--ro-bind", "/", "/", "--json-status-fd", "4", "--", "/bin/sh", "-c",
                    script},
                   {}, within(10))
        .finish();
  };
  CHECK(in_bubblewrap("exit 1").how == How::exited);
  CHECK(in_bubblewrap("exit 1").code == 1);
  CHECK(in_bubblewrap("kill -SEGV $$").how == How::signalled);
  CHECK(in_bubblewrap("kill -SEGV $$").code == SIGSEGV);
}
