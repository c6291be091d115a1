#include "programs/kerf/run/journal.hpp"

#include <algorithm>
#include <array>
#include <cerrno>
#include <fcntl.h>
#include <unistd.h>
#include <utility>

#include <nlohmann/json.hpp>
#include <spdlog/fmt/fmt.h>

#include "programs/kerf/io/checksum.hpp"

namespace kerf::program {

namespace {

using Json = nlohmann::json;

constexpr int kVersion = 1;
constexpr std::size_t kChecksumDigits = 16;

// "0123456789abcdef {...}\n"
std::string line_of(const Json& record) {
  const std::string text = record.dump(-1, ' ', true, Json::error_handler_t::replace);
  Checksum checksum;
  checksum.add(text);
  return fmt::format("{:0{}x} {}\n", checksum.value(), kChecksumDigits, text);
}

// Nothing: the line is not what was written. `line` is without its end.
std::optional<Json> record_of(std::string_view line) {
  if (line.size() <= kChecksumDigits) {
    return std::nullopt;
  }
  Checksum checksum;
  checksum.add(line.substr(kChecksumDigits + 1));
  if (line.substr(0, kChecksumDigits + 1) !=
      fmt::format("{:0{}x} ", checksum.value(), kChecksumDigits)) {
    return std::nullopt;
  }
  Json record = Json::parse(line.substr(kChecksumDigits + 1), nullptr, false);
  return record.is_object() ? std::optional(std::move(record)) : std::nullopt;
}

Json json_of(const JournalledRun& run) {
  return {{"record", "begin"},      {"version", kVersion},    {"file", run.file},
          {"program", run.program}, {"machine", run.machine}, {"blocks_before", run.blocks_before}};
}

JournalledRun run_of(const Json& record) {
  return {.file = record.at("file"),
          .program = record.at("program"),
          .machine = record.at("machine"),
          .blocks_before = record.at("blocks_before")};
}

JournalledPlace place_of(const Json& record) {
  return {.block = record.at("block"),
          .line = record.at("line"),
          .run_s = record.at("run_s"),
          .position_mm = record.at("position_mm"),
          .state = record.at("state")};
}

bool is_on_path(std::string_view state) {
  using State = ControllerState;
  return std::ranges::any_of(
      std::array{State::running, State::waiting, State::holding, State::stopping},
      [state](State on_path) { return name_of(on_path) == state; });
}

// False: it is of another version, or of nothing that is known.
bool take(const Json& record, std::optional<Journal>& journal) {
  try {
    const std::string kind = record.at("record");
    if (kind == "begin" && record.at("version") == kVersion) {
      journal = Journal{.run = run_of(record)};
    } else if (kind == "place" && journal) {
      journal->place = place_of(record);
      journal->on_path = is_on_path(journal->place->state) ? journal->place : journal->on_path;
    } else if (kind == "change" && journal) {
      journal->change = record.at("what");
    } else if (kind == "end" && journal) {
      journal->exit_status = record.at("exit_status").get<int>();
    } else {
      return false;
    }
  } catch (const Json::exception&) {
    return false;
  }
  return true;
}

}  // namespace

tl::expected<Journal, std::string> read_journal(std::string_view bytes) {
  std::optional<Journal> journal;
  std::size_t valid = 0;
  for (std::size_t end = bytes.find('\n'); end != std::string_view::npos;
       end = bytes.find('\n', valid)) {
    const auto record = record_of(bytes.substr(valid, end - valid));
    if (!record || !take(*record, journal)) {
      break;
    }
    valid = end + 1;
  }
  if (!journal) {
    return tl::unexpected(std::string("no run is in it"));
  }
  journal->valid_bytes = valid;
  return *journal;
}

tl::expected<Journal, std::string> read_journal_file(const std::string& path) {
  const auto file = open_regular(path);
  if (!file) {
    return tl::unexpected(path + ": " + file.error());
  }
  std::string bytes;
  std::array<char, 65'536> buffer{};
  for (;;) {
    const ssize_t count = ::read(file->number(), buffer.data(), buffer.size());
    if (count > 0) {
      bytes.append(buffer.data(), static_cast<std::size_t>(count));
    } else if (count == 0) {
      break;
    } else if (errno != EINTR) {
      return tl::unexpected(path + ": " + error_text(errno));
    }
  }
  return read_journal(bytes).map_error([&](const std::string& why) { return path + ": " + why; });
}

tl::expected<JournalWriter, std::string> JournalWriter::open(const std::string& path,
                                                             const JournalledRun& run,
                                                             std::size_t valid_bytes) {
  const auto fault = [&path](int error) { return tl::unexpected(path + ": " + error_text(error)); };
  // Not to wait for the reader of a FIFO, which is refused.
  Descriptor descriptor(
      ::open(path.c_str(), O_WRONLY | O_CREAT | O_CLOEXEC | O_NOCTTY | O_NONBLOCK, 0666));
  if (!descriptor.is_open()) {
    return fault(errno);
  }
  if (::ftruncate(descriptor.number(), static_cast<off_t>(valid_bytes)) != 0 ||
      ::lseek(descriptor.number(), 0, SEEK_END) < 0) {
    return fault(errno);
  }
  JournalWriter writer(std::move(descriptor));
  if (const int error = writer.write(line_of(json_of(run)))) {
    return fault(error);
  }
  return writer;
}

int JournalWriter::place(const JournalledPlace& place) {
  return write(line_of({{"record", "place"},
                        {"block", place.block},
                        {"line", place.line},
                        {"run_s", place.run_s},
                        {"position_mm", place.position_mm},
                        {"state", place.state}}));
}

int JournalWriter::change(std::string_view what) {
  return write(line_of({{"record", "change"}, {"what", what}}));
}

int JournalWriter::end(ExitStatus status) {
  return write(line_of({{"record", "end"}, {"exit_status", to_int(status)}}));
}

int JournalWriter::write(const std::string& record) {
  if (error_ == 0) {
    error_ = write_all(descriptor_.number(), record);
  }
  if (error_ == 0 && ::fdatasync(descriptor_.number()) != 0) {
    error_ = errno;
  }
  return error_;
}

}  // namespace kerf::program
