// SPDX-License-Identifier: MIT-0
#include "judge/driver_ending.h"

#include <algorithm>
#include <csignal>
#include <cstring>
#include <string>

#include "failed_assertion.h"
#include "format_values.h"
#include "judge/ending.h"
#include "judge/session.h"
#include "printable.h"

namespace judge {
namespace {

using cage::Ended;
using cage::Limits;
using grade::Verdict;
using How = cage::Ended::How;

// The driver's own exit codes, see harness/main.cpp.
enum { threw = 75, no_memory = 76, bad_request = 77, forbidden = 78 };

// An end by memory shows as an exception, or as a wild write where malloc gave nothing.
bool was_full(const Ended& ended, const Limits& limits) {
  return static_cast<double>(ended.peak_kilobytes) * 1024 >
         0.5 * static_cast<double>(limits.memory);
}

void note_full(const Limits& limits) {
  note(Verdict::memory_limit, "Your code wanted more memory than the " +
                                  grade::megabytes(limits.memory) + " it may have.");
}

void note_signal(const Ended& ended, const Limits& limits) {
  if (ended.code == SIGSYS) {
    note(Verdict::runtime_error, "Your code asked the system for something that is not allowed.");
  } else if (was_full(ended, limits)) {
    note_full(limits);
  } else if (ended.code == SIGSEGV) {
    note_crash(ended.err);
  } else if (ended.code == SIGILL) {
    note_trap(ended.err);
  } else if (const std::string rule = grade::failed_assertion(ended.err);
             ended.code == SIGABRT && !rule.empty()) {
    note(Verdict::runtime_error, "Your code was stopped where it " + rule + ".");
  } else {
    note(Verdict::runtime_error, std::string("Your code crashed: ") + strsignal(ended.code) + ".",
         ended.err);
  }
}

// The harness prints a line before it ends the program; code that calls _exit with one of its codes
// has no such line.
bool by_the_harness(const Ended& ended) {
  return ended.err.find("It threw") != ended.err.npos ||
         ended.err.find("It asked") != ended.err.npos;
}

// A code of the harness's own is told in its words.
bool is_told(const Ended& ended, const Limits& limits) {
  if (!by_the_harness(ended)) return false;
  if (ended.code == threw) {
    note_exception(ended.err);
  } else if (ended.code == no_memory && was_full(ended, limits)) {
    note_full(limits);
  } else if (ended.code == no_memory) {
    note(Verdict::runtime_error, "Your code asked for memory that there is not: std::bad_alloc.");
  } else if (ended.code == forbidden) {
    note(Verdict::runtime_error,
         "Your code asked the system for something that is not allowed here. " +
             grade::printable(ended.err, 2000));
  } else {
    return false;
  }
  return true;
}

void note_exit(const Ended& ended, Moment moment, const Limits& limits) {
  if (ended.code != 0) {
    if (!is_told(ended, limits)) note_exit_code(ended.code, ended.err);
  } else if (moment == within_answer) {
    note_incomplete();
  } else if (ended.unread > 0) {
    note_protocol_error();
  }
}

}  // namespace

void note_ending(const Ended& ended, Moment moment, const Limits& limits) {
  session().wall += ended.wall;
  session().processor = std::max(session().processor, ended.processor);
  if (!session().stopped()) session().printed += ended.err;
  switch (ended.how) {
    case How::exited:
      return note_exit(ended, moment, limits);
    case How::signalled:
      return note_signal(ended, limits);
    case How::wall_limit:
    case How::processor_limit:
      return note_too_long(grade::seconds(limits));
    case How::output_limit:
      return note_too_much(grade::megabytes(limits.output));
    case How::never_started:
      // The canary has run there just before, and nothing of the code has run that could say this.
      if (ended.err.find("bwrap: execvp /driver: ") != ended.err.npos)
        return note(Verdict::runtime_error,
                    "The system does not start your program. Does your code define a section of "
                    "its own, such as .interp?");
      return note(Verdict::grader_error, "The cage did not start: " + ended.err);
  }
}

}  // namespace judge
