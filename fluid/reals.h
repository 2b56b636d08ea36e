// Memory for arrays that a step streams through.
#pragma once

#include <sys/mman.h>

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <memory>
#include <new>

namespace swellflow {

struct FreeReals {
  void *memory = nullptr;  ///< what was allocated; the array begins within it
  void operator()(double *) const { std::free(memory); }
};
using Reals = std::unique_ptr<double, FreeReals>;

/// Not initialised; aligned to a cache line. Large arrays lie on large pages where the system grants them, and begin at different distances from a page's start: a
/// step works on the same row of a dozen of them, and rows at one distance would all want the same lines of the cache (together about a tenth of a step at
/// 1024^2). Throws std::bad_alloc.
inline Reals allocate_reals(std::size_t count)
{
  constexpr std::size_t cache_line = 64, large_page = std::size_t{1} << 21, distances = 13, distance = 3 * 4096 + 5 * cache_line;
  const std::size_t bytes = count * sizeof(double);
  const bool large = bytes >= large_page;
  const std::size_t alignment = large ? large_page : cache_line, needed = bytes + (large ? distances * distance : 0);
  const std::size_t whole = (needed + alignment - 1) / alignment * alignment;
  void *memory = std::aligned_alloc(alignment, whole);
  if (!memory) throw std::bad_alloc();
  std::size_t shift = 0;
  if (large) {
    madvise(memory, whole, MADV_HUGEPAGE);  // advice: no harm where it is not taken
    shift = reinterpret_cast<std::uintptr_t>(memory) / large_page % distances * distance;
  }
  return Reals(static_cast<double *>(memory) + shift / sizeof(double), FreeReals{memory});
}

}  // namespace swellflow
