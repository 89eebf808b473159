// Counts every malloc of a program, and its bytes. The linker hands them over: the program is linked with
// -Wl,--wrap=malloc, and operator new, which the C++ library would serve itself, is led there as well.
// To be included once in a program.
#pragma once
#include <cstdlib>
#include <new>

namespace counted {
inline long allocations = 0;
inline long bytes = 0;
}  // namespace counted

extern "C" {
void* __real_malloc(size_t size);
void* __wrap_malloc(size_t size) {
  ++counted::allocations;
  counted::bytes += long(size);
  return __real_malloc(size);
}
}

// Not inlined: g++ would see free() meet the new of the library, and warn.
[[gnu::noinline]] void* operator new(std::size_t size) {
  if (void* memory = std::malloc(size)) return memory;
  throw std::bad_alloc();
}
[[gnu::noinline]] void operator delete(void* memory) noexcept {
  std::free(memory);
}
[[gnu::noinline]] void operator delete(void* memory, std::size_t) noexcept {
  std::free(memory);
}
