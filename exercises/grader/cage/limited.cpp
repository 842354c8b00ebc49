// SPDX-License-Identifier: MIT-0
// `limited COUNT PROGRAM [ARGUMENT...]` becomes the program, beside which no more than so many
// processes and threads can be. Run within a cage, where others' processes do not count; there is
// no prlimit there.
#include <sys/resource.h>
#include <unistd.h>

#include <cstdlib>

int main(int count, char** arguments) {
  if (count < 3) return 2;
  const rlim_t most = std::strtoul(arguments[1], nullptr, 10);
  const rlimit limit = {most, most};
  if (setrlimit(RLIMIT_NPROC, &limit) != 0) return 126;
  execv(arguments[2], arguments + 2);
  return 127;
}
