// Lines and arcs cost no memory, however many there are: counted in the allocator itself.
#include <atomic>
#include <cstdlib>
#include <new>

#include <gtest/gtest.h>

#include "tests/parser/program.hpp"

namespace {

std::atomic<long> allocations{0};

void* count_and_allocate(std::size_t size) {
  ++allocations;
  if (void* const memory = std::malloc(size == 0 ? 1 : size)) {
    return memory;
  }
  throw std::bad_alloc();
}

}  // namespace

void* operator new(std::size_t size) {
  return count_and_allocate(size);
}
void* operator new[](std::size_t size) {
  return count_and_allocate(size);
}
// std::stable_sort takes this one for its buffer; without it the buffer would come from elsewhere
// than where the operators below give it back.
void* operator new(std::size_t size, const std::nothrow_t&) noexcept {
  return count_and_allocate(size);
}
void operator delete(void* memory) noexcept {
  std::free(memory);
}
void operator delete[](void* memory) noexcept {
  std::free(memory);
}
void operator delete(void* memory, std::size_t) noexcept {
  std::free(memory);
}
void operator delete[](void* memory, std::size_t) noexcept {
  std::free(memory);
}

namespace kerf::parser {
namespace {

TEST(Allocation, LinesArcsAndEventsNeedNoneOnceTheReaderRuns) {
  const std::string piece =
      "N10 G1 X1.5 Y-2.25 Z0.001 F600 (a comment that is longer than sixteen bytes)\n"
      "X12.345678901234567890 ; a long number\n"
      "G2 X5 Y0 R5000.5\nG3 I2 J1\nG0 X0 Y0 Z0\nM3 S1000\nG4 P0.1\nG20 M8\nG21\nG64 P0.01\n";
  ProgramReader reader;
  Move move;
  std::size_t moves = 0;
  long before = 0;
  for (int i = 0; i < 2000; ++i) {
    if (i == 10) {
      before = allocations;
      moves = 0;
    }
    reader.feed(piece);
    while (reader.next(move)) {
      ++moves;
    }
  }
  // A number with more digits than a double holds takes a string: one per piece.
  EXPECT_LE(allocations - before, 2 * 1990);
  EXPECT_EQ(moves, 1990U * 8);
  EXPECT_FALSE(reader.has_errors());
}

TEST(Allocation, ShortLinesNeedNoneAtAll) {
  std::string piece;
  for (int i = 0; i < 1000; ++i) {
    piece += "X" + std::to_string(i) + ".125 Y" + std::to_string(i % 7) + ".5\n";
  }
  ProgramReader reader;
  Move move;
  reader.feed("G1 F600\n");
  long before = 0;
  std::size_t moves = 0;
  for (int i = 0; i < 1000; ++i) {
    reader.feed(piece);
    if (i == 1) {
      before = allocations;
    }
    while (reader.next(move)) {
      ++moves;
    }
  }
  EXPECT_EQ(allocations - before, 0);
  EXPECT_EQ(moves, 1'000'000U);
}

}  // namespace
}  // namespace kerf::parser
