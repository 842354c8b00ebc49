// SPDX-License-Identifier: MIT-0
#include "judge/ending.h"

#include "format_values.h"
#include "judge/session.h"
#include "printable.h"

namespace judge {

using grade::Verdict;

void note(Verdict verdict, const std::string& why, const std::string& printed) {
  Session& now = session();
  if (now.stopped()) return;
  now.ended = verdict;
  now.why = why;
  if (!now.tests.empty()) now.why += " It happened in the test \"" + now.tests.back().name + "\".";
  if (!printed.empty()) now.why += "\nIt printed:\n" + grade::printable(printed, 2000);
}

void note_crash(const std::string& printed) {
  note(Verdict::runtime_error,
       "Your code crashed (segmentation fault): it wrote or read outside of its memory, or "
       "called itself without end.",
       printed);
}

void note_trap(const std::string& printed) {
  note(Verdict::runtime_error,
       "Your code was stopped where it did what C++ gives no meaning to, such as an index past "
       "the end of an array, a pointer to nothing, a whole number too large for its type, or a "
       "function that ends without its return.",
       printed);
}

void note_exception(const std::string& printed) {
  note(Verdict::runtime_error, "Your code threw an exception.", printed);
}

void note_exit_code(int code, const std::string& printed) {
  note(Verdict::runtime_error,
       "Your code ended the program with exit code " + std::to_string(code) + ".", printed);
}

void note_incomplete() {
  note(Verdict::incomplete, "The program ended before it had answered. Does your code call exit?");
}

void note_too_long(const std::string& longest) {
  note(Verdict::time_limit,
       "Your code did not come back within " + longest +
           ". Is there a loop that never ends, such as one that waits for t == end? Or "
           "work that grows faster than what it is asked for?");
}

void note_too_much(const std::string& most) {
  note(Verdict::output_limit, "Your code printed more than " + most + ".");
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

}  // namespace judge
