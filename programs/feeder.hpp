// Text from the file into the kernel, as it asks for it.
#pragma once

#include <optional>
#include <string>

#include "kernel/kernel.hpp"
#include "programs/program_file.hpp"
#include "programs/progress.hpp"

namespace kerf::program {

// Belongs to the thread that plans. A file that cannot be read any more, and a request to stop, let
// the tool come to rest on the path.
class Feeder {
 public:
  Feeder(Kernel& kernel, ProgramFile& file, Progress& progress) noexcept
      : kernel_(&kernel), file_(&file), progress_(&progress) {}

  // Plans as far ahead as there is room.
  void pump();
  void stop();

  [[nodiscard]] const std::optional<std::string>& error() const noexcept { return error_; }

 private:
  void feed_piece();

  Kernel* kernel_;
  ProgramFile* file_;
  Progress* progress_;
  bool stopped_ = false;
  std::optional<std::string> error_;
};

}  // namespace kerf::program
