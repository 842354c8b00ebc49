// SPDX-License-Identifier: MIT-0
// The harness of a student's code that is a module in a page: what main.cpp is to a driver.
#include <cstddef>
#include <cstdlib>
#include <new>

#include "call.h"

/// Asks the judge: seven numbers go there, and three come back in their place.
extern "C" [[clang::import_module("judge"), clang::import_name("ask")]] void judge_ask(
    double* numbers);

/// Ends the program, which threw.
extern "C" [[noreturn, clang::import_module("judge"), clang::import_name("threw")]] void
judge_threw();

/// Ends the program, for which there is no more memory.
extern "C" [[noreturn, clang::import_module("judge"), clang::import_name("no_memory")]] void
judge_no_memory();

namespace {

std::vector<double> arguments, answered;

}  // namespace

Vec harness::ask(const Vec& x, const Vec& v, double t) {
  double numbers[] = {x.x, x.y, x.z, v.x, v.y, v.z, t};
  judge_ask(numbers);
  return {numbers[0], numbers[1], numbers[2]};
}

extern "C" [[clang::export_name("room")]] double* room(std::size_t count) {
  arguments.assign(count, 0);
  return arguments.data();
}

extern "C" [[clang::export_name("answer_one")]] std::size_t answer_one(int function) {
  harness::Call call(function, arguments);
  answer(call);
  answered = call.answer();
  return answered.size();
}

extern "C" [[clang::export_name("answered")]] const double* answered_numbers() {
  return answered.data();
}

// Without exceptions this is what a throw, and new without memory, come to.
extern "C" void* __cxa_allocate_exception(std::size_t) {
  judge_threw();
}
extern "C" void __cxa_throw(void*, void*, void (*)(void*)) {
  judge_threw();
}
void* operator new(std::size_t size) {
  if (void* memory = std::malloc(size ? size : 1)) return memory;
  judge_no_memory();
}
