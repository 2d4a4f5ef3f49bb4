#include "sim2d/trace/TruncatedRecording.h"

#include <algorithm>
#include <cstdint>
#include <filesystem>

#include "sim2d/base/Text.h"

namespace sim2d {

namespace fs = std::filesystem;

bool Truncation::has(std::string_view name) const {
  return std::find(files.begin(), files.end(), name) != files.end();
}

void Truncation::note(const std::string& name) {
  if (!has(name)) {
    files.push_back(name);
  }
}

std::size_t completeLinesSize(std::string_view text) {
  std::size_t whole = 0;
  bool isQuoted = false;
  for (std::size_t k = 0; k < text.size(); ++k) {
    if (text[k] == '"') {
      isQuoted = !isQuoted;
    } else if (text[k] == '\n' && !isQuoted) {
      whole = k + 1;
    }
  }
  return whole;
}

std::string finalOrTemporaryPath(const std::string& folder, const std::string& name) {
  const fs::path usual = fs::path(folder) / name;
  std::error_code error;
  if (fs::exists(usual, error)) {
    return usual.string();
  }
  const std::string stem = name + ".new-";
  for (fs::directory_iterator at(folder, error), end; !error && at != end; at.increment(error)) {
    if (base::startsWith(at->path().filename().string(), stem)) {
      return at->path().string();
    }
  }
  return usual.string();
}

void dropIncompletePart(Trace& trace, bool lacksRobot, Truncation& cut) {
  constexpr const char* kTrajectory = "trajectory.csv";
  const bool hasStop = !trace.events.empty() && trace.events.back().second.kind == EventKind::Stop;
  const std::int64_t last = trace.frames.empty() ? -1 : trace.frames.back().step;
  if (hasStop) {
    const std::int64_t every = trace.header.recordEvery;
    const std::int64_t end = trace.events.back().first;
    cut.end = static_cast<double>(end) * trace.header.dt;
    if (!trace.header.robots.empty() && end / every * every > last) {
      cut.note(kTrajectory);
    }
  }
  if (lacksRobot) {
    cut.note(kTrajectory);
  }
  if (!cut.isTruncated()) {
    return;
  }
  if (cut.has(kTrajectory) && !trace.frames.empty()) {
    trace.frames.pop_back();  // bodies may be missing in it
  }
  cut.time = trace.frames.empty() ? 0.0 : trace.frames.back().time;
  const std::int64_t kept = trace.frames.empty() ? -1 : trace.frames.back().step;
  trace.events.erase(std::find_if(trace.events.begin(), trace.events.end(),
                                  [kept](const auto& each) { return each.first > kept; }),
                     trace.events.end());
}

}  // namespace sim2d
