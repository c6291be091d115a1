#include "programs/kerf/control/message_printer.hpp"

#include <array>
#include <chrono>
#include <unistd.h>
#include <utility>

#include <spdlog/fmt/fmt.h>

#include "programs/kerf/io/descriptor.hpp"
#include "programs/kerf/io/progress_bar.hpp"
#include "programs/kerf/io/visible_text.hpp"

namespace kerf::program {

namespace {

constexpr std::chrono::milliseconds kPause{50};

const char* name_of(ProgramMessage::Kind kind) {
  switch (kind) {
    case ProgramMessage::Kind::print:
      return "print";
    case ProgramMessage::Kind::debug:
      return "debug";
    case ProgramMessage::Kind::message:
      break;
  }
  return "message";
}

}  // namespace

MessagePrinter::MessagePrinter(const Controller& controller, std::string file)
    : controller_(&controller),
      file_(std::move(file)),
      before_(ProgressBar::has_terminal() ? "\r\x1b[K" : ""),
      thread_([this] {
        while (!over_) {
          print_new();
          std::this_thread::sleep_for(kPause);
        }
      }) {}

MessagePrinter::~MessagePrinter() {
  over_ = true;
  thread_.join();
  print_new();
}

void MessagePrinter::print_new() {
  std::array<ControllerEvent, ControllerEvent::kKept> events;
  const std::size_t count = controller_->events_since(next_event_, events);
  for (std::size_t i = 0; i < count; ++i) {
    next_event_ = events[i].number + 1;
    const auto message = events[i].kind == ControllerEvent::Kind::message
                             ? controller_->message(events[i].message)
                             : std::nullopt;
    if (message) {
      const std::string line = message->line != 0 ? fmt::format(":{}", message->line) : "";
      write_all(STDERR_FILENO, fmt::format("{}{}{}: {}: {}\n", before_, visible(file_), line,
                                           name_of(message->kind), visible(message->text)));
    }
  }
}

}  // namespace kerf::program
