// The boxes that a program's motion fills: on the machine and in its own coordinates.
#pragma once

#include <cstdint>
#include <optional>

#include <kerf/check.hpp>

#include "parser/program_reader.hpp"

namespace kerf {

// Where the program's coordinates lie, move by move.
class WorkBox {
 public:
  // Each move that next() of the reader gave, and the box that it fills on the machine; nothing: it
  // does not move.
  void look_at(const parser::ProgramReader& reader, const parser::Move& move,
               const std::optional<Extents>& box, CheckReport& report);

 private:
  struct Frame {
    std::size_t system = 0;
    parser::Point to_program_mm{};
    bool is_shaped = false;  // turned, scaled or mirrored

    friend bool operator==(const Frame&, const Frame&) = default;
  };
  static Frame frame_of(const parser::Coordinates& coordinates);

  Frame before_{};  // of blocks up to this one, which were held back
  Frame now_{};
  std::uint64_t begin_ = 0;  // of the present one: blocks after this one
  std::uint64_t read_ = 0;
};

// The first box, or both.
void unite(Extents& all, const Extents& box, bool is_first);

}  // namespace kerf
