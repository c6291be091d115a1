// A run whose overrides change at given ticks.
#pragma once

#include <cstdint>
#include <map>
#include <string>

#include <gtest/gtest.h>
#include <kerf/kernel.hpp>

#include "tests/kernel/watched_run.hpp"

namespace kerf::test {

using OverridesAt = std::map<std::int64_t, Overrides>;  // before each of these ticks

inline WatchedRun run_with(const std::string& text, const KernelOptions& options,
                           const OverridesAt& overrides, const MachineSettings& settings = mill()) {
  return watched_run({.text = text, .options = options, .settings = settings},
                     [&](Kernel& kernel, const WatchedRun& run) {
                       if (const auto now = overrides.find(run.next()); now != overrides.end()) {
                         EXPECT_TRUE(kernel.set_overrides(now->second));
                       }
                     });
}

}  // namespace kerf::test
