// The variables of a program: numbered and named, local to a call or shared.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "parser/dialects/dialect.hpp"
#include "parser/expressions/predefined_values.hpp"

namespace kerf::parser {

// The value of a Fanuc variable that was never set. It counts as 0 in arithmetic, and a word that
// gets it is left out. No other value in the parser is a NaN.
inline constexpr double kVacant = std::numeric_limits<double>::quiet_NaN();
constexpr bool is_vacant(double value) {
  return value != value;
}

// What became of a write.
enum class Write : std::uint8_t { done, no_such_parameter, read_only, too_many_names };

// RS274/NGC: #1 to #5601, 0 where nothing was written; #1 to #30 and names without a leading '_'
// are local to a call. Fanuc: #1 to #33 local, #100 to #199 and #500 to #999 common, kVacant where
// nothing was written; #0 is always vacant; from #1000 on only what PredefinedValues has.
//
// Names are given without #< >; case and blanks in them do not count.
class Parameters {
 public:
  explicit Parameters(Dialect dialect = Dialect::rs274);

  // `values` is asked before the parameters' own. Must outlive them.
  void use(PredefinedValues& values) { predefined_ = &values; }
  [[nodiscard]] Dialect dialect() const { return dialect_; }

  // Nothing: there is no such parameter.
  [[nodiscard]] std::optional<double> get(int number) const {
    const auto place = static_cast<std::size_t>(number);
    return number > 0 && place < plain_end_ ? numbered_[place] : get_other(number);
  }
  // RS274/NGC: the program's own parameter that holds 0 because nothing was written to it; one that
  // a call may pass counts as written in the call. True once for each parameter.
  bool is_first_unset_read(int number) {
    const auto place = static_cast<std::size_t>(number);
    const bool unset = number > 0 && place < plain_end_ && !written_[place] &&
                       (place > locals_ || frames_.empty()) && !rules_of(dialect_).vacant_variables;
    if (unset) {
      written_[place] = true;
    }
    return unset;
  }
  // Nothing: the name was never set.
  [[nodiscard]] std::optional<double> get(std::string_view name) const;
  // Fanuc: kVacant makes the variable vacant again.
  Write set(int number, double value);
  Write set(std::string_view name, double value);
  // Whether set() would be refused, and why.
  [[nodiscard]] Write may_set(int number) const;
  [[nodiscard]] Write may_set(std::string_view name) const;

  // So many names may be set at a time, local and shared ones together.
  static constexpr std::size_t kMaxNames = 1'000'000;

  // A call begins: its arguments are #1, #2 ... and the other locals are empty: 0 or, for Fanuc,
  // vacant. More arguments than there are locals: the rest is not used.
  void push_frame(std::span<const double> arguments);
  // The call is over: the caller's locals are back. Precondition: depth() > 0.
  void pop_frame();
  [[nodiscard]] std::size_t depth() const { return frames_.size(); }
  // How many numbered parameters are local to a call: #1 to #30, Fanuc #1 to #33.
  [[nodiscard]] std::size_t locals() const { return locals_; }

 private:
  static constexpr std::size_t kMaxLocals = 33;
  struct Frame {
    std::array<double, kMaxLocals> saved{};
  };
  struct Hash {
    using is_transparent = void;
    std::size_t operator()(std::string_view name) const {
      return std::hash<std::string_view>{}(name);
    }
  };

  using Names = std::unordered_map<std::string, double, Hash, std::equal_to<>>;

  [[nodiscard]] std::optional<double> get_other(int number) const;
  [[nodiscard]] bool keeps(int number) const;
  [[nodiscard]] std::string_view plain(std::string_view name) const;
  [[nodiscard]] std::optional<double> find(std::string_view plain_name) const;

  Dialect dialect_;
  std::size_t locals_;
  std::size_t plain_end_;    // up to here all exist and nobody else has them
  std::size_t first_asked_;  // before it nobody else has any
  double empty_;             // what a parameter holds before it is written
  std::vector<double> numbered_;
  std::vector<bool> written_;  // of numbered_; or its reading unset has been seen
  std::vector<Frame> frames_;
  std::vector<Names> local_names_{Names{}};  // of the main program and of each call
  Names shared_names_;
  std::size_t names_ = 0;  // in all of these
  PredefinedValues* predefined_ = nullptr;
  mutable std::string scratch_;  // a name whose case or blanks had to be changed
};

}  // namespace kerf::parser
