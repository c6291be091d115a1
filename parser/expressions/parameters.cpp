#include "parser/expressions/parameters.hpp"

#include <algorithm>

namespace kerf::parser {

namespace {

// Tool number, tool offsets and the current position [LinuxCNC 2.9, "Numbered parameters"; rs274].
constexpr bool is_read_only(int number) {
  return (number >= 5400 && number <= 5413) || (number >= 5420 && number <= 5428);
}

constexpr bool is_plain(char c) {
  return c != ' ' && c != '\t' && (c < 'A' || c > 'Z');
}

}  // namespace

Parameters::Parameters(Dialect dialect)
    : dialect_(dialect),
      locals_(rules_of(dialect).locals),
      plain_end_(rules_of(dialect).plain_end),
      first_asked_(rules_of(dialect).first_asked),
      empty_(rules_of(dialect).vacant_variables ? kVacant : 0.0),
      numbered_(rules_of(dialect).variables_end, empty_),
      written_(numbered_.size()) {}

bool Parameters::keeps(int number) const {
  if (number < 1 || static_cast<std::size_t>(number) >= numbered_.size()) {
    return false;
  }
  return !rules_of(dialect_).control_variables || static_cast<std::size_t>(number) <= locals_ ||
         (number >= 100 && number <= 199) || number >= 500;
}

std::optional<double> Parameters::get_other(int number) const {
  if (predefined_ != nullptr && number >= static_cast<int>(first_asked_)) {
    if (const auto value = predefined_->number(number)) {
      return value;
    }
  }
  if (number == 0 && rules_of(dialect_).vacant_variables) {
    return kVacant;
  }
  return keeps(number) ? std::optional(numbered_[static_cast<std::size_t>(number)]) : std::nullopt;
}

Write Parameters::may_set(int number) const {
  if (!rules_of(dialect_).control_variables && is_read_only(number)) {
    return Write::read_only;
  }
  if (rules_of(dialect_).vacant_variables && number == 0) {
    return Write::read_only;
  }
  return get(number) ? Write::done : Write::no_such_parameter;
}

Write Parameters::set(int number, double value) {
  if (const Write write = may_set(number); write != Write::done) {
    return write;
  }
  if (static_cast<std::size_t>(number) >= first_asked_ && predefined_ != nullptr &&
      predefined_->take(number, value)) {
    return Write::done;
  }
  if (!keeps(number)) {
    return Write::read_only;
  }
  const auto place = static_cast<std::size_t>(number);
  numbered_[place] = value;
  if (place > locals_ || frames_.empty()) {
    written_[place] = true;
  }
  return Write::done;
}

// The name in lower case and without blanks.
std::string_view Parameters::plain(std::string_view name) const {
  if (std::all_of(name.begin(), name.end(), is_plain)) {
    return name;
  }
  scratch_.clear();
  for (const char c : name) {
    if (c != ' ' && c != '\t') {
      scratch_ += c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
    }
  }
  return scratch_;
}

std::optional<double> Parameters::find(std::string_view plain_name) const {
  const Names& names = plain_name.starts_with('_') ? shared_names_ : local_names_.back();
  const auto found = names.find(plain_name);
  return found == names.end() ? std::nullopt : std::optional(found->second);
}

std::optional<double> Parameters::get(std::string_view name) const {
  const std::string_view wanted = plain(name);
  if (const auto value = find(wanted)) {
    return value;
  }
  return predefined_ == nullptr ? std::nullopt : predefined_->name(wanted);
}

Write Parameters::may_set(std::string_view name) const {
  const std::string_view wanted = plain(name);
  if (find(wanted)) {
    return Write::done;
  }
  if (predefined_ != nullptr && predefined_->name(wanted)) {
    return Write::read_only;
  }
  return names_ < kMaxNames ? Write::done : Write::too_many_names;
}

Write Parameters::set(std::string_view name, double value) {
  if (const Write write = may_set(name); write != Write::done) {
    return write;
  }
  const std::string_view wanted = plain(name);
  Names& names = wanted.starts_with('_') ? shared_names_ : local_names_.back();
  if (const auto found = names.find(wanted); found != names.end()) {
    found->second = value;
  } else {
    names.emplace(wanted, value);
    ++names_;
  }
  return Write::done;
}

void Parameters::push_frame(std::span<const double> arguments) {
  Frame& frame = frames_.emplace_back();
  local_names_.emplace_back();
  const auto locals = numbered_.begin() + 1;
  std::copy_n(locals, locals_, frame.saved.begin());
  const std::size_t given = std::min(arguments.size(), locals_);
  std::copy_n(arguments.begin(), given, locals);
  std::fill_n(locals + static_cast<std::ptrdiff_t>(given), locals_ - given, empty_);
}

void Parameters::pop_frame() {
  const Frame& frame = frames_.back();
  std::copy_n(frame.saved.begin(), locals_, numbered_.begin() + 1);
  names_ -= local_names_.back().size();
  local_names_.pop_back();
  frames_.pop_back();
}

}  // namespace kerf::parser
