// Counts the calls of malloc in a program, and their bytes. The program is linked with -Wl,--wrap=malloc,
// and the operator new below calls malloc, too. Include it in one file of a program.
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

// Not inlined: otherwise g++ warns that free() does not match the operator new of the library.
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
