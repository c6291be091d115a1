// Who sees each block of a program just before it runs.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "diagnostics/source_position.hpp"
#include "parser/modal/modal_state.hpp"

namespace kerf::parser {

// A line that is about to run: a block, a comment or a flow statement. Views and references are
// good for the call.
struct UpcomingBlock {
  std::string_view text;  // the line as written
  diagnostics::SourcePosition source{};
  const ModalState& state;             // in force before it
  std::uint64_t blocks_before = 0;     // Move::block of its own moves and later ones is greater
  bool in_curve = false;               // a curve of several blocks has begun and is not complete
  std::vector<std::uint32_t> calls{};  // lines of the calls around it, the outermost first
};

class BlockWatcher {
 public:
  BlockWatcher() = default;
  BlockWatcher(const BlockWatcher&) = delete;
  BlockWatcher& operator=(const BlockWatcher&) = delete;
  virtual ~BlockWatcher() = default;

  // In the order of the program's run.
  virtual void about_to_run(const UpcomingBlock& block) = 0;
};

// What is kept of one.
struct WatchedBlock {
  explicit WatchedBlock(const UpcomingBlock& block)
      : text(block.text),
        state(block.state),
        blocks_before(block.blocks_before),
        calls(block.calls) {}

  std::string text;
  ModalState state;
  std::uint64_t blocks_before;
  std::vector<std::uint32_t> calls;
};

}  // namespace kerf::parser
