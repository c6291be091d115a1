#include "programs/plot_file.hpp"

#include <cerrno>
#include <fcntl.h>

namespace kerf::program {

tl::expected<PlotFile, std::string> PlotFile::create(const std::string& path) {
  Descriptor file(::open(path.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666));
  if (!file.is_open()) {
    return tl::unexpected(path + ": " + error_text(errno));
  }
  return PlotFile(path, std::move(file));
}

tl::expected<void, std::string> PlotFile::write(std::string_view document) {
  int error = write_all(descriptor_.number(), document);
  if (const int closing = descriptor_.close(); error == 0) {
    error = closing;
  }
  if (error != 0) {
    return tl::unexpected(path_ + ": " + error_text(error) + "; the plot is incomplete");
  }
  return {};
}

}  // namespace kerf::program
