// SPDX-License-Identifier: MIT-0
#include "command.h"

#include <unistd.h>

#include <cmath>
#include <fstream>

namespace cage {

namespace {

void add(Words& words, const Words& more) {
  words.insert(words.end(), more.begin(), more.end());
}

/// Root over all users; not root of a user namespace, who can become nobody else.
bool real_root() {
  if (::geteuid() != 0) return false;
  std::ifstream map("/proc/self/uid_map");
  unsigned long inside = 1, outside = 1, count = 0;
  map >> inside >> outside >> count;
  return inside == 0 && outside == 0 && count == 4294967295UL;
}

const Words bubblewrap = {"bwrap",
                          "--unshare-all",
                          "--unshare-user",
                          "--disable-userns",
                          "--uid",
                          "1000",
                          "--gid",
                          "1000",
                          "--die-with-parent",
                          "--new-session",
                          "--cap-drop",
                          "ALL",
                          "--clearenv",
                          "--hostname",
                          "cage",
                          "--json-status-fd",
                          "4"};

/// The limit for a compiler, and for a program with a checker of memory, which has a thread of its
/// own.
constexpr const char* most_processes = "24";

/// The steps of a compilation, each with its own exit code; $0 is the compiler, behind it stand its
/// flags, and in the environment what differs from build to build. What the object defines
/// strongly, and main, are printed for the grader to look at; the driver goes out on descriptor 3.
/// What the linker would have compiled once more, and nm would have read in place of the object, is
/// not taken.
const std::string compile_script = R"(printf READY >&3
"$0" "$@" -fno-lto -fmax-errors=5 -ftemplate-backtrace-limit=3 \
  -fdiagnostics-color=never -pipe $DEFINED -Iharness \
  -c glue.cpp -o driver.o 3>&- || exit 10
if grep -aqF -e .gnu.lto_ -e .llvmbc driver.o 3>&-; then exit 12; fi
nm -C -g --defined-only driver.o 3>&- |
  grep -aE '^[0-9a-f]+ ([ABCDGRST] |[A-Za-z] main$)' 3>&-
"$0" $LINK -fno-lto -fno-use-linker-plugin driver.o $HARNESS -o driver 3>&- || exit 11
exec cat driver >&3)";

/// The script's variables.
std::vector<std::pair<std::string, std::string>> variables(Build build) {
  const bool own = build == Build::own;
  return {{"LINK", build == Build::scored ? "-static" : "-fsanitize=address,undefined"},
          {"DEFINED", own ? "" : "-DGRADING"},
          {"HARNESS", own ? "" : "harness/harness.o"}};
}

const Words& flags(const Kit& kit, Build build) {
  return build == Build::scored ? kit.flags : kit.checked_flags;
}

void add_system(Words& words, const Kit& kit) {
  for (const std::string& folder : kit.shown) add(words, {"--ro-bind", folder, folder});
  add(words, {"--symlink", "usr/lib", "/lib", "--symlink", "usr/lib64", "/lib64", "--symlink",
              "usr/bin", "/bin"});
}

}  // namespace

std::optional<uid_t> unprivileged() {
  if (!real_root()) return std::nullopt;
  // 60578 to 61183 belong to nobody: not to Debian's packages, nor to systemd.
  return 60578 + static_cast<uid_t>(::getpid()) % 600;
}

