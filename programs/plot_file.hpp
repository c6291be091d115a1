// The file that a plot goes to: opened before the motion, written after it.
#pragma once

#include <string>
#include <string_view>

#include <tl/expected.hpp>

#include "programs/descriptor.hpp"

namespace kerf::program {

class PlotFile {
 public:
  // Error: what the system says, with the path.
  static tl::expected<PlotFile, std::string> create(const std::string& path);
  // Once.
  tl::expected<void, std::string> write(std::string_view document);

 private:
  PlotFile(std::string path, Descriptor descriptor)
      : path_(std::move(path)), descriptor_(std::move(descriptor)) {}

  std::string path_;
  Descriptor descriptor_;
};

}  // namespace kerf::program
