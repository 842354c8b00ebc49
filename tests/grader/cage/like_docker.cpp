// SPDX-License-Identifier: MIT-0
// Runs a command as a container of Docker's would by default: without new namespaces and mounts.
#include <sched.h>
#include <seccomp.h>
#include <unistd.h>

#include <cerrno>
#include <initializer_list>

int main(int count, char** arguments) {
  scmp_filter_ctx filter = seccomp_init(SCMP_ACT_ALLOW);
  if (count < 2 || !filter) return 2;
  for (const int call : {SCMP_SYS(unshare), SCMP_SYS(mount), SCMP_SYS(setns), SCMP_SYS(umount2)})
    seccomp_rule_add(filter, SCMP_ACT_ERRNO(EPERM), call, 0);
  seccomp_rule_add(filter, SCMP_ACT_ERRNO(ENOSYS), SCMP_SYS(clone3), 0);
  for (const unsigned flag :
       {unsigned{CLONE_NEWUSER}, unsigned{CLONE_NEWNS}, unsigned{CLONE_NEWPID}}) {
    const scmp_arg_cmp has_flag = {0, SCMP_CMP_MASKED_EQ, flag, flag};
    seccomp_rule_add_array(filter, SCMP_ACT_ERRNO(EPERM), SCMP_SYS(clone), 1, &has_flag);
  }
  if (seccomp_load(filter) != 0) return 2;
  execvp(arguments[1], arguments + 1);
  return 2;
}
