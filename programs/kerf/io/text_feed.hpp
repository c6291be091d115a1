// The source of a running program's text.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include <tl/expected.hpp>

#include "programs/kerf/io/descriptor.hpp"
#include "programs/kerf/io/program_file.hpp"

namespace kerf::program {

struct TextPiece {
  enum class State : unsigned char { text, not_yet, end };
  State state = State::end;
  std::string_view bytes{};  // valid until the next read
};

// Never waits: text that has not come yet is `not_yet`.
class TextFeed {
 public:
  TextFeed() = default;
  virtual ~TextFeed() = default;
  TextFeed(const TextFeed&) = delete;
  TextFeed& operator=(const TextFeed&) = delete;

  // Error: what the system says, with the program's name.
  virtual tl::expected<TextPiece, std::string> read() = 0;
  // 0..1; 0 where nobody can know.
  [[nodiscard]] virtual double share_read() const noexcept = 0;
};

// The whole text is in a file.
class FileFeed final : public TextFeed {
 public:
  explicit FileFeed(ProgramFile& file) noexcept : file_(&file) {}
  tl::expected<TextPiece, std::string> read() override;
  [[nodiscard]] double share_read() const noexcept override;

 private:
  ProgramFile* file_;
};

// A pipe, a terminal or a socket whose text is still being written: it can be read only once, so it
// runs without having been checked as a whole.
class LiveFeed final : public TextFeed {
 public:
  LiveFeed(std::string name, Descriptor source);
  tl::expected<TextPiece, std::string> read() override;
  [[nodiscard]] double share_read() const noexcept override { return 0.0; }

 private:
  std::string name_;
  Descriptor source_;
  std::vector<char> buffer_;
};

}  // namespace kerf::program
