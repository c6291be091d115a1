// A file that a run writes: it gets its name once it is whole.
#pragma once

#include <string>
#include <string_view>

#include <tl/expected.hpp>

#include "programs/kerf/io/descriptor.hpp"

namespace kerf::program {

// What a regular file is called until it is whole.
std::string incomplete_name(const std::string& path);

// Until then it is called NAME.incomplete, whatever ends the process. With its first bytes a NAME
// of an earlier run is removed. What is no regular file (a pipe, a device) is written as it is.
// Where nothing was written and finish() was not called, nothing is left.
class OutputFile {
 public:
  // path "-" is standard output. Error: what the system says, with the path.
  static tl::expected<OutputFile, std::string> create(const std::string& path);
  ~OutputFile();
  OutputFile(OutputFile&& other) noexcept = default;
  OutputFile& operator=(OutputFile&& other) = delete;

  // The first bytes take the place of an older FILE. 0, or the errno.
  int write(std::string_view bytes) noexcept;
  // In place of the first bytes, which were written before; of a regular file. 0, or the errno.
  int write_again(std::string_view bytes) noexcept;
  // Nothing more is written. whole: all is there, so that it may have its name. 0, or the errno.
  int finish(bool whole) noexcept;

  // An earlier run left FILE.incomplete, which this one has replaced: it was killed or failed.
  [[nodiscard]] bool follows_incomplete() const noexcept { return follows_incomplete_; }
  // The name for messages.
  [[nodiscard]] const std::string& name() const noexcept { return name_; }
  [[nodiscard]] bool is_standard_output() const noexcept { return name_ == "<stdout>"; }
  // For messages, if the file did not get its name: "; what was written is in FILE.incomplete".
  [[nodiscard]] std::string remains() const;

 private:
  OutputFile(std::string name, Descriptor descriptor)
      : name_(std::move(name)), descriptor_(std::move(descriptor)) {}

  std::string name_;
  Descriptor descriptor_;
  std::string final_path_;  // empty: it has its name
  bool written_ = false;
  bool follows_incomplete_ = false;
};

}  // namespace kerf::program
