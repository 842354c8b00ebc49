// SPDX-License-Identifier: MIT-0
// Trusted, and run in the run cage before a submission is: answers READY only if all that should be
// refused is refused, else LEAK and what was not.
#include <fcntl.h>
#include <sched.h>
#include <signal.h>
#include <sys/mman.h>
#include <sys/ptrace.h>
#include <sys/socket.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <cstddef>
#include <string>

namespace {

volatile sig_atomic_t trapped = 0;

void on_refusal(int) {
  trapped = 1;
}

template <class... Arguments>
bool refused(long call, Arguments... arguments) {
  trapped = 0;
  const long result = syscall(call, arguments...);
  return trapped != 0 || result < 0;
}

// With these flags clone is a fork; a child that comes of it ends at once.
bool fork_refused() {
  trapped = 0;
  const long child = syscall(SYS_clone, SIGCHLD, 0, 0, 0, 0);
  if (child == 0 && trapped == 0) _exit(0);
  return trapped != 0 || child < 0;
}

bool nothing_open_beyond(int descriptor) {
  for (int next = descriptor + 1; next < 1024; ++next)
    if (write(next, "", 0) == 0 || lseek(next, 0, SEEK_CUR) >= 0) return false;
  return true;
}

// Far more than any driver may have.
bool memory_limited() {
  constexpr std::size_t wanted = std::size_t{1} << 36;
  return mmap(nullptr, wanted, PROT_NONE, MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0) ==
         MAP_FAILED;
}

}  // namespace

int main() {
  signal(SIGSYS, on_refusal);
  std::string leaks;
  const auto want = [&](bool held, const char* what) {
    if (!held) leaks += std::string(" ") + what;
  };
  want(refused(SYS_openat, AT_FDCWD, "/", O_RDONLY), "open");
  want(refused(SYS_socket, AF_INET, SOCK_STREAM, 0), "socket");
  want(refused(SYS_ptrace, PTRACE_SEIZE, 1, 0, 0), "ptrace");  // does not stop it
  want(refused(SYS_unshare, CLONE_NEWUSER), "unshare");
  want(refused(SYS_kill, 1, 0), "kill");
  want(refused(SYS_prlimit64, 0, 0, 0, 0), "prlimit");
  want(fork_refused(), "fork");
  want(nothing_open_beyond(3), "descriptor");
  want(memory_limited(), "memory");
  want(getuid() != 0, "root");
  want(getpid() < 10, "processes");
  const std::string answer = leaks.empty() ? "READY" : "LEAK" + leaks;
  return write(3, answer.data(), answer.size()) < 0;
}
