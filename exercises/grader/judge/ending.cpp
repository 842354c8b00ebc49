// SPDX-License-Identifier: MIT-0
#include "judge/ending.h"

#include <algorithm>
#include <csignal>
#include <cstring>
#include <string>

#include "failed_assertion.h"
#include "format_values.h"
#include "judge/session.h"
#include "printable.h"

namespace judge {
namespace {

using grade::Verdict;
using How = cage::Ended::How;

// The driver's own exit codes, see harness/main.cpp.
enum { threw = 75, no_memory = 76, bad_request = 77, forbidden = 78 };

void note(Verdict verdict, const std::string& why, const std::string& printed = "") {
  Session& now = session();
  if (now.stopped()) return;
  now.ended = verdict;
  now.why = why;
  if (!now.tests.empty()) now.why += " It happened in the test \"" + now.tests.back().name + "\".";
  if (!printed.empty()) now.why += "\nIt printed:\n" + grade::printable(printed, 2000);
}

// An end by memory shows as an exception, or as a wild write where malloc gave nothing.
bool was_full(const cage::Ended& ended) {
  return static_cast<double>(ended.peak_kilobytes) * 1024 >
         0.5 * static_cast<double>(session().limits.memory);
}

void note_signal(const cage::Ended& ended) {
  if (ended.code == SIGSYS) {
    note(Verdict::runtime_error, "Your code asked the system for something that is not allowed.");
  } else if (was_full(ended)) {
    note(Verdict::memory_limit, "Your code wanted more memory than the " +
                                    grade::megabytes(session().limits.memory) + " it may have.");
  } else if (ended.code == SIGSEGV) {
    note(Verdict::runtime_error,
         "Your code crashed (segmentation fault): it wrote or read outside of its memory, or "
         "called itself without end.",
         ended.err);
  } else if (ended.code == SIGILL) {
    note(Verdict::runtime_error,
         "Your code was stopped where it did what C++ gives no meaning to, such as an index past "
         "the end of an array, a pointer to nothing, a whole number too large for its type, or a "
         "function that ends without its return.",
         ended.err);
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
bool by_the_harness(const cage::Ended& ended) {
  return ended.err.find("It threw") != ended.err.npos ||
         ended.err.find("It asked") != ended.err.npos;
}

void note_exit(const cage::Ended& ended, Moment moment) {
  if (ended.code != 0 && !by_the_harness(ended)) {
    note(Verdict::runtime_error,
         "Your code ended the program with exit code " + std::to_string(ended.code) + ".",
         ended.err);
  } else if (ended.code == threw) {
    note(Verdict::runtime_error, "Your code threw an exception.", ended.err);
  } else if (ended.code == no_memory && was_full(ended)) {
    note(Verdict::memory_limit, "Your code wanted more memory than the " +
                                    grade::megabytes(session().limits.memory) + " it may have.");
  } else if (ended.code == no_memory) {
    note(Verdict::runtime_error, "Your code asked for memory that there is not: std::bad_alloc.");
  } else if (ended.code == forbidden) {
    note(Verdict::runtime_error,
         "Your code asked the system for something that is not allowed here. " +
             grade::printable(ended.err, 2000));
  } else if (ended.code != 0) {
    note(Verdict::runtime_error,
         "Your code ended the program with exit code " + std::to_string(ended.code) + ".",
         ended.err);
  } else if (moment == within_answer) {
    note(Verdict::incomplete,
         "The program ended before it had answered. Does your code call exit?");
  } else if (ended.unread > 0) {
    note_protocol_error();
  }
}

}  // namespace

std::unique_ptr<cage::Process> start_driver() {
  Session& now = session();
  cage::Limits limits = now.limits;
  limits.wall = std::clamp(now.longest - now.wall, 0.0, limits.wall);
  return std::unique_ptr<cage::Process>(new cage::Process(
      cage::run(now.sandbox, *now.kit, *now.driver, limits, now.build, now.arguments)));
}

void note_protocol_error() {
  note(Verdict::protocol_error,
       "What came back is not an answer. Does your code write to descriptor 3?");
}

void note_other_count(double came, std::size_t wanted) {
  note(Verdict::protocol_error, "There came back " + grade::number(came) + " numbers, and " +
                                    std::to_string(wanted) +
                                    " belong there. Has your code changed the size of something?");
}

void note_ending(const cage::Ended& ended, Moment moment) {
  session().wall += ended.wall;
  session().processor = std::max(session().processor, ended.processor);
  if (!session().stopped()) session().printed += ended.err;
  switch (ended.how) {
    case How::exited:
      return note_exit(ended, moment);
    case How::signalled:
      return note_signal(ended);
    case How::wall_limit:
    case How::processor_limit:
      return note(Verdict::time_limit,
                  "Your code did not come back within " + grade::seconds(session().limits) +
                      ". Is there a loop that never ends, such as one that waits for t == end? Or "
                      "work that grows faster than what it is asked for?");
    case How::output_limit:
      return note(Verdict::output_limit,
                  "Your code printed more than " + grade::megabytes(session().limits.output) + ".");
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
