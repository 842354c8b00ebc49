// SPDX-License-Identifier: MIT-0
// For the module alone: what the C++ library calls when memory runs out or something breaks. Its
// own versions print to a terminal, which a page has not got; with these the module needs nothing
// from outside. And two logarithms without the tables of the C library's, a tenth of what a page
// would have to load: nothing here rests on their last bit, which is no machine's promise anyway.
#include <cmath>
#include <cstdlib>
#include <new>

void* operator new(std::size_t size) {
  if (void* memory = std::malloc(size ? size : 1)) return memory;
  __builtin_trap();
}
void* operator new[](std::size_t size) {
  return ::operator new(size);
}
void operator delete(void* memory) noexcept {
  std::free(memory);
}
void operator delete[](void* memory) noexcept {
  std::free(memory);
}
void operator delete(void* memory, std::size_t) noexcept {
  std::free(memory);
}
void operator delete[](void* memory, std::size_t) noexcept {
  std::free(memory);
}

_LIBCPP_BEGIN_NAMESPACE_STD
[[noreturn]] void __libcpp_verbose_abort(const char*, ...) {
  __builtin_trap();
}
_LIBCPP_END_NAMESPACE_STD

extern "C" void __cxa_pure_virtual() {
  __builtin_trap();
}
extern "C" _Noreturn void abort() {
  __builtin_trap();
}

namespace {

double natural_log(double x) {
  int power;
  const double part = std::frexp(x, &power);
  return power * 0.6931471805599453 + std::log1p(part - 1);
}

}  // namespace

extern "C" double log2(double x) {
  return natural_log(x) / 0.6931471805599453;
}
// For x above zero; elsewhere it stops the figure.
extern "C" double pow(double x, double y) {
  if (!(x > 0)) __builtin_trap();
  return std::exp(y * natural_log(x));
}
