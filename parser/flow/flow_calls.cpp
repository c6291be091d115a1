// Calls: where a subprogram is found, and the way in and back.
#include <algorithm>
#include <span>
#include <utility>

#include "diagnostics/errors/pages.hpp"
#include "parser/flow/flow.hpp"
#include "parser/flow/statement_reader.hpp"
#include "parser/flow/statement_text.hpp"
#include "parser/text/text.hpp"

namespace kerf::parser {

namespace {

bool is_number(std::string_view label) {
  return label.find_first_not_of("0123456789") == std::string_view::npos;
}

// As the caller wrote it, for messages.
std::string shown(const Call& call) {
  return call.kind == CallKind::sub     ? joined({"sub ", shown_label(call.label)})
         : call.kind == CallKind::local ? joined({"N", call.label})
         : is_number(call.label)        ? joined({"program O", call.label})
                                        : joined({"program <", call.label, ">"});
}

}  // namespace

Flow::Found Flow::find_in(ProgramText& text, const Call& call) {
  const LabelUse use = text.labels().find(call.label);
  const std::uint32_t statement = call.kind == CallKind::sub ? use.sub : use.program;
  return statement == 0 ? Found{} : Found{&text, text.statement(statement).line + 1};
}

ProgramText* Flow::load(const std::string& label) {
  if (const auto known = file_of_label_.find(label); known != file_of_label_.end()) {
    return known->second;
  }
  constexpr std::size_t kMaxFiles = 0xFFFF;
  ProgramText*& file = file_of_label_[label];
  if (!options_->subprograms || files_.size() == kMaxFiles) {
    return file;
  }
  auto source = options_->subprograms(label);
  if (!source) {
    return file;
  }
  if (!source->refused.empty()) {
    refused_files_.emplace(label, std::move(*source));
    return file;
  }
  constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";
  std::string_view bytes = source->text;
  if (bytes.substr(0, kByteOrderMark.size()) == kByteOrderMark) {
    bytes.remove_prefix(kByteOrderMark.size());
  }
  bytes = bytes.substr(0, bytes.find_last_not_of("\x1A\r\n \t") + 1);  // as a program may end
  files_.push_back(std::make_unique<ProgramText>(
      TextOrigin{.dialect = options_->dialect,
                 .file = static_cast<std::uint16_t>(files_.size() + 1),
                 .file_name = std::move(source->file)}));
  file = files_.back().get();
  LineSplitter lines;
  lines.feed(bytes);
  lines.finish();
  for (NumberedLine line; !file->closed() && lines.next(line);) {
    line.left_out = is_left_out(line.text, options_->block_delete);
    file->take(line);
  }
  file->close();
  report_faults(*file);
  return file;
}

Flow::Found Flow::find_in_file() {
  ProgramText* const file = load(call_.label);
  if (file == nullptr) {
    return {};
  }
  const Found found = find_in(*file, call_);
  // A file of a program may leave out its number.
  const bool whole = call_.kind != CallKind::sub && file->labels().find(call_.label).sub == 0;
  return found.text == nullptr && whole ? Found{file, 0} : found;
}

// M97: a block of the calling program.
Flow::Found Flow::find_local() {
  const SequenceNumber* const found = find_number();
  return found == nullptr ? Found{} : Found{text_, found->line};
}

// LinuxCNC looks into the text so far, then for a file, then ahead. For Fanuc a program of the same
// file goes before one of another.
bool Flow::find_and_enter() {
  const bool local = call_.kind == CallKind::local;
  Found found = local ? find_local() : find_in(*text_, call_);
  if (found.text == nullptr && !local) {
    found = find_in(*main_, call_);
  }
  if (found.text == nullptr && !local &&
      (!rules_of(options_->dialect).numbered_programs || main_->closed())) {
    found = find_in_file();
  }
  if (found.text == nullptr) {
    return false;
  }
  enter(found);
  return true;
}

void Flow::call_not_found() {
  const auto refuse = [&](const diagnostics::ErrorPage& page, std::string message) {
    fault(call_.line, call_.offset, page, std::move(message));
  };
  if (call_.kind == CallKind::local) {
    return target_not_found();
  }
  ProgramText* const file = load(call_.label);
  for (ProgramText* const text : {text_, main_.get(), file}) {
    const LabelUse use = text == nullptr ? LabelUse{} : text->labels().find(call_.label);
    if (use.sub != 0 || use.program != 0) {
      return refuse(
          errors::kWrongCall,
          use.sub != 0 ? joined({"O", call_.label, " begins with sub: call it with `o", call_.label,
                                 " call`"})
                       : joined({"O", call_.label, " is no sub: call it with M98 P", call_.label}));
    }
  }
  if (const auto found = refused_files_.find(call_.label); found != refused_files_.end()) {
    const SubprogramText& why = found->second;
    return refuse(errors::kSubRefused,
                  joined({shown(call_), ": ", why.file, " is not read: ", why.refused}));
  }
  refuse(errors::kSubNotFound,
         joined({shown(call_), " is not found",
                 file != nullptr ? joined({": ", file->origin().file_name, " does not define it"})
                 : forgotten_    ? ": the text before it was not kept"
                                 : ""}));
}

void Flow::call(Call call) {
  keeping_ = false;
  call_ = std::move(call);
  call_.line = current_;
  if (call_.kind == CallKind::local) {
    target_ = {.number = static_cast<std::uint32_t>(std::stoul(call_.label)),
               .from = current_,
               .offset = call_.offset};
  }
  if (call_.runs > 0) {
    set_goal(Goal::call, 0);
  }
}

void Flow::enter(const Found& found) {
  has_called_ = true;
  if (frames_.size() == kMaxCalls) {
    fault(
        call_.line, call_.offset, errors::kTooDeep,
        joined({"subprogram calls are nested too deep (at most ", std::to_string(kMaxCalls), ")"}));
    stopped_ = true;
    return;
  }
  frames_.push_back({.kind = call_.kind,
                     .text = text_,
                     .line = cursor_,
                     .entry = found.entry,
                     .runs = call_.runs - 1,
                     .counters = first_counter_,
                     .arguments = arguments_.size()});
  first_counter_ = counters_.size();
  if (has_own_locals(call_.kind)) {
    const std::span<const double> values(call_.values.data(), call_.arguments);
    evaluator_->parameters().push_frame(values);
    if (call_.runs > 1) {
      arguments_.insert(arguments_.end(), values.begin(), values.end());
    }
  }
  interpreter_->enter_subprogram();
  enter_text(*found.text, found.entry);
}

std::uint32_t Flow::calling_line() const {
  const auto frame = std::find_if(frames_.rbegin(), frames_.rend(),
                                  [this](const Frame& open) { return open.text == main_.get(); });
  return frame == frames_.rend() ? 0 : frame->calling_line();
}

// Back to the caller, or once more through a subprogram that was called with L.
void Flow::leave() {
  Frame& frame = frames_.back();
  Parameters& parameters = evaluator_->parameters();
  if (has_own_locals(frame.kind)) {
    parameters.pop_frame();
  }
  if (frame.runs > 0) {
    --frame.runs;
    if (has_own_locals(frame.kind)) {
      parameters.push_frame(std::span(arguments_).subspan(frame.arguments));
    }
    return jump(frame.entry);
  }
  interpreter_->leave_subprogram();
  counters_.resize(std::min(first_counter_, counters_.size()));
  first_counter_ = frame.counters;
  arguments_.resize(frame.arguments);
  ProgramText* const caller = frame.text;
  const std::uint32_t line = frame.line;
  frames_.pop_back();
  enter_text(*caller, line);
}

bool Flow::return_from_call(const Return& from) {
  if (frames_.empty()) {
    return false;
  }
  if (frames_.back().kind == CallKind::sub) {
    fault(current_, from.offset, errors::kM99InSub,
          "M99 in a sub: use return or endsub (M99 ends programs that M98 calls)");
  }
  std::optional<diagnostics::DiagnosticPlace> here;
  if (from.line_number != 0) {
    frames_.back().runs = 0;
    here = diagnostics_->place({text_->number_of(current_), from.number_offset + 1});
  }
  const std::size_t depth = frames_.size();
  leave();
  if (from.line_number != 0 && frames_.size() < depth) {
    const std::uint32_t caller = cursor_ == 0 ? 0 : cursor_ - 1;
    target_ = {.number = from.line_number,
               .from = caller,
               .around = text_->structure_around(caller),
               .returned_by = std::move(here)};
    current_ = caller;
    set_goal(Goal::target, 0);
  }
  return true;
}

}  // namespace kerf::parser
