// One connection of the control channel.
#pragma once

#include <chrono>
#include <cstddef>
#include <deque>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include <boost/asio/error.hpp>
#include <boost/asio/io_context.hpp>
#include <boost/asio/posix/stream_descriptor.hpp>
#include <boost/asio/read_until.hpp>
#include <boost/asio/write.hpp>

#include "programs/kerf/io/descriptor.hpp"

namespace kerf::program {

// Gives each line that comes to on_line, nothing for one that is too long, and writes lines without
// waiting. Of the channel's thread.
class ControlClient : public std::enable_shared_from_this<ControlClient> {
 public:
  using OnLine =
      std::function<void(const std::shared_ptr<ControlClient>&, std::optional<std::string_view>)>;

  ControlClient(boost::asio::io_context& context, Descriptor in, Descriptor out, OnLine on_line)
      : in_(context, std::move(in).release()), on_line_(std::move(on_line)) {
    if (out.is_open()) {
      out_.emplace(context, std::move(out).release());
    }
  }

  // NOLINTBEGIN(misc-no-recursion): each handler is called once this call is long over.
  void read() {
    boost::asio::async_read_until(
        in_, boost::asio::dynamic_buffer(text_, kLongestLine), '\n',
        [self = shared_from_this()](const boost::system::error_code& error, std::size_t size) {
          if (error == boost::asio::error::not_found) {  // too long: its end is looked for
            self->is_too_long_ = true;
            self->text_.clear();
          } else if (error) {
            self->stop_reading();
            return;
          } else {
            const bool is_whole = !std::exchange(self->is_too_long_, false);
            self->on_line_(
                self, is_whole ? std::optional(std::string_view(self->text_).substr(0, size - 1))
                               : std::nullopt);
            self->text_.erase(0, size);
          }
          self->read();
        });
  }
  // NOLINTEND(misc-no-recursion)
  void write(std::string line) {
    if (lines_.empty()) {
      took_ = std::chrono::steady_clock::now();
    }
    waiting_bytes_ += line.size();
    lines_.push_back(std::move(line));
    if (waiting_bytes_ > kMuchWaiting && (waiting_bytes_ > kMaxWaiting || takes_nothing())) {
      close();
    } else if (lines_.size() == 1) {
      write_next();
    }
  }
  // A line is answered from another thread: with end_answer(), in this one.
  void begin_answer() { ++unanswered_; }
  void end_answer(std::string line) {
    --unanswered_;
    write(std::move(line));
  }
  void close() {
    boost::system::error_code ignored;
    in_.close(ignored);
    if (out_) {
      out_->close(ignored);
    }
    is_open_ = false;
  }

  [[nodiscard]] bool is_open() const { return is_open_; }
  [[nodiscard]] bool reads() const { return is_open_ && reads_; }
  [[nodiscard]] bool has_written() const { return !is_open_ || lines_.empty(); }

  // Statuses that come by themselves; 0: none.
  std::chrono::steady_clock::duration every{0};
  std::chrono::steady_clock::time_point next_status{};
  std::string every_id{"null"};  // of the request for them

 private:
  static constexpr std::size_t kLongestLine = 65'536;
  // Bytes. The first is a lot for a client that takes none of them; many messages at once, or all
  // events again, are as many for one that does.
  static constexpr std::size_t kMuchWaiting = 1U << 20U;
  static constexpr std::size_t kMaxWaiting = 1U << 24U;
  static constexpr std::chrono::seconds kPatience{1};

  [[nodiscard]] bool takes_nothing() const {
    return std::chrono::steady_clock::now() - took_ > kPatience;
  }

  // It may still be told what happens; where it ends with what it reads, what was asked for.
  void stop_reading() {
    reads_ = false;
    close_where_over();
  }
  void close_where_over() {
    if (!reads_ && !out_ && unanswered_ == 0 && lines_.empty()) {
      close();
    }
  }
  // NOLINTBEGIN(misc-no-recursion): as read().
  void write_next() {
    boost::asio::async_write(
        out_ ? *out_ : in_, boost::asio::buffer(lines_.front()),
        [self = shared_from_this()](const boost::system::error_code& error, std::size_t size) {
          if (error) {
            self->close();
            return;
          }
          self->took_ = std::chrono::steady_clock::now();
          self->waiting_bytes_ -= size;
          self->lines_.pop_front();
          if (!self->lines_.empty()) {
            self->write_next();
          } else {
            self->close_where_over();
          }
        });
  }
  // NOLINTEND(misc-no-recursion)

  boost::asio::posix::stream_descriptor in_;
  std::optional<boost::asio::posix::stream_descriptor> out_;
  OnLine on_line_;
  std::string text_;
  bool is_too_long_ = false;
  std::deque<std::string> lines_;
  std::size_t waiting_bytes_ = 0;
  std::chrono::steady_clock::time_point took_{};  // a line of what waited, last
  int unanswered_ = 0;
  bool is_open_ = true;
  bool reads_ = true;
};

}  // namespace kerf::program
