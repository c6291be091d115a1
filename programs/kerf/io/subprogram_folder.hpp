// Subprograms in files beside the program.
#pragma once

#include <string>

#include "parser/dialects/dialect.hpp"
#include "parser/flow/reader_options.hpp"

namespace kerf::program {

// Looks for NAME.ngc in the folder of `program`, the name in lower case as LinuxCNC does; for the
// Fanuc dialect first for O1234.nc, O1234.NC, O1234 and the same with o, or POCKET and pocket. A
// file is read once, so that the check, the plan and the run see the same text. A symbolic link out
// of the folder is refused. Files of more than 64 MiB and files that cannot be read count as
// missing.
parser::SubprogramSource subprograms_beside(const std::string& program, parser::Dialect dialect);

struct FileOf {
  const std::string& path;
  const std::string& program;
  bool is_fanuc = false;  // else a name without extension is a program's number alone
};
// Whether the file, as it is there, may be one of those.
bool may_be_subprogram(const FileOf& file);

}  // namespace kerf::program
