#include <algorithm>

#include "sim2d/base/Text.h"
#include "sim2d/trace/TrackTable.h"

/// Tables with a header line; the user may assign columns to quantities. Comments may precede it
/// and may state the frame rate.
namespace sim2d {

namespace {

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
FormatMatch matchFormat(const FilePreview& preview) {
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

}  // namespace

void addCsv(TrackFormats& to) {
  to.add({"csv", 0, matchFormat, readCsv, true, true});
}

}  // namespace sim2d
