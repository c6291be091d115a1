#include "tests/kernel/tick_path/trap.hpp"

#include <cerrno>
#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <dlfcn.h>
#include <pthread.h>
#include <typeinfo>

namespace kerf::test {
namespace {

thread_local bool armed = false;
thread_local TrapCounts found;

}  // namespace

Trap::Trap() noexcept {
  found = {};
  armed = true;
}
Trap::~Trap() {
  armed = false;
}
TrapCounts Trap::counts() noexcept {
  return found;
}

#if KERF_TRAP_WORKS
namespace {

void note(long TrapCounts::*what) noexcept {
  if (armed) {
    ++(found.*what);
  }
}

// The function that this executable's own definition hides.
template <typename Function>
Function* hidden(const char* name) noexcept {
  return reinterpret_cast<Function*>(dlsym(RTLD_NEXT, name));
}

}  // namespace
#endif

}  // namespace kerf::test

#if KERF_TRAP_WORKS

using kerf::test::hidden;
using kerf::test::note;
using kerf::test::TrapCounts;

// glibc's own names for its allocator.
extern "C" {
void* __libc_malloc(std::size_t size);
void* __libc_calloc(std::size_t count, std::size_t size);
void* __libc_realloc(void* block, std::size_t size);
void* __libc_memalign(std::size_t alignment, std::size_t size);
void __libc_free(void* block);

void* malloc(std::size_t size) noexcept {
  note(&TrapCounts::allocations);
  return __libc_malloc(size);
}
void* calloc(std::size_t count, std::size_t size) noexcept {
  note(&TrapCounts::allocations);
  return __libc_calloc(count, size);
}
void* realloc(void* block, std::size_t size) noexcept {
  note(&TrapCounts::allocations);
  return __libc_realloc(block, size);
}
void* memalign(std::size_t alignment, std::size_t size) noexcept {
  note(&TrapCounts::allocations);
  return __libc_memalign(alignment, size);
}
void* aligned_alloc(std::size_t alignment, std::size_t size) noexcept {
  note(&TrapCounts::allocations);
  return __libc_memalign(alignment, size);
}
int posix_memalign(void** block, std::size_t alignment, std::size_t size) noexcept {
  note(&TrapCounts::allocations);
  *block = __libc_memalign(alignment, size);
  return *block == nullptr ? ENOMEM : 0;
}
void free(void* block) noexcept {
  note(&TrapCounts::frees);
  __libc_free(block);
}

int pthread_mutex_lock(pthread_mutex_t* mutex) noexcept {
  static const auto real = hidden<int(pthread_mutex_t*)>("pthread_mutex_lock");
  note(&TrapCounts::locks);
  return real(mutex);
}
int pthread_rwlock_rdlock(pthread_rwlock_t* lock) noexcept {
  static const auto real = hidden<int(pthread_rwlock_t*)>("pthread_rwlock_rdlock");
  note(&TrapCounts::locks);
  return real(lock);
}
int pthread_rwlock_wrlock(pthread_rwlock_t* lock) noexcept {
  static const auto real = hidden<int(pthread_rwlock_t*)>("pthread_rwlock_wrlock");
  note(&TrapCounts::locks);
  return real(lock);
}

std::size_t fwrite(const void* data, std::size_t size, std::size_t count, FILE* stream) {
  static const auto real =
      hidden<std::size_t(const void*, std::size_t, std::size_t, FILE*)>("fwrite");
  note(&TrapCounts::writes);
  return real(data, size, count, stream);
}
}  // extern "C"

namespace __cxxabiv1 {
extern "C" [[noreturn]] void __cxa_throw(void* object, std::type_info* type,
                                         void (*destructor)(void*)) {
  static const auto real = hidden<void(void*, std::type_info*, void (*)(void*))>("__cxa_throw");
  note(&TrapCounts::throws);
  real(object, type, destructor);
  std::abort();
}
}  // namespace __cxxabiv1

#endif
