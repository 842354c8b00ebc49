// SPDX-License-Identifier: MIT-0
// alone COMMAND...: runs a command and ends with its exit code, or with 99 if a process that it
// started is still there.
#include <sys/wait.h>
#include <unistd.h>

#include <cstdio>

#include "cage/process_tree.h"

int main(int count, char** arguments) {
  if (count < 2) return 2;
  cage::become_subreaper();
  const pid_t program = ::fork();
  if (program == 0) {
    ::execvp(arguments[1], arguments + 1);
    std::perror(arguments[1]);
    ::_exit(2);
  }
  int status = 0;
  ::waitpid(program, &status, 0);
  const bool left = !cage::children().empty();
  while (!cage::children().empty()) cage::kill_and_reap(cage::children().front(), {});
  return left ? 99 : WIFEXITED(status) ? WEXITSTATUS(status) : 98;
}
