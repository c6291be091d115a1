#include "diagnostics/errors/catalogue.hpp"

#include <algorithm>
#include <array>

#include "diagnostics/errors/arcs.hpp"
#include "diagnostics/errors/blocks.hpp"
#include "diagnostics/errors/bsplines.hpp"
#include "diagnostics/errors/characters.hpp"
#include "diagnostics/errors/codes.hpp"
#include "diagnostics/errors/compensation.hpp"
#include "diagnostics/errors/curves.hpp"
#include "diagnostics/errors/cycles.hpp"
#include "diagnostics/errors/expressions.hpp"
#include "diagnostics/errors/fanuc.hpp"
#include "diagnostics/errors/files.hpp"
#include "diagnostics/errors/flow.hpp"
#include "diagnostics/errors/gouges.hpp"
#include "diagnostics/errors/machine.hpp"
#include "diagnostics/errors/macros.hpp"
#include "diagnostics/errors/modes.hpp"
#include "diagnostics/errors/motion.hpp"
#include "diagnostics/errors/nurbs.hpp"
#include "diagnostics/errors/offsets.hpp"
#include "diagnostics/errors/probing.hpp"
#include "diagnostics/errors/shape.hpp"
#include "diagnostics/errors/splines.hpp"
#include "diagnostics/errors/subprograms.hpp"
#include "diagnostics/errors/switches.hpp"
#include "diagnostics/errors/variables.hpp"
#include "diagnostics/errors/words.hpp"

namespace kerf::errors {

namespace {

using Page = const ErrorPage*;

template <std::size_t... sizes>
constexpr auto in_order(const std::array<Page, sizes>&... topics) {
  std::array<Page, (sizes + ...)> pages{};
  Page* end = pages.data();
  ((end = std::copy(topics.begin(), topics.end(), end)), ...);
  std::sort(pages.begin(), pages.end(), [](Page a, Page b) { return a->number < b->number; });
  return pages;
}

constexpr std::array kPages =
    in_order(kArcsPages, kBlocksPages, kBsplinesPages, kCharactersPages, kCodesPages,
             kCompensationPages, kCurvesPages, kCyclesPages, kExpressionsPages, kFanucPages,
             kFilesPages, kFlowPages, kGougesPages, kMachinePages, kMacrosPages, kModesPages,
             kMotionPages, kNurbsPages, kOffsetsPages, kProbingPages, kShapePages, kSplinesPages,
             kSubprogramsPages, kSwitchesPages, kVariablesPages, kWordsPages);

}  // namespace

std::span<const ErrorPage* const> catalogue() {
  return kPages;
}

const ErrorPage* find_page(std::uint16_t number) {
  const auto found = std::find_if(kPages.begin(), kPages.end(),
                                  [number](Page page) { return page->number == number; });
  return found == kPages.end() ? nullptr : *found;
}

std::string trigger_of(const ErrorPage& page) {
  std::string text(page.trigger);
  const std::string_view more = page.more.text;
  const std::size_t counter = more.find('@');
  for (std::uint32_t i = 1; i <= page.more.times; ++i) {
    text += more.substr(0, counter);
    if (counter != std::string_view::npos) {
      text.append(std::to_string(i)).append(more.substr(counter + 1));
    }
  }
  return text;
}

}  // namespace kerf::errors
