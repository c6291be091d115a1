#include "programs/kerf/page/page_file.hpp"

#include <array>
#include <cstdlib>
#include <fcntl.h>
#include <fstream>
#include <iterator>
#include <spawn.h>
#include <system_error>
#include <unistd.h>
#include <utility>
#include <vector>

#include <spdlog/fmt/fmt.h>

#include "programs/kerf/page/packed_text.hpp"
#include "programs/kerf/page/plan_document.hpp"

namespace kerf::program {

namespace {

namespace fs = std::filesystem;

constexpr const char* kTemplateName = "page.html";

// The build of the page leaves this where the plans go.
std::string mark_of_plans() {
  return fmt::format("<!-- plans of version {} -->", kPlanVersion);
}

std::vector<fs::path> usual_places() {
  std::error_code error;
  const fs::path folder = fs::read_symlink("/proc/self/exe", error).parent_path();
  return {folder / kTemplateName,
          (folder / ".." / "share" / "kerf" / kTemplateName).lexically_normal()};
}

std::optional<std::string> text_of_file(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  std::string text{std::istreambuf_iterator<char>(file), {}};
  return file && !text.empty() ? std::optional(std::move(text)) : std::nullopt;
}

}  // namespace

tl::expected<PageTemplate, std::string> read_page_template(
    const std::optional<std::string>& asked_for) {
  const std::vector<fs::path> places =
      asked_for ? std::vector<fs::path>{*asked_for} : usual_places();
  for (const fs::path& place : places) {
    if (auto text = text_of_file(place)) {
      return PageTemplate{.text = *std::move(text), .path = place.string()};
    }
  }
  if (asked_for) {
    return tl::unexpected(*asked_for + ": the page cannot be read");
  }
  return tl::unexpected(
      fmt::format("the page without data is neither {} nor {}; ./kerf report and ./kerf view of a "
                  "checkout build it, --page names another one",
                  places[0].string(), places[1].string()));
}

tl::expected<PageFile, std::string> PageFile::create(const std::string& path,
                                                     PageTemplate page_template) {
  const std::size_t head = page_template.text.find(mark_of_plans());
  if (head == std::string::npos) {
    return tl::unexpected(fmt::format(
        "the page without data is of another version of kerf; this one needs {}", kPlanVersion));
  }
  std::error_code error;
  if (fs::equivalent(path, page_template.path, error)) {
    return tl::unexpected(path + " is the page without data: it is not to be written over");
  }
  auto file = OutputFile::create(path);
  if (!file) {
    return tl::unexpected(file.error());
  }
  return PageFile(*std::move(file), std::move(page_template.text), head);
}

void PageFile::write(std::string_view text) {
  if (error_ == 0) {
    error_ = file_.write(text);
    bytes_ += text.size();
  }
}

void PageFile::add(std::string_view plan) {
  if (!has_plans()) {
    write(std::string_view(template_).substr(0, head_bytes_));
  }
  // No byte of the program is here as it is: base64 has neither '<' nor quotes.
  write("<script type=\"application/x-kerf-plan\">");
  write(base64(deflated(plan)));
  write("</script>\n");
}

std::optional<std::string> PageFile::finish(bool is_whole) {
  if (!has_plans()) {
    return std::nullopt;
  }
  write(std::string_view(template_).substr(head_bytes_));
  const int closing = file_.finish(error_ == 0 && is_whole);
  error_ = error_ == 0 ? closing : error_;
  if (error_ == 0) {
    return std::nullopt;
  }
  return file_.name() + ": " + error_text(error_) + "; the page is incomplete" + file_.remains();
}

bool open_in_browser(const std::filesystem::path& page) {
  if (std::getenv("DISPLAY") == nullptr && std::getenv("WAYLAND_DISPLAY") == nullptr) {
    return false;
  }
  posix_spawn_file_actions_t quiet{};
  ::posix_spawn_file_actions_init(&quiet);
  for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
    ::posix_spawn_file_actions_addopen(&quiet, stream, "/dev/null", O_RDWR, 0);
  }
  std::string opener = "xdg-open";
  std::string file = page.string();
  const std::array<char*, 3> words{opener.data(), file.data(), nullptr};
  pid_t process = 0;
  const int error =
      ::posix_spawnp(&process, opener.c_str(), &quiet, nullptr, words.data(), environ);
  ::posix_spawn_file_actions_destroy(&quiet);
  return error == 0;
}

}  // namespace kerf::program
