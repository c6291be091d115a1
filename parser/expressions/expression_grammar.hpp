// The grammar of values, behind a plain interface: Spirit stays in expression_grammar.cpp.
#pragma once

#include <string_view>

namespace kerf::parser {

class Evaluator;

// A variable as the program names it.
struct Reference {
  const char* at = nullptr;  // of its '#'
  double number = 0.0;
  std::string_view name;
  bool named = false;
};

// What is being read, and who knows the variables and keeps the fault.
struct Reading {
  const char*& at;  // moved after what was read
  const char* end;
  const char* begin;  // of the line
  Evaluator& evaluator;
};

// False: the evaluator has the fault. See Evaluator for what each of them is.
bool parse_value(const Reading& reading, double& result);
bool parse_expression(const Reading& reading, double& result);
bool parse_reference(const Reading& reading, Reference& result);

}  // namespace kerf::parser
