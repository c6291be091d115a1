// The messages of a program, and what it waits for a person for, on standard error while it runs.
#pragma once

#include <atomic>
#include <cstdint>
#include <string>
#include <thread>

#include <kerf/controller.hpp>

namespace kerf::program {

// "part.ngc:12: message: put in tool 2", "waiting at line 13 for tool 2 (M6): Enter goes on". In a
// thread of its own: a terminal that is stopped stops
// nothing else. The destructor writes what is left.
class MessagePrinter {
 public:
  // How waits are written, once each: all; but those after each block of single block, where a
  // status line shows them; or none, for nobody is there to answer.
  enum class Waits : unsigned char { none, all_but_block_ends, all };

  MessagePrinter(const Controller& controller, std::string file, Waits waits);
  ~MessagePrinter();
  MessagePrinter(const MessagePrinter&) = delete;
  MessagePrinter& operator=(const MessagePrinter&) = delete;

 private:
  void print_new();
  void print(const ProgramMessage& message) const;
  void print_wait() const;

  const Controller* controller_;
  std::string file_;
  Waits waits_;
  std::string before_;  // clears the line of the progress bar
  std::uint64_t next_event_ = 1;
  std::atomic<bool> over_ = false;
  std::thread thread_;
};

}  // namespace kerf::program
