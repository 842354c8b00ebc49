// SPDX-License-Identifier: MIT-0
#include "page/ending.h"

#include "judge/ending.h"

void page::note_ending(Ending ending) {
  switch (ending) {
    case Ending::trapped:
      return judge::note_trap();
    case Ending::outside:
    case Ending::too_deep:
      return judge::note_crash();
    case Ending::threw:
      return judge::note_exception();
    case Ending::left:
      return judge::note_incomplete();
    case Ending::left_by_error:
      return judge::note_exit_code(1);
    case Ending::printed_too_much:
      return judge::note_too_much("what a page shows");
    case Ending::no_memory:
      return judge::note(grade::Verdict::memory_limit,
                         "Your code wanted more memory than it may have in a page.");
  }
}
