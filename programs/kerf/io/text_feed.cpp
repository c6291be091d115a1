#include "programs/kerf/io/text_feed.hpp"

#include <algorithm>
#include <cerrno>
#include <poll.h>
#include <utility>

namespace kerf::program {

tl::expected<TextPiece, std::string> FileFeed::read() {
  const auto piece = file_->read();
  if (!piece) {
    return tl::unexpected(piece.error());
  }
  return TextPiece{.state = piece->empty() ? TextPiece::State::end : TextPiece::State::text,
                   .bytes = *piece};
}

double FileFeed::share_read() const noexcept {
  const auto size = static_cast<double>(std::max<std::uint64_t>(file_->size_bytes(), 1));
  return static_cast<double>(file_->bytes_read()) / size;
}

LiveFeed::LiveFeed(std::string name, Descriptor source)
    : name_(std::move(name)), source_(std::move(source)), buffer_(ProgramFile::kPieceBytes) {}

tl::expected<TextPiece, std::string> LiveFeed::read() {
  pollfd waiting{.fd = source_.number(), .events = POLLIN, .revents = 0};
  const int ready = ::poll(&waiting, 1, 0);
  if (ready == 0 || (ready < 0 && errno == EINTR)) {
    return TextPiece{.state = TextPiece::State::not_yet};
  }
  const ssize_t count = ready < 0 ? -1 : ::read(source_.number(), buffer_.data(), buffer_.size());
  if (count > 0) {
    return TextPiece{.state = TextPiece::State::text,
                     .bytes = {buffer_.data(), static_cast<std::size_t>(count)}};
  }
  if (count == 0) {
    return TextPiece{.state = TextPiece::State::end};
  }
  if (errno == EINTR || errno == EAGAIN) {
    return TextPiece{.state = TextPiece::State::not_yet};
  }
  return tl::unexpected(name_ + ": " + error_text(errno));
}

}  // namespace kerf::program
