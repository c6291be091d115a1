// value      := number | [sign] (bracket | variable | function)
// bracket    := '[' expression ']'
// variable   := '#' (digits | '<' name '>' | value)
// function   := ATAN arguments ['/' bracket] | EXISTS '[' variable ']' | name arguments
// arguments  := '[' expression [',' expression] ']'            (the comma: Fanuc)
// expression := operands joined by the operators of each level, from left to right
//
// Spirit X3, working out each value where it is read; nothing is kept of the text. Every
// alternative begins with a character of its own, so the one that was begun is the one that was
// meant: what fails inside it keeps its fault in the evaluator, and the whole line fails. Brackets
// and ## come back through parse_expression and parse_value, plain functions that count how deep
// they are; that is the only recursion.
#include "parser/expressions/expression_grammar.hpp"

#include <boost/spirit/home/x3.hpp>

#include "diagnostics/errors/pages.hpp"
#include "parser/expressions/evaluator.hpp"
#include "parser/expressions/expression_leaves.hpp"

namespace kerf::parser {

namespace {

namespace fusion = boost::fusion;
using namespace leaves;

// Keeps an outcome as the rule's value, or its fault.
template <class Context>
void keep(const Context& context, const char* at, Outcome&& outcome) {
  if (outcome.page != nullptr) {
    x3::_pass(context) = evaluator_of(context).fail(at, *outcome.page, std::move(outcome.message));
    return;
  }
  x3::_val(context) = outcome.value;
}

// NOLINTBEGIN(readability-identifier-naming): rules and actions of a grammar, lower case as its
// words.
constexpr auto take = [](auto& context) { x3::_val(context) = x3::_attr(context); };
constexpr auto combine = [](auto& context) {
  const Join& join = fusion::at_c<0>(x3::_attr(context));
  const Operands operands{x3::_val(context), fusion::at_c<1>(x3::_attr(context))};
  keep(context, join.at, apply(join.op, operands, evaluator_of(context).dialect()));
};
constexpr auto negate = [](auto& context) {
  const double value = fusion::at_c<1>(x3::_attr(context));
  x3::_val(context) = fusion::at_c<0>(x3::_attr(context)) && value != 0.0 ? -value : value;
};
constexpr auto number_variable = [](auto& context) {
  x3::_val(context).at = fusion::at_c<0>(x3::_attr(context));
  x3::_val(context).number = fusion::at_c<1>(x3::_attr(context));
};
constexpr auto name_variable = [](auto& context) {
  x3::_val(context).at = fusion::at_c<0>(x3::_attr(context));
  x3::_val(context).name = fusion::at_c<1>(x3::_attr(context));
  x3::_val(context).named = true;
};
constexpr auto look_up = [](auto& context) {
  x3::_pass(context) = evaluator_of(context).read(x3::_attr(context), x3::_val(context));
};
constexpr auto call_exists = [](auto& context) {
  x3::_val(context) = evaluator_of(context).exists(fusion::at_c<1>(x3::_attr(context))) ? 1.0 : 0.0;
};
constexpr auto call_plain = [](auto& context) {
  const auto& [at, function] = fusion::at_c<0>(x3::_attr(context));
  const double first = fusion::at_c<1>(x3::_attr(context));
  const boost::optional<double>& other = fusion::at_c<2>(x3::_attr(context));
  Evaluator& evaluator = evaluator_of(context);
  if (function == Function::round) {
    evaluator.note_rounding(at);
  }
  if (other.has_value() != (function == Function::pow)) {
    x3::_pass(context) = evaluator.fail(
        at, errors::kFunctionForm,
        other ? "the function takes one value" : "POW needs the form POW[base,exponent]");
    return;
  }
  keep(context, at,
       other ? apply(BinaryOperator::power, {first, *other}, Dialect::fanuc)
             : apply(function, first, evaluator.dialect()));
};
constexpr auto call_atan = [](auto& context) {
  const char* const at = fusion::at_c<0>(x3::_attr(context)).at;
  const double y = fusion::at_c<1>(x3::_attr(context));
  const boost::optional<double>& inside = fusion::at_c<2>(x3::_attr(context));
  const boost::optional<double>& divisor = fusion::at_c<3>(x3::_attr(context));
  Evaluator& evaluator = evaluator_of(context);
  const bool one = !inside && !divisor;
  if ((inside && divisor) || (one && !rules_of(evaluator.dialect()).macro_arithmetic)) {
    x3::_pass(context) =
        evaluator.fail(at, errors::kFunctionForm, "ATAN needs the form ATAN[a]/[b]");
    return;
  }
  keep(
      context, at,
      one ? apply(Function::atan, y, Dialect::fanuc)
          : Outcome{
                arc_tangent_deg(y, inside ? *inside : *divisor, evaluator.dialect()), nullptr, {}});
};

constexpr FunctionName named(Function only) {
  FunctionName name;
  name.only = only;
  return name;
}
constexpr OperatorOf operator_of(int level) {
  OperatorOf leaf;
  leaf.level = level;
  return leaf;
}

const Blanks blanks{};
const Sign sign{};
const Number number{};
const Comma comma{};
const Hash hash{};
const Name name{};
const Required<'[', explain_no_bracket> open{};
const Required<']', explain_not_closed> close{};
const Deeper<parse_expression> inner{};
const Deeper<parse_value> inner_value{};
const Digits digits{};
const VariableBegins variable_begins{};
const NoValue no_value{};
const NoReference no_reference{};
const OpeningBracket opening{};

template <class Value>
constexpr auto rule(const char* what) {
  return x3::rule<struct RuleTag, Value>{what};
}

// A rule of its own for each alternative gives them one attribute.
const auto by_name = rule<Reference>("named variable") = (hash >> blanks >> name)[name_variable];
const auto index = rule<double>("number of a variable") = digits | (variable_begins >> inner_value);
const auto by_number = rule<Reference>("numbered variable") =
    (hash >> blanks >> index)[number_variable];
const auto reference = rule<Reference>("variable") = by_name | by_number;
const auto variable = rule<double>("value of a variable") = reference[look_up];

const auto bracket = rule<double>("bracket") = open >> blanks >> inner >> blanks >> close;
const auto second = rule<double>("second argument") = comma >> blanks >> inner >> blanks;
const auto arguments = open >> blanks >> inner >> blanks >> -second >> close;
const auto over = rule<double>("second leg") = blanks >> x3::lit('/') >> blanks >> bracket;
const auto plain_of = rule<double>("function") =
    (named(Function::none) >> blanks >> arguments)[call_plain];
const auto atan_of = rule<double>("ATAN") =
    (named(Function::atan) >> blanks >> arguments >> -over)[call_atan];
const auto of_variable = rule<Reference>("variable of EXISTS") = reference | no_reference;
const auto exists_of = rule<double>("EXISTS") =
    (named(Function::exists) >> blanks >> open >> blanks >> of_variable >> blanks >>
     close)[call_exists];

const auto unsigned_value = rule<double>("unsigned value") =
    (opening >> bracket) | variable | plain_of | atan_of | exists_of | no_value;
const auto signed_value = rule<double>("signed value") = (sign >> unsigned_value)[negate];
const auto any_value = rule<double>("value") = number | signed_value;

// The operands of a level are the expressions of the next higher one.
template <int kLevel>
constexpr auto level_rule() {
  if constexpr (kLevel > kHighestLevel) {
    return any_value;
  } else {
    return rule<double>("expression") =
               level_rule<kLevel + 1>()[take] >>
               *(blanks >> operator_of(kLevel) >> blanks >> level_rule<kLevel + 1>())[combine];
  }
}
const auto expression = level_rule<kLowestLevel>();
// NOLINTEND(readability-identifier-naming)

// NOLINTBEGIN(misc-no-recursion): Evaluator::enter says how deep.
template <class Grammar, class Value>
bool parse_with(const Grammar& grammar, const Reading& reading, Value& result) {
  // The context is made by hand: x3::with would copy the grammar for each value.
  const Surroundings here{reading.begin, &reading.evaluator};
  const auto surroundings = std::cref(here);
  const auto context = x3::make_context<SurroundingsTag>(surroundings);
  return grammar.parse(reading.at, reading.end, context, x3::unused, result) &&
         !reading.evaluator.failed();
}

}  // namespace

bool parse_value(const Reading& reading, double& result) {
  return parse_with(any_value, reading, result);
}
bool parse_expression(const Reading& reading, double& result) {
  return parse_with(expression, reading, result);
}
bool parse_reference(const Reading& reading, Reference& result) {
  return parse_with(reference, reading, result);
}
// NOLINTEND(misc-no-recursion)

}  // namespace kerf::parser
