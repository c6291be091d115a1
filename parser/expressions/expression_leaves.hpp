// The leaves of the grammar of values. Part of expression_grammar.cpp and of nothing else.
#pragma once

#include <string_view>

#include "diagnostics/errors/pages.hpp"
#include "parser/expressions/evaluator.hpp"
#include "parser/expressions/expression_grammar.hpp"
#include "parser/expressions/expression_scan.hpp"
#include "parser/expressions/grammar_leaf.hpp"
#include "parser/text/number.hpp"

namespace kerf::parser::leaves {

// What the leaves know beside the text.
struct Surroundings {
  const char* begin;
  Evaluator* evaluator;
};
struct SurroundingsTag {};

template <class Context>
Evaluator& evaluator_of(const Context& context) {
  return *x3::get<SurroundingsTag>(context).get().evaluator;
}

// A leaf that reads with the evaluator at hand.
template <class Self, class Attribute>
struct ValueLeaf : Leaf<Self, Attribute> {
  template <class Context>
  // NOLINTNEXTLINE(misc-no-recursion): Evaluator::enter says how deep.
  bool operator()(const GrammarPlace<Context>& place, Attribute& attribute) const {
    const Surroundings& here = x3::get<SurroundingsTag>(place.context).get();
    return this->derived().read({place.at, place.end, here.begin, *here.evaluator}, attribute);
  }
};

struct Sign : ValueLeaf<Sign, bool> {
  bool read(const Reading& reading, bool& negative) const {
    negative = false;
    if (reading.at != reading.end && (*reading.at == '-' || *reading.at == '+')) {
      negative = *reading.at == '-';
      reading.at = skip_blanks(reading.at + 1, reading.end);
    }
    return true;
  }
};

struct Number : ValueLeaf<Number, double> {
  bool read(const Reading& reading, double& value) const {
    const char* start = reading.at;
    const char c = start == reading.end ? ' ' : *start;
    if (c == '-' || c == '+') {
      start = skip_blanks(start + 1, reading.end);
    }
    if (start == reading.end || (!detail::is_digit(*start) && *start != '.')) {
      return false;
    }
    const ScannedNumber number = scan_number(start, reading.end);
    if (number.end == nullptr) {
      return explain_bad_number(reading);
    }
    if (number.oddity == Oddity::blank_inside) {
      while (detail::is_digit(*start) || *start == '.') {
        ++start;
      }
      reading.at = skip_blanks(start, reading.end);
      return explain_not_closed(reading);
    }
    value = c == '-' && number.value != 0.0 ? -number.value : number.value;
    reading.at = number.end;
    return true;
  }
};

// Comes back to the grammar one level deeper.
template <bool (*kParseInside)(const Reading&, double&)>
struct Deeper : ValueLeaf<Deeper<kParseInside>, double> {
  // NOLINTNEXTLINE(misc-no-recursion): Evaluator::enter says how deep.
  bool read(const Reading& reading, double& value) const {
    if (!reading.evaluator.enter(reading.at)) {
      return false;
    }
    const bool good = kParseInside(reading, value);
    reading.evaluator.leave();
    return good;
  }
};

// Required characters, whose absence is a fault.
template <char kWanted, bool (*kExplain)(const Reading&)>
struct Required : ValueLeaf<Required<kWanted, kExplain>, Nothing> {
  bool read(const Reading& reading, Nothing&) const {
    if (reading.at == reading.end || *reading.at != kWanted) {
      return kExplain(reading);
    }
    ++reading.at;
    return true;
  }
};

struct NoValue : ValueLeaf<NoValue, double> {
  bool read(const Reading& reading, double&) const { return explain_no_value(reading); }
};

struct NoReference : ValueLeaf<NoReference, Reference> {
  bool read(const Reading& reading, Reference&) const {
    return reading.evaluator.fail(reading.at, errors::kFunctionForm,
                                  "EXISTS needs the form EXISTS[#<name>]");
  }
};
// Whether '[' is next, without taking it.
struct OpeningBracket : ValueLeaf<OpeningBracket, Nothing> {
  bool read(const Reading& reading, Nothing&) const {
    return reading.at != reading.end && *reading.at == '[';
  }
};

// The number after '#': digits, which end at a blank, or any value but a letter's.
struct Digits : ValueLeaf<Digits, double> {
  bool read(const Reading& reading, double& number) const {
    const char* at = reading.at;
    double value = 0.0;
    for (; at != reading.end && detail::is_digit(*at); ++at) {
      value = value * 10.0 + (*at - '0');
    }
    if (at == reading.at || (at != reading.end && *at == '.')) {
      return false;
    }
    number = value;
    reading.at = at;
    return true;
  }
};
struct VariableBegins : ValueLeaf<VariableBegins, Nothing> {
  bool read(const Reading& reading, Nothing&) const {
    const Cursor here{{reading.at, static_cast<std::size_t>(reading.end - reading.at)}, 0};
    const char c = reading.at == reading.end ? ' ' : *reading.at;
    const bool number = detail::is_digit(c) || c == '.' || c == '-' || c == '+';
    return number || reading.evaluator.value_begins(here) || explain_no_variable(reading);
  }
};
struct Name : ValueLeaf<Name, std::string_view> {
  bool read(const Reading& reading, std::string_view& name) const {
    if (reading.at == reading.end || *reading.at != '<') {
      return false;
    }
    const char* at = reading.at + 1;
    while (at != reading.end && *at != '>') {
      ++at;
    }
    if (at == reading.end) {
      return reading.evaluator.fail(at, errors::kNameNotClosed, "'>' is expected to close '#<'");
    }
    name = {reading.at + 1, static_cast<std::size_t>(at - reading.at - 1)};
    reading.at = at + 1;
    return true;
  }
};
struct Hash : ValueLeaf<Hash, const char*> {
  bool read(const Reading& reading, const char*& at) const {
    if (reading.at == reading.end || *reading.at != '#') {
      return false;
    }
    at = reading.at++;
    return true;
  }
};

struct FunctionCall {
  const char* at = nullptr;
  Function function = Function::none;
};
// A function's name; with `only`, that function's, else any but those of another form.
struct FunctionName : ValueLeaf<FunctionName, FunctionCall> {
  Function only = Function::none;
  bool read(const Reading& reading, FunctionCall& call) const {
    const ScannedName name = scan_name(reading.at, reading.end);
    const Function found = find_function(name.text(), reading.evaluator.dialect());
    const bool special = found == Function::atan || found == Function::exists;
    if (found == Function::none || (only == Function::none ? special : found != only)) {
      return false;
    }
    call = {reading.at, found};
    reading.at = name.end;
    return true;
  }
};

struct Comma : ValueLeaf<Comma, Nothing> {
  bool read(const Reading& reading, Nothing&) const {
    if (reading.at == reading.end || *reading.at != ',' ||
        !rules_of(reading.evaluator.dialect()).macro_arithmetic) {
      return false;
    }
    ++reading.at;
    return true;
  }
};

struct Join {
  const char* at = nullptr;
  BinaryOperator op = BinaryOperator::none;
};
struct OperatorOf : ValueLeaf<OperatorOf, Join> {
  int level = 0;
  bool read(const Reading& reading, Join& join) const {
    if (reading.at == reading.end || *reading.at == ']') {
      return false;
    }
    const ScannedOperator found = scan_operator(reading.at, reading.end);
    if (found.op == BinaryOperator::none ||
        level_of(found.op, reading.evaluator.dialect()) != level) {
      return false;
    }
    join = {reading.at, found.op};
    reading.at = found.end;
    return true;
  }
};

}  // namespace kerf::parser::leaves
