// SPDX-License-Identifier: MIT-0
#include <fcntl.h>
#include <unistd.h>

#include <filesystem>

#include "cage.h"

namespace cage {

namespace {

/// Bubblewrap's words for a failure, and what helps.
struct Trouble {
  const char *said, *help;
};

constexpr const char* profile =
    "AppArmor lets bubblewrap make no user namespace; exercises/grader/bwrap.apparmor is a profile "
    "that allows it, and says how to load it";

constexpr Trouble troubles[] = {
    {"failed to execute bwrap", "bubblewrap is not installed: apt-get install bubblewrap"},
    {"setting up uid map: Permission denied", profile},
    {"Failed RTM_NEWADDR: Operation not permitted", profile},
    {"uid map: Read-only",
     "this is a container with a /proc that cannot be written to; start it with --privileged, or "
     "grade outside of it"},
    {"amespace",
     "user namespaces are turned off here; as root: sysctl -w user.max_user_namespaces=15000 "
     "kernel.unprivileged_userns_clone=1, or for a container: --security-opt seccomp=unconfined "
     "--security-opt apparmor=unconfined --security-opt systempaths=unconfined"}};

std::string first_line(const std::string& text) {
  return text.substr(0, text.find('\n'));
}

std::string not_started(const Ended& ended) {
  const std::string own =
      ". Your own code you may grade without the sandbox, on your own machine: --sandbox none";
  for (const Trouble& trouble : troubles)
    if (ended.err.find(trouble.said) != std::string::npos)
      return "the sandbox cannot start (" + first_line(ended.err) + "): " + trouble.help + own;
  return "the sandbox cannot start: " + first_line(ended.err) + own;
}

std::string not_whole(const std::string& lacks) {
  return "the grader is not whole: " + lacks +
         " cannot be read. Unpack its archive again, or build it again: cmake --workflow --preset "
         "grader";
}

}  // namespace

std::optional<std::string> unsafe(const Kit& kit) {
  const File canary(::open(kit.canary.c_str(), O_RDONLY | O_CLOEXEC));
  const std::string object = std::filesystem::absolute(kit.harness) / "harness.o";
  if (!canary) return not_whole(kit.canary);
  for (const std::string& needed : {object, kit.limited})
    if (::access(needed.c_str(), R_OK) != 0) return not_whole(needed);

  Process process = run(Sandbox::bubblewrap, kit, canary, {});
  const std::string answer = process.receive_all(256);
  const Ended ended = process.finish();
  if (ended.how == Ended::How::never_started) return not_started(ended);
  if (answer == "READY" && ended.how == Ended::How::exited && ended.code == 0) return std::nullopt;
  return "the sandbox does not hold: its canary says \"" + answer +
         "\" where READY is safe; do not grade on this machine";
}

}  // namespace cage
