#include "programs/kerf/run/start_search.hpp"

#include <deque>
#include <limits>
#include <unordered_map>
#include <utility>

#include <spdlog/fmt/fmt.h>

#include "kernel/program_path.hpp"
#include "programs/kerf/run/path_walk.hpp"

namespace kerf::program {

namespace {

bool is_compensated(const parser::UpcomingBlock& block) {
  constexpr std::int16_t kNone = 400;
  return block.state.cutter_compensation != kNone;
}

// Why nobody starts before it, as far as its modes tell.
std::string_view refusal_by_modes(const parser::UpcomingBlock& block) {
  if (block.in_curve) {
    return "it is within a curve of several blocks";
  }
  if (is_compensated(block)) {
    return "cutter compensation is on";
  }
  if (parser::is_cycle(block.state.motion)) {
    return "a canned cycle is in force";
  }
  return {};
}

class Search final : public PipelineObserver, public parser::BlockWatcher {
 public:
  struct Target {
    std::uint16_t file = 0;
    std::uint32_t line = 0;  // 0: none
    std::uint64_t round = 1;
    std::uint64_t block = std::numeric_limits<std::uint64_t>::max();  // the last place up to it
  };
  Search(const Target& target, bool knows_answers)
      : target_(target), knows_answers_(knows_answers) {}

  void about_to_run(const parser::UpcomingBlock& block) override {
    Candidate candidate{.file = block.source.file,
                        .place = {.line = block.source.line, .blocks_before = block.blocks_before},
                        .refused = refusal_by_modes(block)};
    if (is_beside_contour(block) && candidate.refused.empty()) {
      candidate.refused = "cutter compensation ends with its motion";
    }
    candidate.place.round = ++rounds_[(std::uint64_t{candidate.file} << 32U) | block.source.line];
    if (candidate.file == target_.file && candidate.place.line == target_.line &&
        candidate.place.round == target_.round) {
      found_.emplace(block);
      candidate.is_target = true;
    }
    // Of a block and the comments before it the block is named.
    if (!waiting_.empty() && !waiting_.back().is_target &&
        waiting_.back().place.blocks_before == block.blocks_before) {
      waiting_.pop_back();
    }
    waiting_.push_back(std::move(candidate));
  }

  void move(const parser::Move& move) override {
    const auto* event = std::get_if<parser::EventMove>(&move.shape);
    if (event != nullptr && parser::is_at_motion(event->kind)) {
      return;  // comes with the next
    }
    if (move.probes && !knows_answers_ && !first_probe_) {
      first_probe_ = move.block;
    }
    for (auto at = waiting_.rbegin(); at != waiting_.rend() && at->first_move == 0; ++at) {
      if (at->place.blocks_before < move.block) {
        at->first_move = move.block;
      }
    }
  }

  void output(std::uint64_t block) {
    while (!is_over() && !waiting_.empty() && waiting_.front().first_move != 0 &&
           waiting_.front().first_move <= block) {
      Candidate& candidate = waiting_.front();
      if (candidate.first_move < block && candidate.refused.empty()) {
        candidate.refused = "it is within a curve that G64 made of several lines";
      }
      judge(candidate);
      waiting_.pop_front();
    }
  }
  // Nothing moves after what is left.
  void end() {
    for (Candidate& candidate : waiting_) {
      if (!is_over()) {
        judge(candidate);
      }
    }
    over_ = true;
  }

  [[nodiscard]] bool is_over() const noexcept { return over_; }

  struct Place {
    std::uint16_t file = 0;
    LineRound place{};
  };
  struct Result {
    std::optional<parser::WatchedBlock> block;
    Place target;
    std::string_view refused;
    std::optional<Place> before;
    std::optional<Place> after;
  };
  [[nodiscard]] Result result() const {
    return {.block = found_,
            .target = judged_,
            .refused = refused_,
            .before = before_,
            .after = after_};
  }

 private:
  // After a G40 the tool is where compensation had it, and not in the program's place, until it
  // moves.
  bool is_beside_contour(const parser::UpcomingBlock& block) {
    if (is_compensated(block)) {
      compensated_mm_ = block.state.position_mm;
    } else if (compensated_mm_ != block.state.position_mm) {
      compensated_mm_.reset();
    }
    return compensated_mm_.has_value();
  }

  struct Candidate {
    std::uint16_t file = 0;
    LineRound place;
    std::string_view refused;
    std::uint64_t first_move = 0;  // the block of its first move, or of the first after it
    bool is_target = false;
  };

