// Watches what the test program allocates. Alone in its file: the compiler must not see through these
// functions.

#include <algorithm>
#include <cstdlib>
#include <new>

#include "playhouse/wire/samples.h"

std::size_t playhouse::wire::largest_allocation = 0;

void* operator new(std::size_t size) {
  playhouse::wire::largest_allocation = std::max(playhouse::wire::largest_allocation, size);
  if (void* memory = std::malloc(size == 0 ? 1 : size)) return memory;
  throw std::bad_alloc();
}

void operator delete(void* memory) noexcept {
  std::free(memory);
}
void operator delete(void* memory, std::size_t) noexcept {
  std::free(memory);
}
