#include <algorithm>

#include "sim2d/base/Text.h"
#include "sim2d/trace/TrackFormats.h"

/// Tables with a line of column names.
namespace sim2d {

namespace {

// Tables with a header line; the user may assign columns to quantities. Comments may precede it
// and may state the frame rate.

constexpr char kComment = '#';

/// The line that begins at `begin`, without its end.
std::string_view lineAt(std::string_view text, std::size_t begin) {
  const std::size_t end = std::min(text.find('\n', begin), text.size());
  return text.substr(begin, end - begin);
}

bool isNumberLine(std::string_view line) {
  return base::parseDouble(base::trimmed(line.substr(0, line.find_first_of(",;\t")))).has_value();
}

TrackFile readCsv(const TrackInput& input) {
  TableLayout layout;
  layout.names = ownColumnNames();
  const std::string_view text = input.text;
  std::size_t begin = 0;
  std::string_view last;  // last comment line
  for (; begin < text.size() && text[begin] == kComment; ++layout.firstLine) {
    last = lineAt(text, begin);
    begin += last.size() + 1;
  }
  begin = std::min(begin, text.size());
  layout.rate = statedRate(leadingComments(text, kComment));
  const bool isNamesInComment = !last.empty() && isNumberLine(lineAt(text, begin)) &&
                                last.find_first_of(",;\t") != std::string_view::npos;
  if (isNamesInComment) {  // "# time,id,x,y"
    layout.prefix = kComment;
    begin = static_cast<std::size_t>(last.data() - text.data());
    --layout.firstLine;
  }
  layout.text = text.substr(begin);
  layout.separator = separatorIn(lineAt(text, begin));
  return readTrackTable(input, layout);
}

/// Column names are arbitrary; a table with the default names is recognised with certainty.
FormatMatch matchCsv(const FilePreview& preview) {
  const auto holds = [&preview](std::string_view name) {
    return std::any_of(preview.row.begin(), preview.row.end(),
                       [name](const Word& word) { return word.text == name; });
  };
  const bool isOurs = (holds("time") || holds("frame")) && holds("id") && holds("x") && holds("y");
  const bool isOther = preview.text.substr(0, 4096).find('\0') != std::string_view::npos ||
                       (!preview.row.empty() && (preview.row.front().text.front() == '{' ||
                                                 preview.row.front().text.front() == '['));
  return isOurs ? FormatMatch::ByContent : isOther ? FormatMatch::None : FormatMatch::Fallback;
}

// Pathfinder occupants as CSV: a line of column names (t, id or name, x, y …), a line of units (s,
// m …), then a row per occupant and time. Rows with `active` 0 are skipped.

TableLayout layoutOf(std::string_view text) {
  TableLayout layout;
  layout.names = {{"time", {"t", "time"}},
                  {"id", {"id", "occupant id", "occupant", "name"}},
                  {"x", {"x"}},
                  {"y", {"y"}},
                  {"active", {"active"}}};
  layout.text = text;
  layout.separator = separatorIn(text.substr(0, text.find('\n')));
  return layout;
}

TrackFile readPathfinder(const TrackInput& input) {
  return readTrackTable(input, layoutOf(input.text));
}

FormatMatch matchPathfinder(const FilePreview& preview) {
  constexpr std::size_t kTwoLines = 65536;  // [B] at most
  const std::string_view beginning = preview.text.substr(0, kTwoLines);
  const TableLayout layout = layoutOf(beginning);
  CsvReader reader(beginning, layout.separator);
  CsvRow names;
  CsvRow units;
  if (!reader.next(names) || !reader.next(units) || names.size() != units.size()) {
    return FormatMatch::None;
  }
  const auto unitBelow = [&](const char* name) -> std::optional<std::string> {
    const auto at = std::find_if(names.begin(), names.end(), [name](const CsvField& field) {
      return base::toLower(withoutBlanks(field.text)) == name;
    });
    if (at == names.end()) {
      return std::nullopt;
    }
    return unitWord(units[static_cast<std::size_t>(at - names.begin())].text);
  };
  const auto isLength = [&](const char* name) {
    return lengthUnitOf(unitBelow(name).value_or("")).has_value();
  };
  const auto time = unitBelow("t") ? unitBelow("t") : unitBelow("time");
  const bool isTime = time && (time->empty() || timeUnitOf(*time));  // seconds without a unit
  return isTime && isLength("x") && isLength("y") ? FormatMatch::ByContent : FormatMatch::None;
}

// PTV Viswalk pedestrian records (.pp): comments with a line "* NAME: … [unit]" per attribute, the
// attribute names after "$PEDESTRIAN:", then rows; fields are separated by semicolons.

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

TrackFile readViswalk(const TrackInput& input) {
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

FormatMatch matchViswalk(const FilePreview& preview) {
  constexpr std::size_t kPreviewSize = 65536;  // searched before the table
  const bool isTable = tableIn(preview.text.substr(0, kPreviewSize)) != std::string_view::npos;
  return isTable ? FormatMatch::ByContent : FormatMatch::None;
}

}  // namespace

void addTables(TrackFormats& to) {
  to.add({"csv", 0, matchCsv, readCsv, true, true});
  to.add({"pathfinder", 13, matchPathfinder, readPathfinder, false, true});
  to.add({"viswalk", 14, matchViswalk, readViswalk, false, true});
}

}  // namespace sim2d
