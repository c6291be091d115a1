#include <memory>
#include <utility>

#include <kerf/kernel.hpp>
#include <kerf/machine.hpp>

#include "kernel/kernel_impl.hpp"
#include "kernel/settings_check.hpp"

namespace kerf {

using diagnostics::Diagnostic;

Kernel::Kernel(const MachineSettings& settings, const KernelOptions& options) {
  if (auto fault = settings_fault(settings, options)) {
    auto resting = std::make_unique<Impl>(default_machine(), resting_options(options));
    resting->refuse(std::move(*fault));
    impl_ = resting.release();
  } else {
    impl_ = std::make_unique<Impl>(settings, options).release();
  }
}
Kernel::~Kernel() {
  delete impl_;
}
Kernel::Kernel(Kernel&& other) noexcept : impl_(std::exchange(other.impl_, nullptr)) {}
Kernel& Kernel::operator=(Kernel&& other) noexcept {
  std::swap(impl_, other.impl_);
  return *this;
}

void Kernel::feed(std::string_view text) {
  impl_->feed(text);
}
void Kernel::finish() {
  impl_->finish();
}
bool Kernel::plan() {
  return impl_->plan();
}
ReadStatus Kernel::read() {
  return impl_->read();
}
TickStatus Kernel::tick(Setpoint& setpoint) noexcept {
  return impl_->tick(setpoint);
}

TickStatus Kernel::next(Setpoint& setpoint) {
  return impl_->next(setpoint);
}

void Kernel::reach_tick() {
  impl_->reach_tick();
}
bool Kernel::needs_plan() noexcept {
  return impl_->needs_plan();
}
void Kernel::make_room() noexcept {
  impl_->make_room();
}
void Kernel::plan_to_rest() {
  impl_->plan_to_rest();
}
bool Kernel::runs_low() const noexcept {
  return impl_->runs_low();
}
void Kernel::stop() {
  impl_->stop();
}
void Kernel::emergency_stop() noexcept {
  impl_->emergency_stop();
}
void Kernel::hold() {
  impl_->hold();
}
void Kernel::resume() {
  impl_->resume();
}
bool Kernel::set_overrides(const Overrides& overrides) {
  return impl_->set_overrides(overrides);
}
bool Kernel::set_feed_inputs(const FeedInputs& inputs) {
  return impl_->set_feed_inputs(inputs);
}
bool Kernel::set_tool(const Tool& tool) {
  return impl_->set_tool(tool);
}
bool Kernel::start_counts_on_tools() const {
  return impl_->start_counts_on_tools();
}
void Kernel::set_program_inputs(const ProgramInputs& inputs) noexcept {
  impl_->set_program_inputs(inputs);
}
bool Kernel::asks_machine() noexcept {
  return impl_->asks_machine();
}
void Kernel::set_single_block(bool on) {
  impl_->set_single_block(on);
}
void Kernel::set_optional_stop(bool on) {
  impl_->set_optional_stop(on);
}
void Kernel::set_block_delete(const BlockDelete& switches) {
  impl_->set_block_delete(switches);
}
std::vector<ProgramMessage> Kernel::take_messages() {
  return impl_->notes().take_messages();
}
std::string_view Kernel::active_codes() const noexcept {
  return impl_->notes().codes();
}
std::string_view Kernel::active_words() const noexcept {
  return impl_->notes().words();
}
std::optional<double> Kernel::left_s() const {
  return impl_->notes().time_left().left_s();
}
ProgramState Kernel::state_left() const {
  return impl_->state_left();
}
double Kernel::chord_error_mm() const noexcept {
  return impl_->judge().latest_chord_error_mm();
}
TickDetail Kernel::detail() const noexcept {
  return impl_->detail();
}
std::optional<RunFault> Kernel::fault() const {
  return impl_->fault();
}
bool Kernel::has_fault() const noexcept {
  return impl_->has_fault();
}
RunFigures Kernel::figures() const noexcept {
  return impl_->judge().figures();
}
std::vector<PathControlUse> Kernel::path_controls() const {
  return impl_->path_controls();
}

smoothing::PathDeviation Kernel::deviation() const noexcept {
  return impl_->deviation();
}
bool Kernel::left_travel() const noexcept {
  return impl_->left_travel();
}
bool Kernel::has_errors() const {
  return impl_->has_errors();
}
const std::vector<Diagnostic>& Kernel::diagnostics() const {
  return impl_->diagnostics();
}
const PlanWaits& Kernel::waits() const noexcept {
  return impl_->waits();
}
const PlanTotals& Kernel::totals() const {
  return impl_->totals();
}

}  // namespace kerf
