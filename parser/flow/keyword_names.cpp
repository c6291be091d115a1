#include "parser/flow/keyword_names.hpp"

namespace kerf::parser {

std::string_view name_of(Keyword keyword) {
  switch (keyword) {
    case Keyword::sub:
      return "sub";
    case Keyword::endsub:
      return "endsub";
    case Keyword::if_:
      return "if";
    case Keyword::elseif:
      return "elseif";
    case Keyword::else_:
      return "else";
    case Keyword::endif:
      return "endif";
    case Keyword::while_:
    case Keyword::do_while:
      return "while";
    case Keyword::endwhile:
      return "endwhile";
    case Keyword::do_:
      return "do";
    case Keyword::repeat:
      return "repeat";
    case Keyword::endrepeat:
      return "endrepeat";
    case Keyword::break_:
      return "break";
    case Keyword::continue_:
      return "continue";
    default:
      return "";
  }
}

std::string_view close_of(Keyword opener) {
  switch (opener) {
    case Keyword::sub:
      return "endsub";
    case Keyword::if_:
      return "endif";
    case Keyword::while_:
      return "endwhile";
    case Keyword::do_:
      return "while";
    default:
      return "endrepeat";
  }
}

}  // namespace kerf::parser
