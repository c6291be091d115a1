#include "parser/flow/keyword_names.hpp"

namespace kerf::parser {

std::string_view name_of(Keyword keyword) {
  switch (keyword) {
    case Keyword::o_sub:
      return "sub";
    case Keyword::o_endsub:
      return "endsub";
    case Keyword::o_if:
      return "if";
    case Keyword::o_elseif:
      return "elseif";
    case Keyword::o_else:
      return "else";
    case Keyword::o_endif:
      return "endif";
    case Keyword::o_while:
    case Keyword::o_do_while:
      return "while";
    case Keyword::o_endwhile:
      return "endwhile";
    case Keyword::o_do:
      return "do";
    case Keyword::o_repeat:
      return "repeat";
    case Keyword::o_endrepeat:
      return "endrepeat";
    case Keyword::o_break:
      return "break";
    case Keyword::o_continue:
      return "continue";
    default:
      return "";
  }
}

std::string_view close_of(Keyword opener) {
  switch (opener) {
    case Keyword::o_sub:
      return "endsub";
    case Keyword::o_if:
      return "endif";
    case Keyword::o_while:
      return "endwhile";
    case Keyword::o_do:
      return "while";
    default:
      return "endrepeat";
  }
}

}  // namespace kerf::parser
