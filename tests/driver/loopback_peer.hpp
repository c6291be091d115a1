// The other end of a LoopbackMachine, in the same thread: a simulated table behind a socket.
#pragma once

#include <cstring>
#include <functional>
#include <future>
#include <memory>
#include <string>
#include <sys/socket.h>
#include <sys/un.h>
#include <vector>

#include <gtest/gtest.h>

#include "machine/simulated_table.hpp"
#include "programs/kerf/driver/loopback_machine.hpp"
#include "tests/machine/tables.hpp"
#include "tests/program/temporary_folder.hpp"

namespace kerf::program::test {

class LoopbackPeer {
 public:
  explicit LoopbackPeer(const std::string& path) {
    sockaddr_un address{};
    address.sun_family = AF_UNIX;
    std::strncpy(static_cast<char*>(address.sun_path), path.c_str(), sizeof address.sun_path - 1);
    listener_ = Descriptor(::socket(AF_UNIX, SOCK_SEQPACKET, 0));
    ::bind(listener_.number(), reinterpret_cast<const sockaddr*>(&address), sizeof address);
    ::listen(listener_.number(), 1);
  }

  void accept() { connection_ = Descriptor(::accept(listener_.number(), nullptr, nullptr)); }
  void hang_up() { connection_ = Descriptor(); }
  void send(std::string bytes) {
    ::send(connection_.number(), bytes.data(), bytes.size(), MSG_NOSIGNAL);
  }
  // The next frame, when it has come; nothing without one.
  [[nodiscard]] std::optional<ToldFrame> receive(int flags = MSG_DONTWAIT) {
    ToldBytes bytes{};
    const ssize_t count = ::recv(connection_.number(), bytes.data(), bytes.size(), flags);
    return count > 0 ? told_from(bytes) : std::nullopt;
  }
  // Answers one as the table does.
  void answer(const ToldFrame& told) {
    const Setpoint& setpoint = told.setpoint;
    if (told.call == MachineCall::enable) {
      table_.enable({.mm = setpoint.position_mm, .extra_rad_mm = setpoint.extra_rad_mm});
    } else if (told.call == MachineCall::disable) {
      table_.disable();
    } else {
      table_.write(setpoint);
    }
    answer_with(setpoint.tick, table_.read());
  }
  void answer_with(std::int64_t tick, const machine::MachineState& state) {
    send(text_of(to_bytes(AnswerFrame{.tick = tick, .state = state})));
  }
  // All that has come.
  void serve() {
    while (const auto told = receive()) {
      told_.push_back(*told);
      answer(*told);
    }
  }
  [[nodiscard]] const std::vector<ToldFrame>& told() const { return told_; }
  [[nodiscard]] machine::SimulatedTable& table() { return table_; }

  static std::string text_of(const AnswerBytes& bytes) {
    return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
  }

 private:
  Descriptor listener_;
  Descriptor connection_;
  machine::SimulatedTable table_{machine::test::real()};
  std::vector<ToldFrame> told_;
};

// A loopback machine and its peer, which answers the greeting with `greets`.
struct LoopbackPair {
  using Greeting = std::function<void(LoopbackPeer&, const ToldFrame&)>;

  explicit LoopbackPair(const Greeting& greets = [](LoopbackPeer& peer, const ToldFrame& told) {
    peer.answer(told);
  }) {
    auto opening = std::async(std::launch::async, [this] {
      return LoopbackMachine::open(
          {.socket = path, .timeout_s = 0.01, .table = machine::test::real()});
    });
    peer.accept();
    if (const auto told = peer.receive(0)) {
      greets(peer, *told);
    }
    opened = opening.get();
  }
  [[nodiscard]] LoopbackMachine& machine() { return **opened; }

  TemporaryFolder folder;
  std::string path = folder / "machine.sock";
  LoopbackPeer peer{path};
  tl::expected<std::unique_ptr<LoopbackMachine>, std::string> opened{nullptr};
};

inline Setpoint setpoint_at(std::int64_t tick) {
  return {.tick = tick, .position_mm = {0.01 * static_cast<double>(tick), 0.0, 0.0}};
}

class Loopback : public testing::Test {
 protected:
  static constexpr int kTimeoutTicks = 10;

  void SetUp() override {
    ASSERT_TRUE(pair_.opened) << pair_.opened.error();
    pair_.machine().enable({});
  }
  void write() { pair_.machine().write(setpoint_at(++tick_)); }
  void run(int ticks) {
    for (int i = 0; i < ticks; ++i) {
      write();
      pair_.peer.serve();
    }
  }
  // Ticks without an answer until it faults.
  int ticks_to_fault() {
    int ticks = 0;
    for (; state().fault == machine::DriveFault::none && ticks < 10'000; ++ticks) {
      write();
    }
    return ticks;
  }
  [[nodiscard]] machine::MachineState state() { return pair_.machine().read(); }

  LoopbackPair pair_;
  std::int64_t tick_ = 0;
};

}  // namespace kerf::program::test
