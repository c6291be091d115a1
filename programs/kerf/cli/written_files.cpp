#include "programs/kerf/cli/written_files.hpp"

#include <algorithm>
#include <array>
#include <filesystem>
#include <span>
#include <system_error>

#include "programs/kerf/io/output_file.hpp"
#include "programs/kerf/io/subprogram_folder.hpp"

namespace kerf::program {

namespace {

// However they are named; also where they are not there yet. A device is no file.
bool are_one_file(const std::string& one, const std::string& other) {
  namespace fs = std::filesystem;
  std::error_code error;
  if (one.empty() || other.empty() || one == "-" || other == "-" ||
      (fs::exists(one, error) && !fs::is_regular_file(one, error))) {
    return false;
  }
  // What is not there at all stays relative otherwise.
  const auto whole = [&error](const std::string& name) {
    return fs::weakly_canonical(fs::absolute(name, error), error);
  };
  const fs::path path = whole(one);
  return fs::equivalent(one, other, error) || (!path.empty() && path == whole(other));
}

std::vector<std::string> read_files(const Options& options, const AlsoRead& also) {
  std::vector<std::string> read = options.files;
  read.insert(read.end(), options.machine_files.begin(), options.machine_files.end());
  read.insert(read.end(), also.files.begin(), also.files.end());
  for (const auto& file : {options.machine_file, options.tool_file, options.page_template}) {
    read.push_back(file.value_or(""));
  }
  read.push_back(options.replay_file);
  return read;
}

}  // namespace

std::optional<std::string> written_over(const Options& options, const AlsoRead& also) {
  const std::vector<std::string> read = read_files(options, also);
  const std::array written{options.trace_file.value_or(""),
                           options.plot_file.value_or(""),
                           options.flight_file.value_or(""),
                           options.log_file.value_or(""),
                           options.record_file,
                           options.journal_file,
                           options.page_file};
  for (std::size_t i = 0; i < written.size(); ++i) {
    const std::string& file = written[i];
    if (file.empty() || file == "-") {
      continue;
    }
    const auto is_it = [&](const std::string& other) { return are_one_file(file, other); };
    const auto is_it_at_first = [&](const std::string& other) {
      return are_one_file(incomplete_name(file), other);
    };
    if (std::ranges::any_of(read, is_it) || std::ranges::any_of(read, is_it_at_first)) {
      return file + " is read: it is not to be written over";
    }
    const auto may_call_it = [&](const std::string& program) {
      return program != "-" &&
             may_be_subprogram({.path = file, .program = program, .is_fanuc = also.is_fanuc});
    };
    if (std::ranges::any_of(options.files, may_call_it)) {
      return file + " may be a subprogram: it is not to be written over";
    }
    if (std::ranges::any_of(std::span(written).subspan(i + 1), is_it)) {
      return file + " would be written twice";
    }
  }
  return std::nullopt;
}

}  // namespace kerf::program
