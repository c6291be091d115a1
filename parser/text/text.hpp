// Words and numbers for messages, the same in every locale.
#pragma once

#include <array>
#include <initializer_list>
#include <string>
#include <string_view>

namespace kerf::parser {

std::string in_mm(double value);                        // three decimals
std::string shortest(double value);                     // as few digits as tell it apart
std::string in_mm(const std::array<double, 3>& point);  // "(1.000 2.000 3.000)"
std::string upper(std::string_view text);               // capitals, blanks taken out
std::string quoted(std::string_view text);              // 'text', cut short where it is long

std::string joined(std::initializer_list<std::string_view> parts);
// A capital letter as text.
std::string_view named(char letter);

}  // namespace kerf::parser
