#include <array>

#include <kerf/controller.hpp>

namespace kerf {

namespace {

using State = ControllerState;

constexpr std::string_view kOff = "the drives are off: enable first";
constexpr std::string_view kOn = "the drives are on";
constexpr std::string_view kNoProgram = "no program runs";
constexpr std::string_view kProgram = "a program runs: stop it first";
constexpr std::string_view kProgramMoves = "a program runs: hold it first";
constexpr std::string_view kNotHeld = "it is not held";
constexpr std::string_view kStopping = "it is stopping";
constexpr std::string_view kEmergency = "emergency stop: reset first";
constexpr std::string_view kFault = "fault: reset first";
constexpr std::string_view kNothing = "there is nothing to reset";
constexpr std::string_view kJogs = "it jogs: stop it first";
constexpr std::string_view kReturns = "it goes back: hold it first";
constexpr std::string_view kHomes = "it homes: stop it first";

constexpr Answer go(State next) {
  return {.next = next};
}
constexpr Answer refuse(std::string_view why) {
  return {.refusal = why};
}

using Row = std::array<Answer, kCommands>;
// A row a state: enable, disable, start, hold, resume, stop, emergency stop, reset,
// override, single block, optional stop, block delete, mdi, jog, home.
constexpr std::array<Row, kControllerStates> kTable{{
    // off
    {go(State::idle), refuse(kOff), refuse(kOff), refuse(kOff), refuse(kOff), refuse(kOff),
     go(State::emergency_stop), refuse(kNothing), go(State::off), go(State::off), go(State::off),
     go(State::off), refuse(kOff), refuse(kOff), refuse(kOff)},
    // emergency_stop
    {refuse(kEmergency), refuse(kEmergency), refuse(kEmergency), refuse(kEmergency),
     refuse(kEmergency), refuse(kEmergency), go(State::emergency_stop), go(State::off),
     go(State::emergency_stop), go(State::emergency_stop), go(State::emergency_stop),
     go(State::emergency_stop), refuse(kEmergency), refuse(kEmergency), refuse(kEmergency)},
    // idle
    {refuse(kOn), go(State::off), go(State::running), refuse(kNoProgram), refuse(kNoProgram),
     refuse(kNoProgram), go(State::emergency_stop), refuse(kNothing), go(State::idle),
     go(State::idle), go(State::idle), go(State::idle), go(State::running), go(State::jogging),
     go(State::homing)},
    // running
    {refuse(kOn), refuse(kProgram), refuse(kProgram), go(State::holding), refuse(kNotHeld),
     go(State::stopping), go(State::emergency_stop), refuse(kProgram), go(State::running),
     go(State::running), go(State::running), go(State::running), refuse(kProgram),
     refuse(kProgramMoves), refuse(kProgram)},
    // waiting
    {refuse(kOn), refuse(kProgram), refuse(kProgram), go(State::holding), go(State::running),
     go(State::stopping), go(State::emergency_stop), refuse(kProgram), go(State::waiting),
     go(State::waiting), go(State::waiting), go(State::waiting), refuse(kProgram),
     refuse(kProgramMoves), refuse(kProgram)},
    // holding
    {refuse(kOn), refuse(kProgram), refuse(kProgram), go(State::holding), go(State::running),
     go(State::stopping), go(State::emergency_stop), refuse(kProgram), go(State::holding),
     go(State::holding), go(State::holding), go(State::holding), refuse(kProgram),
     refuse(kProgramMoves), refuse(kProgram)},
    // held
    {refuse(kOn), refuse(kProgram), refuse(kProgram), go(State::held), go(State::running),
     go(State::stopping), go(State::emergency_stop), refuse(kProgram), go(State::held),
     go(State::held), go(State::held), go(State::held), refuse(kProgram), go(State::jogging),
     refuse(kProgram)},
    // stopping
    {refuse(kOn), refuse(kStopping), refuse(kStopping), refuse(kStopping), refuse(kStopping),
     go(State::stopping), go(State::emergency_stop), refuse(kStopping), go(State::stopping),
     go(State::stopping), go(State::stopping), go(State::stopping), refuse(kStopping),
     refuse(kStopping), refuse(kStopping)},
    // fault
    {refuse(kFault), refuse(kFault), refuse(kFault), refuse(kFault), refuse(kFault), refuse(kFault),
     go(State::emergency_stop), go(State::off), go(State::fault), go(State::fault),
     go(State::fault), go(State::fault), refuse(kFault), refuse(kFault), refuse(kFault)},
    // jogging
    {refuse(kOn), refuse(kJogs), refuse(kJogs), go(State::jogging), refuse(kJogs),
     go(State::jogging), go(State::emergency_stop), refuse(kJogs), go(State::jogging),
     go(State::jogging), go(State::jogging), go(State::jogging), refuse(kJogs), go(State::jogging),
     refuse(kJogs)},
    // returning
    {refuse(kOn), refuse(kReturns), refuse(kReturns), go(State::returning), refuse(kReturns),
     go(State::returning), go(State::emergency_stop), refuse(kReturns), go(State::returning),
     go(State::returning), go(State::returning), go(State::returning), refuse(kReturns),
     refuse(kReturns), refuse(kReturns)},
    // homing
    {refuse(kOn), refuse(kHomes), refuse(kHomes), refuse(kHomes), refuse(kHomes), go(State::homing),
     go(State::emergency_stop), refuse(kHomes), go(State::homing), go(State::homing),
     go(State::homing), go(State::homing), refuse(kHomes), refuse(kHomes), refuse(kHomes)},
}};

constexpr std::array<std::string_view, kControllerStates> kStateNames{
    "off",  "emergency stop", "idle",  "running", "waiting",   "holding",
    "held", "stopping",       "fault", "jogging", "returning", "homing"};
constexpr std::array<std::string_view, kCommands> kCommandNames{
    "enable",        "disable",        "start", "hold",     "resume",
    "stop",          "emergency stop", "reset", "override", "single block",
    "optional stop", "block delete",   "mdi",   "jog",      "home"};
constexpr std::array<std::string_view, 7> kCauseNames{
    "none", "program stop", "optional stop", "pallet change", "tool change", "block end", "start"};
constexpr std::array<std::string_view, 5> kWaitNames{"nothing", "answer", "text", "planning",
                                                     "machine"};

}  // namespace

inline namespace v0 {

Answer answer_to(ControllerState state, Command command) noexcept {
  Answer answer = kTable[static_cast<std::size_t>(state)][static_cast<std::size_t>(command)];
  if (!answer.is_accepted()) {
    answer.next = state;
  }
  return answer;
}

std::string_view name_of(ControllerState state) noexcept {
  return kStateNames[static_cast<std::size_t>(state)];
}
std::string_view name_of(Command command) noexcept {
  return kCommandNames[static_cast<std::size_t>(command)];
}
std::string_view name_of(WaitsFor what) noexcept {
  return kWaitNames[static_cast<std::size_t>(what)];
}
std::string_view name_of(WaitCause cause) noexcept {
  return kCauseNames[static_cast<std::size_t>(cause)];
}

}  // namespace v0
}  // namespace kerf