Words limits_prefix(Sandbox sandbox, const Limits& limits, int open_files) {
  Words words;
  if (sandbox == Sandbox::trusted) return words;
  if (const auto user = unprivileged()) {
    const std::string id = std::to_string(*user);
    words = {"setpriv", "--reuid", id, "--regid", id, "--clear-groups", "--inh-caps=-all"};
  } else if (sandbox == Sandbox::none) {
    words = {"setpriv"};
  }
  if (sandbox == Sandbox::none) add(words, {"--pdeathsig", "KILL"});
  if (!words.empty()) words.push_back("--");
  // At the soft limit comes SIGXCPU, which can be told from other ends; at the hard one SIGKILL.
  const long soft = std::lround(std::ceil(limits.processor));
  const std::string memory =
      limits.memory == no_limit ? "unlimited" : std::to_string(limits.memory);
  add(words, {"prlimit", "--cpu=" + std::to_string(soft) + ":" + std::to_string(soft + 1),
              "--as=" + memory, "--fsize=" + std::to_string(limits.file),
              "--nofile=" + std::to_string(open_files), "--core=0", "--"});
  return words;
}

Words run_command(Sandbox sandbox, const Limits& limits) {
  Words words = limits_prefix(sandbox, limits, 16);
  if (sandbox != Sandbox::bubblewrap) {
    words.push_back("/proc/self/fd/8");
    return words;
  }
  add(words, bubblewrap);
  add(words, {"--perms", "0555", "--ro-bind-data", "8", "/driver", "--remount-ro", "/", "--chdir",
              "/", "--seccomp", "9", "--", "/driver"});
  return words;
}

Words check_command(Sandbox sandbox, const Kit& kit, const Limits& limits) {
  Limits unlimited = limits;
  unlimited.memory = no_limit;
  Words words = limits_prefix(sandbox, unlimited, 16);
  if (sandbox != Sandbox::bubblewrap) {
    words.push_back("/proc/self/fd/8");
    return words;
  }
  add(words, bubblewrap);
  for (const std::string& library : kit.libraries) add(words, {"--ro-bind", library, library});
  // There the checker asks for the program's name: without it, a report names no lines.
  add(words, {"--symlink", "/driver", "/proc/self/exe"});
  add(words, {"--perms", "0555", "--ro-bind-data", "8", "/driver"});
  add(words, {"--perms", "0555", "--ro-bind-data", "10", "/limited"});
  add(words, {"--remount-ro", "/", "--chdir", "/", "--seccomp", "9", "--"});
  // The count of processes is set inside, where it is this cage's alone. Threads count as well.
  add(words, {"/limited", most_processes, "/driver"});
  return words;
}

Words compile_command(const Kit& kit, const Words& harness, const std::string& header,
                      const Limits& limits, Build build) {
  Words words = limits_prefix(Sandbox::bubblewrap, limits, 64);
  add(words, bubblewrap);
  add(words, {"--setenv", "PATH", "/usr/bin", "--setenv", "LC_ALL", "C", "--setenv", "TMPDIR"});
  words.push_back("/job");
  for (const auto& [name, value] : variables(build)) add(words, {"--setenv", name, value});
  add_system(words, kit);
  add(words, {"--size", "134217728", "--tmpfs", "/job"});
  add(words, harness);
  add(words, {"--perms", "0444", "--ro-bind-data", "6", "/job/glue.cpp"});
  add(words, {"--perms", "0444", "--ro-bind-data", "7", "/job/exercise/harness.h"});
  add(words, {"--perms", "0444", "--ro-bind-data", "8", "/job/" + header});
  // Here, too, the count is set inside.
  add(words, {"--remount-ro", "/", "--chdir", "/job", "--seccomp", "9", "--", "prlimit"});
  words.push_back(std::string("--nproc=") + most_processes);
  add(words, {"--", "/bin/sh", "-c", compile_script, kit.compiler});
  add(words, flags(kit, build));
  return words;
}

Words compile_command(const Kit& kit, const std::string& folder, const Limits& limits,
                      Build build) {
  Words words = limits_prefix(Sandbox::none, limits, 64);
  add(words, {"env", "--chdir", folder, "TMPDIR=" + folder});
  for (const auto& [name, value] : variables(build)) words.push_back(name + "=" + value);
  add(words, {"/bin/sh", "-c", compile_script, kit.compiler});
  add(words, flags(kit, build));
  return words;
}

}  // namespace cage
