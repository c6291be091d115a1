// What the leaves of both grammars, that of blocks and that of values, have in common. X3's own
// number parsers take nan, inf and exponents and round wrongly, and its character classes must not
// see bytes from 0x80.
#pragma once

#include <type_traits>

#include <boost/spirit/home/x3.hpp>

#include "parser/text/number.hpp"

namespace kerf::parser::leaves {

namespace x3 = boost::spirit::x3;

using Nothing = x3::unused_type;

// Where a leaf reads, and the context that its grammar was given.
template <class Context>
struct GrammarPlace {
  const char*& at;  // moved after what was read
  const char* end;
  const Context& context;
};

// A leaf is a function object: it takes a GrammarPlace and fills its attribute. False: nothing was
// read.
template <class Self, class Attribute>
struct Leaf : x3::parser<Self> {
  using attribute_type = Attribute;
  static constexpr bool has_attribute = !std::is_same_v<Attribute, Nothing>;
  template <class Context, class RContext, class Actual>
  // NOLINTNEXTLINE(misc-no-recursion): Evaluator::enter says how deep.
  bool parse(const char*& first, const char* last, const Context& context, RContext&,
             Actual& actual) const {
    const GrammarPlace<Context> place{first, last, context};
    if constexpr (std::is_same_v<Actual, Attribute>) {
      return this->derived()(place, actual);
    } else {
      static_assert(std::is_same_v<std::remove_const_t<Actual>, Nothing>);
      Attribute ignored{};
      return this->derived()(place, ignored);
    }
  }
};

struct Blanks : Leaf<Blanks, Nothing> {
  template <class Context>
  bool operator()(const GrammarPlace<Context>& place, Nothing&) const {
    while (place.at != place.end && detail::is_blank(*place.at)) {
      ++place.at;
    }
    return true;
  }
};

}  // namespace kerf::parser::leaves
