#include "programs/kerf/driver/machine_record.hpp"

#include <cerrno>
#include <chrono>
#include <cstring>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include <boost/crc.hpp>
#include <spdlog/fmt/fmt.h>

#include "programs/kerf/io/number_text.hpp"

namespace kerf::program {

namespace {

constexpr std::array<char, 8> kHeadMark{'K', 'E', 'R', 'F', 'R', 'E', 'C', '1'};
constexpr std::array<char, 8> kEndMark{'K', 'E', 'R', 'F', 'E', 'N', 'D', '1'};

struct RecordHead {
  std::array<char, 8> mark = kHeadMark;
  double period_s = 0.0;
  std::uint64_t nothing = 0;
  std::uint64_t checksum = 0;  // of what stands before it
};
struct RecordEnd {
  std::array<char, 8> mark = kEndMark;
  std::uint64_t plan_bytes = 0;  // between the calls and this
  std::uint64_t calls = 0;
  std::uint64_t checksum = 0;  // of the plan's bytes and what stands before it here
};
static_assert(sizeof(RecordHead) == 32 && std::is_trivially_copyable_v<RecordHead>);
static_assert(sizeof(RecordEnd) == 32 && std::is_trivially_copyable_v<RecordEnd>);

template <typename Bound>
std::uint64_t checksum_of(const Bound& bound, std::string_view before = {}) noexcept {
  boost::crc_32_type sum;
  sum.process_bytes(before.data(), before.size());
  sum.process_bytes(&bound, offsetof(Bound, checksum));
  return sum.checksum();
}

template <typename T>
std::span<const std::byte> bytes_of(const T& value) noexcept {
  return std::as_bytes(std::span(&value, 1));
}

}  // namespace

tl::expected<std::unique_ptr<RecordWriter>, std::string> RecordWriter::create(
    const std::string& path, double period_s, WhenFull when_full) {
  auto file = OutputFile::create(path);
  if (!file) {
    return tl::unexpected(file.error());
  }
  std::unique_ptr<RecordWriter> writer(new RecordWriter(*std::move(file), period_s, when_full));
  writer->thread_ = std::thread([own = writer.get()] { own->work(); });
  return writer;
}

RecordWriter::RecordWriter(OutputFile file, double period_s, WhenFull when_full)
    : file_(std::move(file)), period_s_(period_s), when_full_(when_full) {}

RecordWriter::~RecordWriter() {
  join();
}

void RecordWriter::push(const RecordedCall& call) noexcept {
  while (!ring_->push(call)) {
    if (when_full_ == WhenFull::drop) {
      ++dropped_;
      return;
    }
    std::this_thread::yield();
  }
}

std::optional<std::string> RecordWriter::finish(std::string_view plan_record) {
  join();
  const bool is_whole = dropped_ == 0;
  if (is_whole) {
    write_head();
    RecordEnd end{.plan_bytes = plan_record.size(), .calls = written_};
    end.checksum = checksum_of(end, plan_record);
    write(std::as_bytes(std::span(plan_record.data(), plan_record.size())));
    write(bytes_of(end));
  }
  if (const int closing = file_.finish(is_whole && error_ == 0); error_ == 0) {
    error_ = closing;
  }
  if (error_ != 0) {
    return file_.name() + ": " + error_text(error_) + "; the record is incomplete" +
           file_.remains();
  }
  if (dropped_ > 0) {
    return "the record lacks " + counted(dropped_, "tick") + ": writing it was too slow" +
           file_.remains();
  }
  return std::nullopt;
}

void RecordWriter::join() noexcept {
  over_.store(true, std::memory_order_release);
  if (thread_.joinable()) {
    thread_.join();
  }
}

void RecordWriter::work() noexcept {
  for (bool last_round = false; !last_round;) {
    last_round = over_.load(std::memory_order_acquire);
    ring_->consume_all([this](const RecordedCall& call) {
      write_head();
      write(std::as_bytes(std::span(&call, 1)));
      ++written_;
    });
    if (!last_round) {
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
  }
}

// With the first call: a run that is refused before leaves an older record.
void RecordWriter::write_head() noexcept {
  if (std::exchange(has_head_, true)) {
    return;
  }
  RecordHead head{.period_s = period_s_};
  head.checksum = checksum_of(head);
  write(bytes_of(head));
}

void RecordWriter::write(std::span<const std::byte> bytes) noexcept {
  if (error_ == 0) {
    const void* const data = bytes.data();
    error_ = file_.write({static_cast<const char*>(data), bytes.size()});
  }
}

tl::expected<RecordReader, std::string> RecordReader::open(const std::string& path,
                                                           double period_s) {
  const auto refuse = [&path](const std::string& why) { return tl::unexpected(path + ": " + why); };
  const auto file = open_regular(path);
  if (!file) {
    return refuse(file.error());
  }
  struct stat about {};
  if (::fstat(file->number(), &about) != 0) {
    return refuse(error_text(errno));
  }
  const auto bytes = static_cast<std::size_t>(about.st_size);
  if (bytes < sizeof(RecordHead) + sizeof(RecordEnd)) {
    return refuse("no record of a machine, or a torn one");
  }
  void* const map =
      ::mmap(nullptr, bytes, PROT_READ, MAP_PRIVATE | MAP_POPULATE, file->number(), 0);
  if (map == MAP_FAILED) {
    return refuse(error_text(errno));
  }
  RecordReader reader(map, bytes);
  if (const auto why = reader.look(period_s)) {
    return refuse(*why);
  }
  return reader;
}

std::string RecordReader::plan_record_in(const std::string& path) {
  const auto file = open_regular(path);
  struct stat about {};
  RecordEnd end;
  if (!file || ::fstat(file->number(), &about) != 0 ||
      about.st_size < static_cast<off_t>(sizeof(RecordHead) + sizeof end)) {
    return {};
  }
  const auto at_end = about.st_size - static_cast<off_t>(sizeof end);
  const auto read = [&file](void* to, std::size_t bytes, off_t at) {
    return ::pread(file->number(), to, bytes, at) == static_cast<ssize_t>(bytes);
  };
  if (!read(&end, sizeof end, at_end) || end.mark != kEndMark ||
      end.plan_bytes > static_cast<std::uint64_t>(at_end)) {
    return {};
  }
  std::string plan(end.plan_bytes, '\0');
  const bool is_whole = read(plan.data(), plan.size(), at_end - static_cast<off_t>(plan.size())) &&
                        end.checksum == checksum_of(end, plan);
  return is_whole ? plan : std::string();
}

RecordReader::~RecordReader() {
  if (map_ != nullptr) {
    ::munmap(map_, bytes_);
  }
}

RecordReader::RecordReader(RecordReader&& other) noexcept
    : map_(std::exchange(other.map_, nullptr)),
      bytes_(other.bytes_),
      calls_(other.calls_),
      plan_record_(other.plan_record_) {}

std::optional<std::string> RecordReader::look(double period_s) {
  const auto* const at = static_cast<const std::byte*>(map_);
  RecordHead head;
  RecordEnd end;
  std::memcpy(&head, at, sizeof head);
  std::memcpy(&end, at + bytes_ - sizeof end, sizeof end);
  if (head.mark != kHeadMark || head.checksum != checksum_of(head)) {
    return "no record of a machine, or of another version of kerf";
  }
  const std::size_t between = bytes_ - sizeof head - sizeof end;
  const bool fits = end.mark == kEndMark && end.plan_bytes <= between &&
                    (between - end.plan_bytes) % sizeof(RecordedCall) == 0 &&
                    end.calls == (between - end.plan_bytes) / sizeof(RecordedCall);
  if (fits) {
    const void* const plan = at + sizeof head + (between - end.plan_bytes);
    plan_record_ = {static_cast<const char*>(plan), static_cast<std::size_t>(end.plan_bytes)};
  }
  if (!fits || end.checksum != checksum_of(end, plan_record_)) {
    return "the record is torn: its end is missing";
  }
  if (head.period_s != period_s) {
    return fmt::format("the record has a period of {} s, this machine {} s", head.period_s,
                       period_s);
  }
  const void* const calls = at + sizeof head;
  calls_ = {static_cast<const RecordedCall*>(calls), static_cast<std::size_t>(end.calls)};
  for (std::size_t i = 0; i < calls_.size(); ++i) {
    const auto told = told_from(calls_[i].told);
    const auto answer = answer_from(calls_[i].answer);
    if (!told || !answer || answer->tick != told->setpoint.tick) {
      return fmt::format("the record is damaged at its call {}", i + 1);
    }
  }
  return std::nullopt;
}

}  // namespace kerf::program
