#include "parser/program_reader.hpp"

#include <utility>

#include "parser/program_reader_impl.hpp"

namespace kerf::parser {

ProgramReader::ProgramReader(ReaderOptions options)
    : impl_(std::make_unique<Impl>(std::move(options))) {}
ProgramReader::~ProgramReader() = default;
ProgramReader::ProgramReader(ProgramReader&&) noexcept = default;
ProgramReader& ProgramReader::operator=(ProgramReader&&) noexcept = default;

void ProgramReader::feed(std::string_view bytes) {
  impl_->input().feed(bytes);
}
void ProgramReader::finish() {
  impl_->input().finish();
}
bool ProgramReader::next(Move& move) {
  return impl_->next(move);
}
bool ProgramReader::at_end() const {
  return impl_->at_end();
}
const std::optional<WatchedBlock>& ProgramReader::watched_block() const {
  return impl_->watched_block();
}
bool ProgramReader::has_errors() const {
  return impl_->diagnostics().has_errors();
}
std::size_t ProgramReader::held_bytes() const {
  return impl_->held_bytes();
}
std::string_view ProgramReader::file_name(std::uint16_t file) const {
  return impl_->file_name(file);
}
const std::vector<Diagnostic>& ProgramReader::diagnostics() const {
  return impl_->diagnostics().all();
}

}  // namespace kerf::parser
