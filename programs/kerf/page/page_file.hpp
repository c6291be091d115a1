// The page that is written: the page without data, and the plans in it.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include <tl/expected.hpp>

#include "programs/kerf/io/output_file.hpp"

namespace kerf::program {

// The page without data.
struct PageTemplate {
  std::string text;
  std::string path;
};

// The one that was asked for, else page.html beside the executable, else
// that of the installation. Error: what to do.
[[nodiscard]] tl::expected<PageTemplate, std::string> read_page_template(
    const std::optional<std::string>& asked_for);

// A page without data as its two halves: plans stand between them.
class PageFile {
 public:
  // Error: what the system says, or that the page is of another version.
  static tl::expected<PageFile, std::string> create(const std::string& path,
                                                    PageTemplate page_template);

  // A plan_document(). Of the first error nothing more is written.
  void add(std::string_view plan);
  // is_whole: all plans are there. Error: why the page is not whole.
  std::optional<std::string> finish(bool is_whole);

  [[nodiscard]] std::uint64_t bytes() const noexcept { return bytes_; }
  [[nodiscard]] bool has_plans() const noexcept { return bytes_ > 0; }
  [[nodiscard]] const std::string& name() const noexcept { return file_.name(); }

 private:
  PageFile(OutputFile file, std::string page_template, std::size_t head_bytes)
      : file_(std::move(file)), template_(std::move(page_template)), head_bytes_(head_bytes) {}
  void write(std::string_view text);

  OutputFile file_;
  std::string template_;
  std::size_t head_bytes_;
  std::uint64_t bytes_ = 0;
  int error_ = 0;
};

// Opens a page in the desktop's browser and does not wait for it. False: there is no desktop.
bool open_in_browser(const std::filesystem::path& page);

}  // namespace kerf::program
