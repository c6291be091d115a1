// What the bytes of one input say: how to read, on which machine to run, and the program's text.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>

#include <kerf/kernel.hpp>
#include <kerf/machine.hpp>

#include "parser/flow/reader_options.hpp"

namespace kerf::fuzz {

// The first four bytes: size of the pieces of text; bits of dialect, block delete and further axes;
// profile and window; path mode and machine. '0' in each of the last three says nothing special.
inline constexpr std::size_t kHead = 4;

struct FuzzInput {
  std::size_t piece = 1;
  parser::ReaderOptions reader;
  MachineSettings machine;
  KernelOptions kernel;
  std::string text;  // with the block of the path mode before it
};

// Nothing where there are too few bytes.
std::optional<FuzzInput> fuzz_input(std::span<const std::uint8_t> bytes);

}  // namespace kerf::fuzz
