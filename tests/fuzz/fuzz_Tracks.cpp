#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <unistd.h>

#include "metrics/Report.h"
#include "sim2d/trace/TrackFormats.h"
#include "sim2d/trace/TrackImport.h"
#include "tests/fuzz/Require.h"

/// Any bytes as ways of people; the first line names the format, or the file (by which the format
/// is found). Read, put on a time grid and measured with the first person as the robot.
namespace {

constexpr const char* kNames[] = {"ways.csv",  "ways.vsp", "ways.ndjson", "ways.traj",
                                  "ways.json", "ways.txt", "ways.h5",     "ways.pp"};
constexpr std::size_t kMostFrames = 2000;  // more of the same costs time

/// A folder for one file, with the matrix that the format vsp wants beside it.
class Folder {
 public:
  Folder() {
    std::filesystem::create_directories(path_);
    std::ofstream(path_ / "H.txt") << "0.02 0 0\n0 0.02 0\n0 0 1\n";
  }
  ~Folder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;
  Folder(Folder&&) = delete;
  Folder& operator=(Folder&&) = delete;

  std::string write(const std::string& name, const std::string& bytes) const {
    std::string path = (path_ / name).string();
    std::ofstream file(path, std::ios::binary);
    file << bytes;
    file.close();
    require(file.good(), "there is room for the file");
    return path;
  }

 private:
  std::filesystem::path path_ =
      std::filesystem::temp_directory_path() / ("fuzz_Tracks." + std::to_string(getpid()));
};

void checkFrames(const sim2d::Trace& trace) {
  double last = -1.0;
  for (const sim2d::Frame& frame : trace.frames) {
    require(frame.time > last, "time goes on");
    last = frame.time;
    for (std::size_t i = 0; i < frame.humans.size(); ++i) {
      require(std::isfinite(frame.humans.x[i]) && std::isfinite(frame.humans.y[i]),
              "people are somewhere");
    }
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string all(reinterpret_cast<const char*>(data), size);
  const std::size_t line = all.find('\n');
  if (line == std::string::npos) {
    return 0;
  }
  sim2d::TrackImportOptions reading;
  const std::string format = all.substr(0, line);
  reading.format = sim2d::standardTrackFormats().find(format) != nullptr ? format : "";
  reading.lengthUnit = format == "sdd" ? 0.05 : 0.0;
  const bool isName = std::find(std::begin(kNames), std::end(kNames), format) != std::end(kNames);
  static const Folder kFolder;
  const base::Result<sim2d::TrackFile> tracks =
      sim2d::importTracks(kFolder.write(isName ? format : "ways", all.substr(line + 1)), reading);
  if (!tracks) {
    require(base::hasErrors(tracks.diagnostics()), "what is not read has an error");
    return 0;
  }
  sim2d::TrackOptions options;
  if (!tracks->tracks.empty()) {
    options.robotId = tracks->tracks.front().id;
  }
  const base::Result<sim2d::Trace> trace = sim2d::traceOfTracks(*tracks, options);
  if (trace && trace->frames.size() < kMostFrames) {
    checkFrames(*trace);
    require(static_cast<bool>(metrics::evaluate(*trace, {}, {})), "a record can be measured");
  }
  return 0;
}
