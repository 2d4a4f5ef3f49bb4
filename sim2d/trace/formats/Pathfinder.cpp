#include <algorithm>

#include "sim2d/base/Text.h"
#include "sim2d/trace/TableColumns.h"

/// Pathfinder occupants as CSV: a line of column names (t, id or name, x, y …), a line of units (s,
/// m …), then a row per occupant and time. Rows with `active` 0 are skipped.
namespace sim2d {

namespace {

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

FormatMatch matchFormat(const FilePreview& preview) {
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

}  // namespace

void addPathfinder(TrackFormats& to) {
  to.add({"pathfinder", 13, matchFormat, readPathfinder, false, true});
}

}  // namespace sim2d
