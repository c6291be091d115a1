// Counts what a real-time thread must not do: allocate, free, lock, throw, write to a stream.
//
// trap.cpp defines these functions of the C library and of the C++ runtime anew, so every call of
// them in this executable passes through it, whoever makes it. A sanitizer brings a malloc of its
// own, which cannot be replaced: there the trap is off.
#pragma once

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
#define KERF_TRAP_WORKS 0
#elif defined(__has_feature)
#if __has_feature(address_sanitizer) || __has_feature(memory_sanitizer) || \
    __has_feature(thread_sanitizer)
#define KERF_TRAP_WORKS 0
#endif
#endif
#ifndef KERF_TRAP_WORKS
#define KERF_TRAP_WORKS 1
#endif

namespace kerf::test {

struct TrapCounts {
  long allocations = 0;
  long frees = 0;
  long locks = 0;
  long throws = 0;
  long writes = 0;

  [[nodiscard]] long total() const { return allocations + frees + locks + throws + writes; }
};

// Armed for this thread from construction to destruction. Not to be nested.
class Trap {
 public:
  Trap() noexcept;
  ~Trap();
  Trap(const Trap&) = delete;
  Trap& operator=(const Trap&) = delete;

  // Since the construction of the last Trap of this thread.
  static TrapCounts counts() noexcept;
};

}  // namespace kerf::test
