// The messages of a program, on standard error while it runs.
#pragma once

#include <atomic>
#include <cstdint>
#include <string>
#include <thread>

#include <kerf/controller.hpp>

namespace kerf::program {

// "part.ngc:12: message: put in tool 2". In a thread of its own: a terminal that is stopped stops
// nothing else. The destructor writes what is left.
class MessagePrinter {
 public:
  MessagePrinter(const Controller& controller, std::string file);
  ~MessagePrinter();
  MessagePrinter(const MessagePrinter&) = delete;
  MessagePrinter& operator=(const MessagePrinter&) = delete;

 private:
  void print_new();

  const Controller* controller_;
  std::string file_;
  std::string before_;  // clears the line of the progress bar
  std::uint64_t next_event_ = 1;
  std::atomic<bool> over_ = false;
  std::thread thread_;
};

}  // namespace kerf::program
