#pragma once
// Memory that starts on a cache line, so that a wide load never straddles two; and memory that is
// kept from use to use.

#include <cstddef>
#include <new>
#include <vector>

namespace tuberia {

inline constexpr std::size_t kCacheLineBytes = 64;

template <class T>
struct CacheLineAllocator {
  using value_type = T;
  CacheLineAllocator() = default;
  template <class U>
  CacheLineAllocator(const CacheLineAllocator<U>&) noexcept {}

  T* allocate(std::size_t count) {
    return static_cast<T*>(::operator new(count * sizeof(T), std::align_val_t{kCacheLineBytes}));
  }
  void deallocate(T* pointer, std::size_t) noexcept {
    ::operator delete(pointer, std::align_val_t{kCacheLineBytes});
  }
  bool operator==(const CacheLineAllocator&) const = default;
};

template <class T>
using AlignedVector = std::vector<T, CacheLineAllocator<T>>;

/// Makes room for `count` elements. Never takes any away, so that a vector that is used again and
/// again is filled with zeros once and not each time it grows back.
template <class Vector>
void make_room(Vector& vector, std::size_t count) {
  if (vector.size() < count) vector.resize(count);
}

}  // namespace tuberia
