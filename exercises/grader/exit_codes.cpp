// SPDX-License-Identifier: MIT-0
#include "exit_codes.h"

#include <cerrno>
#include <cstdio>

namespace grade {

int refuse(int code, const std::string& why) {
  std::fprintf(stderr, "grade: %s\n", why.c_str());
  return code;
}

int exit_code(const Report& report, bool by_verdict) {
  if (report.unreadable) return Exit::unreadable;
  if (report.verdict == Verdict::grader_error) {
    return report.try_again ? Exit::try_again : Exit::failed;
  }
  return by_verdict && report.score < report.points ? Exit::below_full_score : Exit::graded;
}

int exit_code(const std::vector<Report>& reports) {
  int code = Exit::graded;
  for (const Report& report : reports) {
    if (report.verdict != Verdict::grader_error) continue;
    if (!report.try_again) return Exit::failed;
    code = Exit::try_again;
  }
  return code;
}

int exit_code(const std::error_code& error) {
  switch (error.value()) {
    case EACCES:
    case EPERM:
    case ENOENT:
    case ENOTDIR:
    case EEXIST:
    case EISDIR:
    case EROFS:
    case ENAMETOOLONG:
      return Exit::bad_input;
    case EAGAIN:
    case EMFILE:
    case ENFILE:
    case ENOMEM:
    case ENOSPC:
    case EDQUOT:
      return Exit::try_again;
    default:
      return Exit::failed;
  }
}

}  // namespace grade
