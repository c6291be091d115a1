#include "programs/kerf/cli/page_maker.hpp"

#include <cerrno>
#include <cstdlib>
#include <filesystem>
#include <utility>

#include <spdlog/fmt/fmt.h>
#include <spdlog/spdlog.h>

#include "programs/kerf/io/descriptor.hpp"
#include "programs/kerf/io/interrupt.hpp"
#include "programs/kerf/io/log.hpp"
#include "programs/kerf/io/visible_text.hpp"
#include "programs/kerf/page/plan_document.hpp"

namespace kerf::program {

namespace {

namespace fs = std::filesystem;

tl::expected<fs::path, std::string> temporary_folder() {
  std::error_code error;
  std::string folder = (fs::temp_directory_path(error) / "kerf-XXXXXX").string();
  if (error || ::mkdtemp(folder.data()) == nullptr) {
    return tl::unexpected(folder + ": " + error_text(error ? error.value() : errno));
  }
  return folder;
}

std::string page_name(const std::string& program) {
  const std::string stem = fs::path(program).stem().string();
  return (program == "-" || stem.empty() ? "program" : stem) + ".html";
}

}  // namespace

PageMaker::Folder::~Folder() {
  std::error_code is_not_empty;
  fs::remove(path_, is_not_empty);
}

tl::expected<PageMaker, std::string> PageMaker::open(const Options& options) {
  auto page_template = read_page_template(options.page_template);
  if (!page_template) {
    return tl::unexpected(page_template.error());
  }
  std::string path = options.page_file;
  Folder folder;
  if (options.command == Subcommand::view) {
    auto made = temporary_folder();
    if (!made) {
      return tl::unexpected(made.error());
    }
    path = (*made / page_name(options.files.front())).string();
    folder = Folder(*std::move(made));
  }
  auto file = PageFile::create(path, *std::move(page_template));
  if (!file) {
    return tl::unexpected(file.error());
  }
  return PageMaker(std::move(folder), *std::move(file), options);
}

void PageMaker::add(const FileReport& report, const MachineSettings& settings,
                    const PageRecord& record) {
  // What cannot be read has nothing to show; errors show without the program's text, too.
  if (record.source || record.motion || report.status != ExitStatus::io_error) {
    file_.add(plan_document(report, settings, record));
    has_source_ = has_source_ || record.source.has_value();
  }
}

ExitStatus PageMaker::finish() {
  if (const auto error = file_.finish(!stop_requested())) {
    spdlog::error("{}", visible(*error));
    return ExitStatus::io_error;
  }
  if (!file_.has_plans() || stop_requested()) {
    return ExitStatus::done;
  }
  const bool shown = options_->command == Subcommand::view && open_in_browser(file_.name());
  if (!options_->quiet || (options_->command == Subcommand::view && !shown)) {
    write_error_line(fmt::format("{}: {:.2f} MB, {} the program's text", visible(file_.name()),
                                 static_cast<double>(file_.bytes()) / 1e6,
                                 has_source_ ? "with" : "without"));
  }
  return ExitStatus::done;
}

}  // namespace kerf::program
