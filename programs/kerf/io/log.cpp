#include "programs/kerf/io/log.hpp"

#include <algorithm>
#include <fcntl.h>
#include <filesystem>
#include <memory>
#include <mutex>
#include <system_error>
#include <unistd.h>
#include <utility>

#include <spdlog/sinks/basic_file_sink.h>
#include <spdlog/sinks/stdout_color_sinks.h>
#include <spdlog/spdlog.h>

#include "programs/kerf/io/descriptor.hpp"

namespace kerf::program {

namespace {

using spdlog::level::level_enum;

level_enum level_of(LogLevel level) {
  switch (level) {
    case LogLevel::debug:
      return level_enum::debug;
    case LogLevel::error:
      return level_enum::err;
    case LogLevel::info:
      break;
  }
  return level_enum::info;
}

// The level of standard error: a file takes what is below info.
level_enum shown_level(const LogSettings& settings) {
  const level_enum level = level_of(settings.level);
  const level_enum lowest = settings.quiet  ? level_enum::err
                            : settings.file ? level_enum::info
                                            : level_enum::trace;
  return std::max(level, lowest);
}

// What could not be written first. Planning thread and main one write.
class FirstFailure {
 public:
  void note(const std::string& what) {
    const std::scoped_lock lock(mutex_);
    if (what_.empty()) {
      what_ = what;
    }
  }
  [[nodiscard]] std::string what() {
    const std::scoped_lock lock(mutex_);
    return what_;
  }

 private:
  std::mutex mutex_;
  std::string what_;
};

FirstFailure& log_failure() {
  static FirstFailure failure;
  return failure;
}

// A FIFO without a reader would keep who opens it waiting.
bool is_unread_fifo(const std::string& path) {
  std::error_code error;
  return std::filesystem::is_fifo(path, error) &&
         !Descriptor(::open(path.c_str(), O_WRONLY | O_NONBLOCK | O_CLOEXEC)).is_open();
}

}  // namespace

tl::expected<void, std::string> open_log(const LogSettings& settings) {
  // The planning thread and the main one write.
  auto shown = std::make_shared<spdlog::sinks::stderr_color_sink_mt>();
  shown->set_pattern("%n: %^%l%$: %v");
  shown->set_level(shown_level(settings));
  auto logger = std::make_shared<spdlog::logger>("kerf", std::move(shown));
  if (settings.file) {
    // spdlog would make the folders.
    const auto folder = std::filesystem::path(*settings.file).parent_path();
    if (std::error_code error; !folder.empty() && !std::filesystem::is_directory(folder, error)) {
      return tl::make_unexpected(*settings.file + ": there is no folder " + folder.string());
    }
    if (is_unread_fifo(*settings.file)) {
      return tl::make_unexpected(*settings.file + ": nobody reads it");
    }
    try {
      auto kept = std::make_shared<spdlog::sinks::basic_file_sink_mt>(*settings.file, true);
      kept->set_pattern("%Y-%m-%d %H:%M:%S.%e %n: %l: %v");
      kept->set_level(level_of(settings.level));
      logger->sinks().push_back(std::move(kept));
    } catch (const spdlog::spdlog_ex& exception) {
      return tl::make_unexpected(std::string(exception.what()));
    }
  }
  logger->set_level(level_enum::trace);  // its sinks decide
  logger->set_error_handler([](const std::string& what) { log_failure().note(what); });
  spdlog::set_default_logger(std::move(logger));
  return {};
}

tl::expected<void, std::string> close_log() {
  spdlog::default_logger_raw()->flush();
  if (const std::string what = log_failure().what(); !what.empty()) {
    return tl::make_unexpected(what);
  }
  return {};
}

void log_debug(std::string_view line) {
  spdlog::debug("{}", line);
}

void write_error_line(std::string_view line) {
  write_all(STDERR_FILENO, std::string(line) + "\n");
}

}  // namespace kerf::program
