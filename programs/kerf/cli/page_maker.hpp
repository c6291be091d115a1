// What `kerf report` and `kerf view` do beside running programs: the page.
#pragma once

#include <filesystem>
#include <string>
#include <utility>

#include <kerf/machine.hpp>
#include <tl/expected.hpp>

#include "programs/kerf/options.hpp"
#include "programs/kerf/page/page_file.hpp"
#include "programs/kerf/page/plan_gatherer.hpp"
#include "programs/kerf/report/report.hpp"

namespace kerf::program {

class PageMaker {
 public:
  // Call it before anything runs, so that what cannot be written is known by then. Error: a
  // sentence.
  static tl::expected<PageMaker, std::string> open(const Options& options);

  // A program that could be read stands in the page, whether it runs or not.
  void add(const FileReport& report, const MachineSettings& settings, const PageRecord& record);
  // Writes the page, says where it is, and shows that of `kerf view`.
  ExitStatus finish();

 private:
  // Of `kerf view`. It stays with a page in it: the browser reads that when it likes.
  class Folder {
   public:
    Folder() = default;
    explicit Folder(std::filesystem::path path) noexcept : path_(std::move(path)) {}
    ~Folder();
    Folder(Folder&& other) noexcept : path_(std::exchange(other.path_, {})) {}
    Folder& operator=(Folder&& other) noexcept {
      path_.swap(other.path_);
      return *this;
    }

   private:
    std::filesystem::path path_{};  // empty: there is none
  };
  PageMaker(Folder folder, PageFile file, const Options& options)
      : folder_(std::move(folder)), file_(std::move(file)), options_(&options) {}

  Folder folder_;  // before the file, which goes first
  PageFile file_;
  const Options* options_;
  bool has_source_ = false;
};

}  // namespace kerf::program
