// Which lines of a program are rapids. Setpoints do not say it; plots want to know.
#pragma once

#include <cstdint>

#include "parser/program_reader.hpp"
#include "programs/program_file.hpp"

namespace kerf::program {

// Reads the program once more, beside the run and only as far as that has come, so that memory does
// not grow with its length.
class RapidLines {
 public:
  RapidLines(ProgramFile file, bool block_delete);

  // Does the line hold a rapid? Lines come in ascending order; of one before the last asked for,
  // and where the file cannot be read any more, the last answer.
  bool is_rapid(std::uint32_t line);

 private:
  bool read_move();

  ProgramFile file_;
  parser::ProgramReader reader_;
  parser::Move move_;  // the first one not before the line
  bool is_rapid_ = false;
  bool at_end_ = false;
};

}  // namespace kerf::program
