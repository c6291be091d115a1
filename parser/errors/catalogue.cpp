#include "parser/errors/catalogue.hpp"

#include <algorithm>
#include <array>

#include "parser/errors/arcs.hpp"
#include "parser/errors/blocks.hpp"
#include "parser/errors/bsplines.hpp"
#include "parser/errors/characters.hpp"
#include "parser/errors/codes.hpp"
#include "parser/errors/compensation.hpp"
#include "parser/errors/curves.hpp"
#include "parser/errors/cycles.hpp"
#include "parser/errors/expressions.hpp"
#include "parser/errors/fanuc.hpp"
#include "parser/errors/files.hpp"
#include "parser/errors/flow.hpp"
#include "parser/errors/gouges.hpp"
#include "parser/errors/machine.hpp"
#include "parser/errors/macros.hpp"
#include "parser/errors/modes.hpp"
#include "parser/errors/motion.hpp"
#include "parser/errors/nurbs.hpp"
#include "parser/errors/offsets.hpp"
#include "parser/errors/probing.hpp"
#include "parser/errors/shape.hpp"
#include "parser/errors/splines.hpp"
#include "parser/errors/subprograms.hpp"
#include "parser/errors/switches.hpp"
#include "parser/errors/variables.hpp"
#include "parser/errors/words.hpp"

namespace kerf::parser::errors {

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

}  // namespace kerf::parser::errors
