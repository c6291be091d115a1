#include "programs/kerf/run/flight_recorder.hpp"

#include "programs/kerf/run/trace_writer.hpp"

namespace kerf::program {

std::vector<TickRecord> FlightRecorder::ticks() const {
  std::vector<TickRecord> ticks;
  const std::size_t count = std::min(added_, ring_.size());
  for (std::size_t i = added_ - count; i < added_; ++i) {
    ticks.push_back(ring_[i % ring_.size()]);
  }
  return ticks;
}

std::optional<std::string> FlightRecorder::write(const Target& target) const {
  auto file =
      TraceWriter::create(target.path, {.period_s = target.period_s, .columns = target.columns});
  if (!file) {
    return file.error();
  }
  for (const TickRecord& record : ticks()) {
    file->add(record);
  }
  file->close();
  return file->error();
}

}  // namespace kerf::program
