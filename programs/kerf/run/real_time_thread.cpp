#include "programs/kerf/run/real_time_thread.hpp"

#include <array>
#include <cerrno>
#include <cstdint>
#include <fcntl.h>
#include <linux/capability.h>
#include <malloc.h>
#include <sched.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <sys/syscall.h>
#include <unistd.h>

namespace kerf::program {

namespace {

// Memory that is locked as it comes counts towards a limit, beyond which nothing more is given:
// only who has none may ask for it.
bool may_lock_all() noexcept {
  rlimit limit{};
  if (getrlimit(RLIMIT_MEMLOCK, &limit) == 0 && limit.rlim_cur == RLIM_INFINITY) {
    return true;
  }
  __user_cap_header_struct head{.version = _LINUX_CAPABILITY_VERSION_3, .pid = 0};
  std::array<__user_cap_data_struct, 2> data{};
  return syscall(SYS_capget, &head, data.data()) == 0 &&
         (data[0].effective & (1U << static_cast<unsigned>(CAP_IPC_LOCK))) != 0;
}

[[gnu::noinline]] void touch_stack() noexcept {
  // NOLINTNEXTLINE(cppcoreguidelines-pro-type-member-init): a byte a page will do
  std::array<volatile char, std::size_t{256} * 1024> room;
  for (std::size_t at = 0; at < room.size(); at += 1024) {
    room[at] = 0;
  }
}

// The last processor that this process may have: interrupts come to the first ones.
bool last_processor(cpu_set_t& set) noexcept {
  CPU_ZERO(&set);
  if (sched_getaffinity(0, sizeof set, &set) != 0 || CPU_COUNT(&set) < 2) {
    return false;
  }
  std::size_t last = CPU_SETSIZE - 1;
  while (!CPU_ISSET(last, &set)) {
    --last;
  }
  CPU_ZERO(&set);
  CPU_SET(last, &set);
  return true;
}

}  // namespace

RealTimeThread::RealTimeThread() {
  lock_memory();
  touch_stack();
  keep_awake();
  schedule();
}

RealTimeThread::~RealTimeThread() {
  const sched_param usual{};
  sched_setscheduler(0, SCHED_OTHER, &usual);
  munlockall();
}

void RealTimeThread::lock_memory() {
  // Memory that was used once stays.
  mallopt(M_TRIM_THRESHOLD, -1);
  mallopt(M_MMAP_MAX, 0);
  if (!may_lock_all()) {
    note("locked memory", EPERM);
  } else if (mlockall(MCL_CURRENT | MCL_FUTURE) != 0) {
    note("locked memory", errno);
  }
}

void RealTimeThread::keep_awake() {
  latency_ = Descriptor(::open("/dev/cpu_dma_latency", O_WRONLY | O_CLOEXEC));
  const std::int32_t none_us = 0;
  if (!latency_.is_open() || ::write(latency_.number(), &none_us, sizeof none_us) < 0) {
    note("/dev/cpu_dma_latency", errno);
  }
}

void RealTimeThread::schedule() {
  cpu_set_t processor;
  if (last_processor(processor) && sched_setaffinity(0, sizeof processor, &processor) != 0) {
    note("one processor", errno);
  }
  const sched_param first{.sched_priority = kPriority};
  if (sched_setscheduler(0, SCHED_FIFO | SCHED_RESET_ON_FORK, &first) != 0) {
    note("SCHED_FIFO", errno);
  }
}

void RealTimeThread::note(const std::string& what, int error_number) {
  refusals_.push_back(what + ": " + error_text(error_number));
}

}  // namespace kerf::program