  [[nodiscard]] std::string_view refusal_of(const Candidate& candidate) const {
    const bool is_behind_probe = first_probe_ && candidate.place.blocks_before >= *first_probe_;
    return candidate.refused.empty() && is_behind_probe
               ? "it is after a probe, and what that found is not known"
               : candidate.refused;
  }

  void judge(const Candidate& candidate) {
    const Place place{.file = candidate.file, .place = candidate.place};
    const std::string_view refused = refusal_of(candidate);
    if (candidate.place.blocks_before >= target_.block) {
      over_ = true;
    } else if (candidate.is_target) {
      judged_ = place;
      refused_ = refused;
      over_ = refused_.empty();
    } else if (refused.empty() && judged_.place.line == 0) {
      before_ = place;
    } else if (refused.empty()) {
      after_ = place;
      over_ = true;
    }
  }

  Target target_;
  bool knows_answers_;
  std::optional<std::uint64_t> first_probe_;                 // parser::Move::block of it
  std::unordered_map<std::uint64_t, std::uint64_t> rounds_;  // of each line of each file
  std::optional<parser::Point> compensated_mm_;  // the program's place where it was on last
  std::deque<Candidate> waiting_;                // for the path that they begin with
  std::optional<parser::WatchedBlock> found_;
  Place judged_;
  std::string_view refused_;
  std::optional<Place> before_;
  std::optional<Place> after_;
  bool over_ = false;
};

// Of what was found, with the files' names.
struct Names {
  const parser::ProgramReader& reader;

  [[nodiscard]] LineRound operator()(const Search::Place& place) const {
    LineRound named = place.place;
    named.file = reader.file_name(place.file);
    return named;
  }
  [[nodiscard]] std::optional<LineRound> operator()(
      const std::optional<Search::Place>& place) const {
    return place ? std::optional((*this)(*place)) : std::nullopt;
  }
};

struct Searched {
  bool knows_answers = true;
  Search::Result result;
  LineRound place;
  std::optional<LineRound> before;
  std::optional<LineRound> after;
};

tl::expected<Searched, std::string> search(ProgramFile& file, const StartSearchOrder& order,
                                           const Search::Target& target) {
  Search search(target, order.knows_answers);
  KernelOptions options = order.options;
  options.start_in_program.reset();
  ProgramPath path(order.settings, options,
                   {.watcher = &search, .keeps_exact_lines_apart = true, .observer = &search});
  const auto ended = walk_path(file, path, [&search](const ProgramPath::Output& output) {
    search.output(first_block(output));
    return !search.is_over();
  });
  if (!ended) {
    return tl::unexpected(ended.error());
  }
  if (*ended) {
    search.end();
  }
  const Names named{path.reader()};
  const Search::Result result = search.result();
  return Searched{.knows_answers = order.knows_answers,
                  .result = result,
                  .place = named(result.target),
                  .before = named(result.before),
                  .after = named(result.after)};
}

tl::expected<FoundStart, std::string> found_of(tl::expected<Searched, std::string> searched,
                                               const std::string& otherwise) {
  if (!searched) {
    return tl::unexpected(searched.error());
  }
  if (!searched->result.block) {
    return tl::unexpected(otherwise);
  }
  const parser::WatchedBlock& block = *searched->result.block;
  return FoundStart{
      .start = {.place = searched->place,
                .block = block,
                .assumed_input_line = searched->knows_answers ? 0 : block.state.assumed_input_line},
      .refused = std::string(searched->result.refused),
      .before = searched->before,
      .after = searched->after};
}

}  // namespace

tl::expected<FoundStart, std::string> find_start(ProgramFile& file, const StartSearchOrder& order,
                                                 const StartLine& line) {
  return found_of(search(file, order, {.line = line.line, .round = line.round}),
                  line.round == 1
                      ? fmt::format("line {} is never run", line.line)
                      : fmt::format("line {} does not run {} times", line.line, line.round));
}

tl::expected<FoundStart, std::string> find_start_before(ProgramFile& file,
                                                        const StartSearchOrder& order,
                                                        std::uint64_t block) {
  auto place = search(file, order, {.block = block});
  if (!place) {
    return tl::unexpected(place.error());
  }
  const std::string none = fmt::format("there is no place to start at before block {}", block);
  if (!place->result.before) {
    return tl::unexpected(none);
  }
  file.rewind();
  const Search::Place& at = *place->result.before;
  return found_of(
      search(file, order, {.file = at.file, .line = at.place.line, .round = at.place.round}), none);
}

}  // namespace kerf::program
