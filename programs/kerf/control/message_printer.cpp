#include "programs/kerf/control/message_printer.hpp"

#include <array>
#include <chrono>
#include <unistd.h>
#include <utility>

#include <spdlog/fmt/fmt.h>

#include "programs/kerf/control/status_line.hpp"
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

MessagePrinter::MessagePrinter(const Controller& controller, std::string file, Waits waits)
    : controller_(&controller),
      file_(std::move(file)),
      waits_(waits),
      before_(ProgressBar::before_a_line()),
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
  bool waits = false;
  for (std::size_t i = 0; i < count; ++i) {
    next_event_ = events[i].number + 1;
    if (events[i].kind == ControllerEvent::Kind::state) {
      waits = events[i].waits_for == WaitsFor::answer;
    } else if (const auto message = controller_->message(events[i].message)) {
      print(*message);
    }
  }
  if (waits) {
    print_wait();
  }
}

void MessagePrinter::print(const ProgramMessage& message) const {
  const std::string line = message.line != 0 ? fmt::format(":{}", message.line) : "";
  write_all(STDERR_FILENO, fmt::format("{}{}{}: {}: {}\n", before_, visible(file_), line,
                                       name_of(message.kind), visible(message.text)));
}

// An event has no tool. A wait that is over by now calls for nobody.
void MessagePrinter::print_wait() const {
  const ControllerStatus status = controller_->status();
  const bool is_written = waits_ == Waits::all || (waits_ == Waits::all_but_block_ends &&
                                                   status.wait_cause != WaitCause::block_end);
  if (is_written && status.waits_for == WaitsFor::answer) {
    write_all(STDERR_FILENO, before_ + call_for_answer(status) + '\n');
  }
}

}  // namespace kerf::program
