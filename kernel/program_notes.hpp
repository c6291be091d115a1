// What an operator is told of a program while it runs: its messages, and the codes in force.
#pragma once

#include <cstdint>
#include <deque>
#include <string>
#include <vector>

#include "kernel/pipeline_observer.hpp"

namespace kerf {

// Text is read ahead of the motion, by up to a window and more: what belongs to a block is kept
// until the tool has come to it. Of the planning thread.
class ProgramNotes final : public PipelineObserver {
 public:
  void read(const parser::ProgramReader& reader) override;
  void move(const parser::Move& move) override;

  // The tool has come to this block (parser::Move::block), or to the program's end.
  void reach(std::uint64_t block);
  void reach_end();

  // Those of the blocks that were reached since the last call.
  std::vector<ProgramMessage> take_messages();
  // "G1 G17 G21 ...", behind the words of the block that was reached.
  [[nodiscard]] const std::string& codes() const noexcept { return codes_; }

 private:
  struct Codes {
    std::uint64_t block = 0;
    std::string text{};
  };
  std::deque<parser::NumberedMessage> messages_;
  std::vector<ProgramMessage> reached_messages_;
  std::string read_codes_;
  std::deque<Codes> codes_ahead_;
  std::string codes_;
};

}  // namespace kerf
