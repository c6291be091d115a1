// A planning side whose every plan() finds no memory.
#pragma once

#include <new>
#include <string_view>

#include <kerf/kernel.hpp>

#include "programs/kerf/run/planning_side.hpp"

namespace kerf::program {

class NoMemory final : public PlanningSide {
 public:
  explicit NoMemory(const Kernel& kernel) : kernel_(&kernel) {}
  void feed(std::string_view /*text*/) override {}
  void finish() override {}
  bool plan() override { throw std::bad_alloc(); }
  void text_is_late() override {}
  void stop() override {}
  [[nodiscard]] const Kernel& kernel() const override { return *kernel_; }

 private:
  const Kernel* kernel_;
};

}  // namespace kerf::program
