#include <memory>

#include <kerf/controller.hpp>

#include "control/controller_impl.hpp"

namespace kerf {

Controller::Controller(const MachineSettings& settings, const KernelOptions& options)
    : impl_(std::make_unique<Impl>(settings, options).release()) {}
Controller::~Controller() {
  delete impl_;
}

tl::expected<void, Refusal> Controller::give(Command command) {
  return impl_->give(command);
}
tl::expected<void, Refusal> Controller::set_overrides(const Overrides& overrides) {
  return impl_->set_overrides(overrides);
}
tl::expected<void, Refusal> Controller::set_single_block(bool on) {
  return impl_->set_single_block(on);
}
tl::expected<void, Refusal> Controller::set_optional_stop(bool on) {
  return impl_->set_optional_stop(on);
}
bool Controller::set_feed_inputs(const FeedInputs& inputs) {
  return impl_->set_feed_inputs(inputs);
}
tl::expected<void, Refusal> Controller::set_block_delete(const BlockDelete& switches) {
  return impl_->set_block_delete(switches);
}
tl::expected<void, Refusal> Controller::run_mdi(std::string_view line) {
  return impl_->run_mdi(line);
}
tl::expected<void, Refusal> Controller::jog(const Jog& jog) {
  return impl_->jog(jog);
}
tl::expected<void, Refusal> Controller::set_tool(const Tool& tool) {
  return impl_->set_tool(tool);
}
void Controller::set_nominal(const NominalTime& time) {
  impl_->set_nominal(time);
}
void Controller::feed(std::string_view text) {
  impl_->feed(text);
}
void Controller::finish() {
  impl_->finish();
}
bool Controller::plan() {
  return impl_->plan();
}
void Controller::text_is_late() {
  impl_->text_is_late();
}
const Kernel* Controller::program() const noexcept {
  return impl_->program();
}
ControllerState Controller::tick(Setpoint& setpoint) noexcept {
  return impl_->tick(setpoint);
}
void Controller::set_program_inputs(const ProgramInputs& inputs) noexcept {
  impl_->set_program_inputs(inputs);
}
TickDetail Controller::detail() const noexcept {
  return impl_->detail();
}
void Controller::set_home_switches(AxisSet closed) noexcept {
  impl_->set_home_switches(closed);
}
void Controller::set_door(bool is_open) noexcept {
  impl_->set_door(is_open);
}
bool Controller::has_new_place() const noexcept {
  return impl_->has_new_place();
}
void Controller::emergency_stop() noexcept {
  impl_->leave_for(ControllerState::emergency_stop);
}
void Controller::fail() noexcept {
  impl_->leave_for(ControllerState::fault);
}
bool Controller::drives_on() const noexcept {
  return impl_->drives_on();
}
AxisSet Controller::unhomed() const noexcept {
  return impl_->unhomed();
}
WaitsFor Controller::waits_for() const noexcept {
  return impl_->waits_for();
}
ControllerStatus Controller::status() const noexcept {
  return impl_->status();
}
std::size_t Controller::events_since(std::uint64_t number,
                                     std::span<ControllerEvent> events) const noexcept {
  return impl_->events().since(number, events);
}
std::optional<ProgramMessage> Controller::message(std::uint32_t number) const {
  return impl_->message(number);
}

}  // namespace kerf
