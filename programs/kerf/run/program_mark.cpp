#include "programs/kerf/run/program_mark.hpp"

#include <optional>
#include <utility>

#include <spdlog/fmt/fmt.h>

#include "programs/kerf/io/checksum.hpp"

namespace kerf::program {

SubprogramSource ProgramMark::noting(SubprogramSource subprograms) {
  return [this, subprograms = std::move(subprograms)](
             std::string_view name) -> std::optional<SubprogramText> {
    auto found = subprograms(name);
    Checksum text;
    text.add(found ? found->text : "none");
    subprograms_.emplace(name, text.value());
    return found;
  };
}

tl::expected<std::uint64_t, std::string> ProgramMark::of(ProgramFile& file,
                                                         const KernelOptions& options) const {
  Checksum mark;
  file.rewind();
  for (;;) {
    const auto piece = file.read();
    if (!piece) {
      return tl::unexpected(piece.error());
    }
    if (piece->empty()) {
      break;
    }
    mark.add(*piece);
  }
  for (const auto& [name, text] : subprograms_) {
    mark.add(fmt::format("\nsubprogram {} {:016x}", name, text));
  }
  mark.add(options.dialect ? fmt::format("\ndialect {}", static_cast<int>(*options.dialect)) : "");
  for (unsigned number = 1; number <= BlockDelete::kSwitches; ++number) {
    mark.add(options.block_delete.is_on(number) ? "\n1" : "\n0");
  }
  for (const double place_mm : options.start_mm) {
    mark.add(fmt::format("\nstart {}", place_mm));
  }
  return mark.value();
}

}  // namespace kerf::program
