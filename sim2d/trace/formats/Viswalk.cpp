#include <algorithm>

#include "sim2d/base/Text.h"
#include "sim2d/trace/TrackTable.h"

/// PTV Viswalk pedestrian records (.pp): comments with a line "* NAME: … [unit]" per attribute, the
/// attribute names after "$PEDESTRIAN:", then rows; fields are separated by semicolons.
namespace sim2d {

namespace {

constexpr std::string_view kTable = "$PEDESTRIAN:";

/// Position of the line of attribute names; npos: none.
std::size_t tableIn(std::string_view text) {
  std::size_t at = text.find(kTable);
  while (at != std::string_view::npos && at > 0 && text[at - 1] != '\n') {
    at = text.find(kTable, at + 1);
  }
  return at;
}

/// Units by attribute name in lower case, from "* COORDCENTX: CoordCentX, Coordinate of the centre
/// (x) [m]".
std::map<std::string, std::string> unitsIn(std::string_view comments) {
  std::map<std::string, std::string> units;
  for (const std::string& line : leadingComments(comments, '*')) {
    const std::size_t colon = line.find(':');
    const std::size_t open = line.rfind('[');
    if (colon != std::string::npos && open != std::string::npos && open > colon &&
        line.back() == ']') {
      units[base::trimmed(line.substr(0, colon))] =
          base::trimmed(line.substr(open + 1, line.size() - open - 2));
    }
  }
  return units;
}

TrackFile readRecord(const TrackInput& input) {
  const std::string_view text = input.text;
  const std::size_t begin = tableIn(text);
  if (begin == std::string_view::npos) {
    input.error("tracks.no-table", {"$PEDESTRIAN:SIMSEC;NO;COORDCENTX;COORDCENTY"});
    return {};
  }
  std::string_view comments = text.substr(0, begin);
  if (const std::size_t first = comments.find('\n');
      comments.substr(0, 1) == "$" && first != std::string_view::npos) {
    comments.remove_prefix(first + 1);  // "$VISION"
  }
  TableLayout layout;
  layout.names = {
      {"time", {"SIMSEC"}}, {"id", {"NO"}}, {"x", {"COORDCENTX"}}, {"y", {"COORDCENTY"}}};
  layout.text = text.substr(begin);
  layout.firstLine = 1 + static_cast<int>(std::count(text.begin(), text.begin() + begin, '\n'));
  layout.separator = ';';
  layout.prefix = kTable;
  layout.units = unitsIn(comments);
  return readTrackTable(input, layout);
}

FormatMatch matchFormat(const FilePreview& preview) {
  constexpr std::size_t kPreviewSize = 65536;  // searched before the table
  const bool isTable = tableIn(preview.text.substr(0, kPreviewSize)) != std::string_view::npos;
  return isTable ? FormatMatch::ByContent : FormatMatch::None;
}

}  // namespace

void addViswalk(TrackFormats& to) {
  to.add({"viswalk", 14, matchFormat, readRecord, false, true});
}

}  // namespace sim2d
