#include "programs/kerf/io/log.hpp"

#include <memory>
#include <unistd.h>

#include <spdlog/sinks/stdout_color_sinks.h>
#include <spdlog/spdlog.h>

#include "programs/kerf/io/descriptor.hpp"

namespace kerf::program {

void open_log(bool quiet) {
  auto logger = std::make_shared<spdlog::logger>(
      "kerf", std::make_shared<spdlog::sinks::stderr_color_sink_st>());
  logger->set_pattern("%n: %^%l%$: %v");
  logger->set_level(quiet ? spdlog::level::err : spdlog::level::info);
  spdlog::set_default_logger(std::move(logger));
}

void write_error_line(std::string_view line) {
  write_all(STDERR_FILENO, std::string(line) + "\n");
}

}  // namespace kerf::program
