#include "parser/flow/structure.hpp"

#include <utility>

#include "diagnostics/errors/pages.hpp"
#include "parser/flow/statement_reader.hpp"
#include "parser/flow/statement_text.hpp"
#include "parser/text/text.hpp"

namespace kerf::parser {

namespace {

bool is_loop(Keyword keyword) {
  return keyword == Keyword::o_while || keyword == Keyword::o_do || keyword == Keyword::o_repeat;
}
bool is_macro(Keyword keyword) {
  return keyword == Keyword::macro_while || keyword == Keyword::macro_do ||
         keyword == Keyword::macro_end;
}

// What closes the structure that `opener` opens.
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

void add(std::vector<StatementFault>& faults, const Statement& statement,
         const diagnostics::ErrorPage& page, std::string message) {
  faults.push_back({statement.line, statement.keyword_at, &page, std::move(message)});
}

}  // namespace

std::string Structure::shown(std::uint32_t index) const {
  const Statement& statement = (*statements_)[index];
  if (is_macro(statement.keyword)) {
    return joined(
        {statement.keyword == Keyword::macro_end ? "END" : "DO", std::to_string(statement.label)});
  }
  return joined({shown_label(labels_->name(statement.label)), " ", name_of(statement.keyword)});
}

// Structures outside a sub are out of reach inside it.
std::size_t Structure::sub_around() const {
  for (std::size_t i = open_.size(); i > 0; --i) {
    if (open_[i - 1].kind == Keyword::o_sub) {
      return i - 1;
    }
  }
  return kNowhere;
}

std::size_t Structure::find(Keyword kind, std::uint32_t label) const {
  const std::size_t sub = kind == Keyword::o_sub ? kNowhere : sub_around();
  const std::size_t bottom = sub == kNowhere ? 0 : sub + 1;
  for (std::size_t i = open_.size(); i > bottom; --i) {
    const Open& open = open_[i - 1];
    if (open.kind == kind && (*statements_)[open.opener].label == label) {
      return i - 1;
    }
  }
  return kNowhere;
}

void Structure::report_open(const Open& open, std::vector<StatementFault>& faults) const {
  const Statement& opener = (*statements_)[open.opener];
  if (is_macro(open.kind)) {
    add(faults, opener, errors::kNoClose,
        joined({shown(open.opener), " has no END", std::to_string(opener.label)}));
    return;
  }
  add(faults, opener, errors::kNoClose,
      joined({shown(open.opener), " has no ", close_of(open.kind)}));
}

void Structure::drop_above(std::size_t depth, std::vector<StatementFault>& faults) {
  while (open_.size() > depth + 1) {
    report_open(open_.back(), faults);
    repeats_ -= open_.back().kind == Keyword::o_repeat ? 1U : 0U;
    open_.pop_back();
  }
}

void Structure::open(std::uint32_t index, std::vector<StatementFault>& faults) {
  Statement& statement = at(index);
  if (open_.size() == kMaxDepth) {
    add(faults, statement, errors::kStructuresTooDeep,
        joined({"structures are nested too deep (at most ", std::to_string(kMaxDepth), ")"}));
    too_deep_ = true;
    open_.clear();
    statement.keyword = Keyword::wrong;
    return;
  }
  if (statement.keyword == Keyword::o_sub) {
    if (const std::size_t sub = sub_around(); sub != kNowhere) {
      add(faults, statement, errors::kNestedSub,
          joined({"sub inside sub ", shown_label(labels_->name(at(open_[sub].opener).label))}));
    }
  }
  open_.push_back({index, index, statement.keyword});
  repeats_ += statement.keyword == Keyword::o_repeat ? 1U : 0U;
}

void Structure::close(std::uint32_t index, Keyword kind, std::vector<StatementFault>& faults) {
  Statement& statement = at(index);
  std::size_t place = find(kind, statement.label);
  if (place == kNowhere && !open_.empty() && open_.back().kind == kind) {
    place = open_.size() - 1;
    const Statement& opener = at(open_.back().opener);
    add(faults, opener, errors::kWrongLabel,
        joined({shown(index), " in line ", std::to_string(statement.line + first_line_),
                " does not close ", shown(open_.back().opener)}));
    statement.keyword = Keyword::wrong;
  }
  if (place == kNowhere) {
    add(faults, statement, errors::kNoOpener, joined({shown(index), " without ", name_of(kind)}));
    statement.keyword = Keyword::wrong;
    return;
  }
  drop_above(place, faults);
  const Open opened = open_.back();
  open_.pop_back();
  repeats_ -= kind == Keyword::o_repeat ? 1U : 0U;
  at(opened.clause).next = index;
  at(opened.opener).close = index;
  statement.head = opened.opener;
  statement.around = innermost();
  statement.repeats = repeats_;
}

void Structure::branch(std::uint32_t index, std::vector<StatementFault>& faults) {
  Statement& statement = at(index);
  const std::size_t place = find(Keyword::o_if, statement.label);
  if (place == kNowhere) {
    add(faults, statement, errors::kNoOpener, joined({shown(index), " without if"}));
    statement.keyword = Keyword::wrong;
    return;
  }
  drop_above(place, faults);
  Open& open = open_.back();
  if (at(open.clause).keyword == Keyword::o_else) {
    add(faults, statement, errors::kBranchAfterElse,
        joined({shown(index), " after the else of this if"}));
  }
  at(open.clause).next = index;
  open.clause = index;
  statement.head = open.opener;
}

void Structure::leave_loop(std::uint32_t index, std::vector<StatementFault>& faults) {
  Statement& statement = at(index);
  const std::size_t sub = sub_around();
  bool any_loop = false;
  for (std::size_t i = open_.size(); i > (sub == kNowhere ? 0 : sub + 1); --i) {
    const Open& open = open_[i - 1];
    any_loop = any_loop || is_loop(open.kind);
    if (is_loop(open.kind) && at(open.opener).label == statement.label) {
      statement.head = open.opener;
      return;
    }
  }
  const std::string_view name = name_of(statement.keyword);
  add(faults, statement, errors::kOutsideLoop,
      any_loop ? joined({shown(index), ": no loop around it has this label"})
               : joined({name, " outside a loop"}));
  statement.keyword = Keyword::wrong;
}

// END: loops of macro B are told apart by number alone.
void Structure::loop_end(std::uint32_t index, std::vector<StatementFault>& faults) {
  Statement& statement = at(index);
  std::size_t place = open_.size();
  while (place > 0 && at(open_[place - 1].opener).label != statement.label) {
    --place;
  }
  if (place == 0) {
    const std::string number = std::to_string(statement.label);
    add(faults, statement, errors::kNoOpener, joined({"END", number, " without DO", number}));
    statement.keyword = Keyword::wrong;
    return;
  }
  const bool crosses = place != open_.size();
  const Open opened = open_[place - 1];
  if (crosses) {
    add(faults, at(opened.opener), errors::kLoopsCross,
        joined({shown(index), " closes ", shown(opened.opener), " while ",
                shown(open_.back().opener), " is open"}));
    statement.keyword = Keyword::wrong;
  }
  open_.erase(open_.begin() + static_cast<std::ptrdiff_t>(place) - 1);
  at(opened.opener).close = index;
  statement.head = opened.opener;
  statement.around = innermost();
}

void Structure::take(std::uint32_t index, std::vector<StatementFault>& faults) {
  Statement& statement = at(index);
  if (too_deep_) {
    statement.keyword = Keyword::wrong;
    return;
  }
  statement.around = innermost();
  statement.repeats = repeats_;
  switch (statement.keyword) {
    case Keyword::o_while:
      if (find(Keyword::o_do, statement.label) == kNowhere) {
        return open(index, faults);
      }
      statement.keyword = Keyword::o_do_while;
      return close(index, Keyword::o_do, faults);
    case Keyword::o_sub:
    case Keyword::o_if:
    case Keyword::o_do:
    case Keyword::o_repeat:
      return open(index, faults);
    case Keyword::o_elseif:
    case Keyword::o_else:
      return branch(index, faults);
    case Keyword::o_endsub:
      return close(index, Keyword::o_sub, faults);
    case Keyword::o_endif:
      return close(index, Keyword::o_if, faults);
    case Keyword::o_endwhile:
      return close(index, Keyword::o_while, faults);
    case Keyword::o_endrepeat:
      return close(index, Keyword::o_repeat, faults);
    case Keyword::o_break:
    case Keyword::o_continue:
      return leave_loop(index, faults);
    case Keyword::o_return:
      if (sub_around() == kNowhere) {
        add(faults, statement, errors::kOutsideSub, "return outside a sub");
        statement.keyword = Keyword::wrong;
      }
      return;
    case Keyword::macro_while:
    case Keyword::macro_do:
      for (const Open& other : open_) {
        if (at(other.opener).label == statement.label) {
          add(faults, statement, errors::kLoopNumberInUse,
              joined({shown(index), " inside ", shown(other.opener)}));
          break;
        }
      }
      return open(index, faults);
    case Keyword::macro_end:
      return loop_end(index, faults);
    case Keyword::program:
      // A program ends where the next one begins, and so do its structures.
      return finish(faults);
    default:
      return;
  }
}

void Structure::finish(std::vector<StatementFault>& faults) {
  for (const Open& open : open_) {
    report_open(open, faults);
  }
  open_.clear();
  repeats_ = 0;
}

}  // namespace kerf::parser
