#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>

#include <nlohmann/json.hpp>

#include "sim2d/trace/TrackFormats.h"

/// Parses third-party JSON. Private to the folder.
namespace sim2d {

/// The error of a text that is not JSON, with line and column of the byte (from 1).
base::Diagnostic jsonSyntaxError(std::string_view text, std::size_t byte, const std::string& file);
/// None: the text is not JSON, which is reported with line and column.
std::optional<nlohmann::json> parseJsonInput(const TrackInput& input);

/// Line numbers, from 1, of the object members in a JSON text.
class JsonLineIndex {
 public:
  /// Empty for invalid JSON.
  explicit JsonLineIndex(const std::string& text);

  /// `path`: "humans[3].radius". Without a line of its own, the line of the nearest parent; 0: none
  /// exists.
  int lineOf(std::string path) const;

 private:
  std::map<std::string, int> lines_;  // by path
};

}  // namespace sim2d
