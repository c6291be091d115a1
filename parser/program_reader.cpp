#include "parser/program_reader.hpp"

#include <utility>

#include "parser/reader/program_run.hpp"

namespace kerf::parser {

ProgramReader::ProgramReader(ReaderOptions options)
    : run_(std::make_unique<ProgramRun>(std::move(options))) {}
ProgramReader::~ProgramReader() = default;
ProgramReader::ProgramReader(ProgramReader&&) noexcept = default;
ProgramReader& ProgramReader::operator=(ProgramReader&&) noexcept = default;

void ProgramReader::feed(std::string_view bytes) {
  run_->input().feed(bytes);
}
void ProgramReader::finish() {
  run_->input().finish();
}
void ProgramReader::set_block_delete(const BlockDelete& switches) {
  run_->set_block_delete(switches);
}
void ProgramReader::set_tool(const Tool& tool) {
  run_->set_tool(tool);
}
bool ProgramReader::next(Move& move) {
  return run_->next(move);
}
const std::optional<MachineQuestion>& ProgramReader::question() const {
  return run_->question();
}
void ProgramReader::answer(const MachineAnswer& answer) {
  run_->answer(answer);
}
const std::vector<NumberedMessage>& ProgramReader::messages() const {
  return run_->messages();
}
const ModalState& ProgramReader::modal_state() const {
  return run_->modal_state();
}
ReaderState ProgramReader::state_left(const std::optional<ModalState>& modal) const {
  return run_->state_left(modal);
}
std::uint64_t ProgramReader::blocks_read() const {
  return run_->blocks_run();
}
bool ProgramReader::at_end() const {
  return run_->at_end();
}
bool ProgramReader::has_errors() const {
  return run_->has_errors();
}
std::size_t ProgramReader::held_bytes() const {
  return run_->held_bytes();
}
std::string_view ProgramReader::file_name(std::uint16_t file) const {
  return run_->file_name(file);
}
const std::vector<diagnostics::Diagnostic>& ProgramReader::diagnostics() const {
  return run_->diagnostics().all();
}

}  // namespace kerf::parser
