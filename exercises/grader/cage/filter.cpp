// SPDX-License-Identifier: MIT-0
// Writes a filter of system calls, as bubblewrap takes it: `filter run FILE`, `filter check FILE`
// or `filter compile FILE`.
#include <fcntl.h>
#include <sched.h>
#include <seccomp.h>
#include <unistd.h>

#include <cerrno>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <iostream>
#include <sstream>
#include <string>
#include <string_view>

namespace {

[[noreturn]] void fail(const std::string& what, int error) {
  std::cerr << "filter: " << what << ": " << std::strerror(error) << '\n';
  std::exit(1);
}

class Filter {
 public:
  explicit Filter(std::uint32_t otherwise) : context_(seccomp_init(otherwise)) {
    if (!context_) fail("libseccomp", ENOMEM);
    // Calls of another architecture have other numbers, so one of them is never honest.
    check(seccomp_attr_set(context_, SCMP_FLTATR_ACT_BADARCH, SCMP_ACT_KILL_PROCESS), "bad arch");
  }
  ~Filter() { seccomp_release(context_); }
  Filter(const Filter&) = delete;
  Filter& operator=(const Filter&) = delete;

  /// Names stand apart by spaces. One that this architecture or this libseccomp does not know needs
  /// no rule.
  void rule(std::uint32_t action, const char* names) {
    std::istringstream list(names);
    for (std::string name; list >> name;) {
      const int call = seccomp_syscall_resolve_name(name.c_str());
      if (call != __NR_SCMP_ERROR) check(seccomp_rule_add(context_, action, call, 0), name);
    }
  }

  /// A clone with any of these flags is not permitted.
  void no_clone_with(unsigned long flags) {
    for (unsigned long flag = 1; flag <= flags; flag <<= 1) {
      if ((flags & flag) == 0) continue;
      const scmp_arg_cmp has_flag = {0, SCMP_CMP_MASKED_EQ, flag, flag};
      check(seccomp_rule_add_array(context_, SCMP_ACT_ERRNO(EPERM), SCMP_SYS(clone), 1, &has_flag),
            "clone");
    }
  }

  /// A clone is permitted that is a thread and no process.
  void threads() {
    rule(SCMP_ACT_ERRNO(ENOSYS), "clone3");  // its flags lie behind a pointer
    const scmp_arg_cmp is_thread = {0, SCMP_CMP_MASKED_EQ, CLONE_THREAD, CLONE_THREAD};
    check(seccomp_rule_add_array(context_, SCMP_ACT_ALLOW, SCMP_SYS(clone), 1, &is_thread),
          "clone");
  }

  void write(const char* path) {
    const int file = ::open(path, O_CREAT | O_TRUNC | O_WRONLY | O_CLOEXEC, 0644);
    if (file < 0) fail(path, errno);
    check(seccomp_export_bpf(context_, file), path);
    ::close(file);
  }

 private:
  static void check(int result, const std::string& what) {
    if (result < 0) fail(what, -result);
  }

  scmp_filter_ctx context_;
};

/// The calls that a program needs that computes, allocates, prints and ends.
void allow_to_run(Filter& filter) {
  filter.rule(SCMP_ACT_ALLOW,
              "read write readv writev close fstat lseek mmap munmap mremap mprotect brk "
              "madvise rt_sigaction rt_sigprocmask rt_sigreturn sigaltstack exit exit_group "
              "futex getrandom clock_gettime clock_getres gettimeofday time clock_nanosleep "
              "nanosleep restart_syscall sched_yield arch_prctl set_tid_address "
              "set_robust_list rseq getpid gettid getuid geteuid getgid getegid tgkill tkill");
  // bubblewrap's own start of the driver, and its wait for the driver's end. There is nothing else
  // in the cage that could be executed.
  filter.rule(SCMP_ACT_ALLOW, "execve wait4");
}

/// A trapped call reaches the driver's handler, which can name it; blocked or ignored, the kernel
/// kills.
void write_for_running(const char* path) {
  Filter filter(SCMP_ACT_TRAP);
  allow_to_run(filter);
  // Asked by the C library as it starts or prints; it carries on when refused.
  filter.rule(SCMP_ACT_ERRNO(ENOENT), "readlink readlinkat");
  filter.rule(SCMP_ACT_ERRNO(ENOTTY), "ioctl");
  filter.rule(SCMP_ACT_ERRNO(EACCES), "newfstatat");
  // Asked for a locale, too, which there is none of; the C library goes on with its own.
  filter.rule(SCMP_ACT_ERRNO(ENOENT), "open openat");
  filter.rule(SCMP_ACT_ERRNO(EPERM), "prlimit64");
  filter.write(path);
}

/// Beside that, what the checker of memory needs: its libraries and the program's own file, which
/// are all that there is to open; and a thread that watches how much memory is held.
void write_for_checking(const char* path) {
  Filter filter(SCMP_ACT_TRAP);
  allow_to_run(filter);
  filter.rule(SCMP_ACT_ALLOW,
              "open openat pread64 access faccessat newfstatat readlink readlinkat prlimit64 "
              "getrlimit getrusage sched_getaffinity prctl fcntl");
  filter.threads();
  filter.rule(SCMP_ACT_ERRNO(EPERM), "uname");  // it tells which kernel this is; nobody needs it
  filter.rule(SCMP_ACT_ERRNO(ENOTTY), "ioctl");
  filter.write(path);
}

/// A compiler starts programs and opens files; it has no use for these.
void write_for_compiling(const char* path) {
  Filter filter(SCMP_ACT_ALLOW);
  filter.rule(SCMP_ACT_ERRNO(EPERM),
              "ptrace process_vm_readv process_vm_writev kcmp mount umount2 pivot_root "
              "chroot move_mount open_tree fsopen fsconfig fsmount fspick mount_setattr "
              "add_key request_key keyctl bpf perf_event_open userfaultfd io_uring_setup "
              "io_uring_enter io_uring_register kexec_load kexec_file_load init_module "
              "finit_module delete_module reboot swapon swapoff setns unshare "
              "open_by_handle_at name_to_handle_at personality quotactl acct syslog socket "
              "socketpair bind connect listen accept accept4 sendto sendmsg sendmmsg mknod "
              "mknodat memfd_create pidfd_getfd pidfd_send_signal settimeofday clock_settime "
              "adjtimex clock_adjtime fanotify_init lookup_dcookie iopl ioperm modify_ldt "
              "vmsplice set_mempolicy mbind move_pages migrate_pages");
  // The flags of clone3 lie behind a pointer; the C library falls back to clone.
  filter.rule(SCMP_ACT_ERRNO(ENOSYS), "clone3");
  filter.no_clone_with(CLONE_NEWUSER | CLONE_NEWNS | CLONE_NEWPID | CLONE_NEWNET | CLONE_NEWIPC |
                       CLONE_NEWUTS | CLONE_NEWCGROUP);
  filter.write(path);
}

}  // namespace

int main(int count, char** arguments) {
  const std::string_view kind = count == 3 ? arguments[1] : "";
  if (kind == "run") {
    write_for_running(arguments[2]);
  } else if (kind == "check") {
    write_for_checking(arguments[2]);
  } else if (kind == "compile") {
    write_for_compiling(arguments[2]);
  } else {
    std::cerr << "usage: filter run|check|compile FILE\n";
    return 2;
  }
}
