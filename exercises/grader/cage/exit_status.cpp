// SPDX-License-Identifier: MIT-0
#include "exit_status.h"

#include <signal.h>
#include <sys/wait.h>

namespace cage {

namespace {

using How = Ended::How;

/// A shell and bubblewrap report signal n as the code 128 + n.
constexpr int signal_base = 128;

void signalled(Ended& ended, int signal, const Limits& limits) {
  // A program that ignores SIGXCPU is killed a second later. The kernel measures both by its ticks,
  // and reports a smaller time than those when the machine is busy.
  const bool spent = signal == SIGKILL && ended.processor > 0.5 * limits.processor;
  ended.how = spent || signal == SIGXCPU ? How::processor_limit : How::signalled;
  ended.code = signal;
}

}  // namespace

void decode_status(Ended& ended, int status, const Limits& limits, const std::string* status_text) {
  // bubblewrap gives an exit code only for a program that it could start, and nobody but us can
  // signal bubblewrap itself.
  if (status_text &&
      (status_text->find("\"exit-code\"") == std::string::npos || !WIFEXITED(status))) {
    ended.how = How::never_started;
    return;
  }
  if (WIFSIGNALED(status)) return signalled(ended, WTERMSIG(status), limits);
  const int code = WEXITSTATUS(status);
  if (status_text && code > signal_base && code < signal_base + NSIG)
    return signalled(ended, code - signal_base, limits);
  ended.how = How::exited;
  ended.code = code;
}

}  // namespace cage
