// Counts the allocations of a piece of work: those of C++ in operator new, those of Eigen in the
// check that Eigen makes before each of them. Include it first, in one file of a program.
#pragma once
namespace {
int allocations = 0;
}
#define EIGEN_RUNTIME_NO_MALLOC
#define eigen_assert(condition) (static_cast<bool>(condition) ? void() : void(++allocations))
#include <gtest/gtest.h>

#include <cstdlib>
#include <new>

#include <Eigen/Core>

// Not inlined: otherwise g++ warns that free() does not match the operator new of the library.
[[gnu::noinline]] void* operator new(std::size_t size) {
  ++allocations;
  if (void* memory = std::malloc(size)) return memory;
  throw std::bad_alloc();
}
[[gnu::noinline]] void operator delete(void* memory) noexcept {
  std::free(memory);
}
[[gnu::noinline]] void operator delete(void* memory, std::size_t) noexcept {
  std::free(memory);
}

namespace {

template <class Work>
int allocations_in(const Work& work) {
  const int before = allocations;
  Eigen::internal::set_is_malloc_allowed(false);
  work();
  Eigen::internal::set_is_malloc_allowed(true);
  return allocations - before;
}

}  // namespace
