#include "parser/expressions/evaluator.hpp"

#include <algorithm>
#include <cmath>

#include "diagnostics/errors/pages.hpp"
#include "parser/expressions/expression_scan.hpp"
#include "parser/text/text.hpp"

namespace kerf::parser {

namespace {

bool same_name(std::string_view a, std::string_view b) {
  return upper(a) == upper(b);
}

bool letter(char c) {
  return static_cast<unsigned char>((c | 0x20) - 'a') < 26;
}

}  // namespace

void Evaluator::reset() {
  if (failed_) {
    fault_ = {};
    failed_ = false;
  }
  pending_.clear();
  stale_read_ = 0;
  unset_read_.reset();
  used_ = false;
}

void Evaluator::begin(const Cursor& cursor) {
  line_ = cursor.line;
  used_ = true;
  depth_ = 0;
  rounding_ = nullptr;
}

bool Evaluator::fail(const char* at, const diagnostics::ErrorPage& page, std::string message) {
  if (!failed_) {
    fault_ = {static_cast<std::uint32_t>(at - line_.data()), std::move(message), &page};
    failed_ = true;
  }
  return false;
}

bool Evaluator::enter(const char* at) {
  if (++depth_ <= kMaxDepth) {
    return true;
  }
  return fail(at, errors::kNestedTooDeep,
              joined({"brackets are nested too deep: at most ", std::to_string(kMaxDepth),
                      " levels are allowed"}));
}

bool Evaluator::value_begins(const Cursor& cursor) const {
  const char* const end = cursor.end();
  const char* at = skip_blanks(cursor.position(), end);
  const bool sign = at != end && (*at == '-' || *at == '+');
  at = sign ? skip_blanks(at + 1, end) : at;
  if (at == end) {
    return false;
  }
  if (*at == '[' || *at == '#' || !letter(*at)) {
    return *at == '[' || *at == '#';
  }
  const ScannedName name = scan_name(at, end);
  const bool known = find_function(name.text(), dialect()) != Function::none;
  if (known && name.size > 2) {
    return true;
  }
  // A name of one letter is an address.
  const char* behind = at;
  while (behind != end && letter(*behind)) {
    ++behind;
  }
  const bool is_name = behind - at > 1;
  behind = skip_blanks(behind, end);
  return is_name && behind != end && *behind == '[';
}

bool Evaluator::read_value(Cursor& cursor, double& value) {
  begin(cursor);
  const char* at = cursor.position();
  const bool good = parse_value({at, cursor.end(), cursor.line.data(), *this}, value);
  cursor.at = static_cast<std::size_t>(at - cursor.line.data());
  return good;
}

bool Evaluator::read_expression(Cursor& cursor, double& value) {
  begin(cursor);
  const char* at = cursor.position();
  const bool good = parse_expression({at, cursor.end(), cursor.line.data(), *this}, value);
  cursor.at = static_cast<std::size_t>(at - cursor.line.data());
  return good;
}

bool Evaluator::find_number(const Reference& variable, int& number) {
  if (is_vacant(variable.number)) {
    return fail(variable.at, errors::kVariableNotWhole, "the variable's number is vacant");
  }
  const double whole = std::round(variable.number);
  if (std::fabs(variable.number - whole) > kWholeTolerance) {
    return fail(variable.at, errors::kVariableNotWhole,
                joined({"a variable's number must be whole, found ", shortest(variable.number)}));
  }
  if (whole < 0.0) {
    return fail(variable.at, errors::kNoSuchVariable,
                joined({"a variable's number must not be negative, found ", shortest(whole)}));
  }
  number = whole < 1e9 ? static_cast<int>(whole) : 1'000'000'000;
  return true;
}

bool Evaluator::fail_reading(const Reference& variable, int number) {
  if (variable.named) {
    return fail(variable.at, errors::kVariableNotSet,
                joined({"variable #<", variable.name, "> is not set"}));
  }
  return fail(variable.at, errors::kNoSuchVariable,
              joined({"variable #", std::to_string(number), " does not exist"}));
}

bool Evaluator::is_pending(const Reference& variable) const {
  return std::ranges::any_of(pending_, [&](const Pending& pending) {
    return variable.named ? pending.number == 0 && same_name(pending.name, variable.name)
                          : pending.number != 0 && pending.number == std::lround(variable.number);
  });
}

bool Evaluator::read(const Reference& variable, double& value) {
  std::optional<double> found;
  int number = 0;
  if (variable.named) {
    found = parameters_->get(variable.name);
  } else if (find_number(variable, number)) {
    found = parameters_->get(number);
  } else {
    return false;
  }
  if (!found) {
    return fail_reading(variable, number);
  }
  if (!pending_.empty() && is_pending(variable)) {
    const auto offset = static_cast<std::uint32_t>(variable.at - line_.data());
    stale_read_ = stale_read_ == 0 ? offset + 1 : stale_read_;
  } else if (!variable.named && !unset_read_ && parameters_->is_first_unset_read(number)) {
    unset_read_ = {number, static_cast<std::uint32_t>(variable.at - line_.data())};
  }
  value = *found;
  return true;
}

bool Evaluator::exists(const Reference& variable) const {
  if (variable.named) {
    return parameters_->get(variable.name).has_value();
  }
  return std::fabs(variable.number) < 1e9 &&
         parameters_->get(static_cast<int>(std::lround(variable.number))).has_value();
}

bool Evaluator::check_writable(const Reference& variable, int& number) {
  if (!variable.named && !find_number(variable, number)) {
    return false;
  }
  if (variable.named && !rules_of(dialect()).named_variables) {
    return fail(variable.at, errors::kNoSuchVariable,
                joined({"variable #<", variable.name,
                        ">: names belong to RS274/NGC, here variables have numbers"}));
  }
  const Write write =
      variable.named ? parameters_->may_set(variable.name) : parameters_->may_set(number);
  switch (write) {
    case Write::done:
      return true;
    case Write::too_many_names:
      return fail(variable.at, errors::kTooManyNames,
                  joined({"#<", variable.name, "> would be one name too many: at most ",
                          std::to_string(Parameters::kMaxNames), " are kept"}));
    case Write::no_such_parameter:
      return fail(variable.at, errors::kNoSuchVariable,
                  joined({"variable #", std::to_string(number), " does not exist"}));
    default:
      return fail(variable.at, errors::kReadOnlyVariable,
                  variable.named ? joined({"variable #<", variable.name, "> is read-only"})
                                 : joined({"variable #", std::to_string(number), " is read-only"}));
  }
}

bool Evaluator::read_assignment(Cursor& cursor) {
  begin(cursor);
  const char* at = cursor.position();
  const char* const end = cursor.end();
  Reference variable;
  int number = 0;
  if (!parse_reference({at, end, cursor.line.data(), *this}, variable)) {
    return false;
  }
  const std::string_view target(variable.at, static_cast<std::size_t>(at - variable.at));
  at = skip_blanks(at, end);
  if (at == end || *at != '=') {
    return fail(at, errors::kEqualsExpected, joined({"'=' is expected after ", quoted(target)}));
  }
  if (!check_writable(variable, number)) {
    return false;
  }
  cursor.at = static_cast<std::size_t>(skip_blanks(at + 1, end) - cursor.line.data());
  double value = 0.0;
  const bool at_once = rules_of(dialect()).assigns_at_once;
  if (!(at_once ? read_expression(cursor, value) : read_value(cursor, value))) {
    if (variable.named && !parameters_->get(variable.name)) {
      // Else each later use of the name would be reported as well.
      pending_.push_back({0, variable.name, 0.0});
    }
    return false;
  }
  if (!at_once) {
    pending_.push_back({number, variable.name, value});
  } else if (parameters_->set(number, value) != Write::done) {
    return fail(variable.at, errors::kReadOnlyVariable,
                joined({"variable #", std::to_string(number), " cannot be written"}));
  }
  return true;
}

void Evaluator::commit() {
  for (const Pending& pending : pending_) {
    if (pending.number != 0) {
      parameters_->set(pending.number, pending.value);
    } else {
      parameters_->set(pending.name, pending.value);
    }
  }
  pending_.clear();
}

void warn_of_unset(const Evaluator::UnsetRead& read, std::uint32_t line,
                   diagnostics::DiagnosticList& diagnostics) {
  if (!diagnostics.has(errors::kUnsetVariable, line)) {
    diagnostics.add({line, read.offset + 1}, errors::kUnsetVariable,
                    joined({"#", std::to_string(read.number), " was never set: it counts as 0"}));
  }
}

}  // namespace kerf::parser
