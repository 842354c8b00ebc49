// SPDX-License-Identifier: MIT-0
/// @file
/// What AddressSanitizer does before a stack is unwound, for a program that sees no /proc: there it
/// reads where the stack ends, and without that takes an exception for a write out of bounds.
/// For one file of the program.
#ifndef NO_RETURN_H
#define NO_RETURN_H
#include <cstddef>

extern "C" {

/// The end of the stack, by the C library.
extern void* __libc_stack_end;

/// The checker's own, which is null without it.
[[gnu::weak]] void __asan_unpoison_memory_region(const volatile void* begin, std::size_t size);

/// Takes the place of the checker's own: what the stack holds may be written anew.
[[gnu::used, gnu::no_sanitize_address]] void __asan_handle_no_return() {
  const char* const here = static_cast<const char*>(__builtin_frame_address(0));
  if (__asan_unpoison_memory_region)
    __asan_unpoison_memory_region(
        here, static_cast<std::size_t>(static_cast<const char*>(__libc_stack_end) - here));
}

}  // extern "C"
#endif
