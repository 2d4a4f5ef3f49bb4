#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>

#include "sim2d/trace/Tracks.h"

/// Trajectories that other programs and data sets hold (FORMATS of the README).
namespace sim2d {

enum class ForeignFormat { Csv, Eth, Vsp, Trajnet, Socnavbench };
const char* foreignFormatName(ForeignFormat format);  // "csv" …
std::optional<ForeignFormat> foreignFormatOf(std::string_view name);

struct ForeignOptions {
  std::optional<ForeignFormat> format;         // none: by name and first line of the file
  std::map<std::string, std::string> columns;  // ours -> name in the file
  double framesPerSecond = 0.0;                // 0: see the README
};

/// "time=t,id=ped"; unknown names of ours and pairs without '=' are errors.
base::Result<std::map<std::string, std::string>> parseColumns(const std::string& text);

/// Reads the file and what lies beside it (`H.txt`, `groups.txt`). All problems, with their places.
base::Result<TrackFile> readForeign(const std::string& path, const ForeignOptions& options);

}  // namespace sim2d
