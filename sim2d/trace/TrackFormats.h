#pragma once

#include <algorithm>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "sim2d/base/Text.h"
#include "sim2d/map/Outlines.h"
#include "sim2d/trace/Csv.h"
#include "sim2d/trace/TrackImport.h"

/// Shared parts of the format readers, and their registry. Problems are appended to the list given.
namespace sim2d {

/// A word of a text file with line and column, from 1.
struct Word {
  std::string_view text;
  int line = 1, column = 1;
};

/// Splits lines at blanks, tabs and commas; skips empty lines. The text must outlive it.
class TextRows {
 public:
  /// `comment` starts a comment; '-' only where it does not begin a number.
  explicit TextRows(std::string_view text, char comment = '#') : text_(text), comment_(comment) {}
  bool next(std::vector<Word>& row);

 private:
  std::string_view withoutComment(std::string_view line) const;

  std::string_view text_;
  char comment_;
  std::size_t position_ = 0;
  int line_ = 0;
};

/// Parses numbers of a third-party file; problems are reported with file, line and column, up to a
/// limit.
class WordReader {
 public:
  WordReader(std::string file, base::Diagnostics& problems)
      : file_(std::move(file)), problems_(problems) {}

  /// False: too many problems; reading should stop.
  bool isUsable() const { return problems_.size() < kMaxProblems; }
  void error(const Word& at, std::string_view code, base::ProblemValues values = {});
  std::optional<double> finite(const Word& word, const char* name);
  /// Also accepts a point or an exponent: "12.0", "7.8e+02".
  std::optional<long long> whole(const Word& word, const char* name);
  const std::string& file() const { return file_; }

 private:
  static constexpr std::size_t kMaxProblems = 100000;  // 300 bytes per problem

  std::string file_;
  base::Diagnostics& problems_;
};

std::string_view withoutBlanks(std::string_view text);
/// A unit in lower case, without blanks and brackets: "[m]", "(s)".
std::string unitWord(std::string_view text);
/// Replaces a decimal comma, which is possible with semicolon separators; other words are
/// unchanged.
std::string withPoint(std::string_view word, char separator);
/// [m] per unit, in lower case: "m", "cm", "mm", "ft", also spelled out.
std::optional<double> lengthUnitOf(std::string_view word);
/// [s] per unit: "s", "ms", "us", "ns", "min", also spelled out.
std::optional<double> timeUnitOf(std::string_view word);
/// [m] per unit, for the first unit of length in a lower-case text.
std::optional<double> lengthUnitIn(std::string_view text);

/// The comments before the first row, in lower case and without comment marks.
std::vector<std::string> leadingComments(std::string_view text, char mark = '#');
/// The frame rate [1/s] stated in a comment ("framerate: 25 fps", "fps=25"); 0: none.
double statedRate(const std::vector<std::string>& comments);

struct TrackInput {
  const std::string& path;
  const std::string& text;
  const TrackImportOptions& options;
  base::Diagnostics& problems;

  /// Adds a problem of this file; line 0: of the whole file.
  void error(std::string_view code, base::ProblemValues values = {}, int line = 0,
             int column = 0) const {
    problems.push_back(base::error(code, std::move(values), path, line, column));
  }
  void warning(std::string_view code, base::ProblemValues values = {}) const {
    problems.push_back(base::warning(code, std::move(values), path));
  }
  /// The frame rate given by the user, else the stated one [1/s].
  double rateOr(double stated) const {
    return options.framesPerSecond > 0.0 ? options.framesPerSecond : stated;
  }
};

/// The beginning of a file, to detect its format.
struct FilePreview {
  const std::string& path;
  std::string_view text;
  std::vector<Word> row;   // first row that is not empty
  bool isNumbers = false;  // the row has only numbers

  /// Whether the first 4096 bytes contain the text.
  bool mentions(std::string_view words) const;
  bool endsWith(std::string_view end) const { return base::endsWith(path, end); }
};

/// How well a file matches a format; the highest match is used.
enum class FormatMatch { None, Fallback, ByContent, ByName };

struct TrackFormat {
  std::string name;  // value of --format
  int order = 0;     // position in the list of formats
  FormatMatch (*matchFormat)(const FilePreview& preview) = nullptr;
  TrackFile (*read)(const TrackInput& input) = nullptr;
  bool takesDegrees = false;  // --degrees applies to its angles
  bool takesColumns = false;  // --columns assigns its columns
};

/// Registry of formats by name. A file Foo.cpp in formats/ defines addFoo(TrackFormats&).
class TrackFormats {
 public:
  void add(const TrackFormat& format) {
    const auto isBefore = [](const TrackFormat& a, const TrackFormat& b) {
      return a.name < b.name;
    };
    formats_.insert(std::upper_bound(formats_.begin(), formats_.end(), format, isBefore), format);
  }
  const TrackFormat* find(const std::string& name) const;  // null: unknown name
  /// The best match that is at least `least`; null: none.
  const TrackFormat* formatOf(const std::string& path, const std::string& text,
                              FormatMatch least = FormatMatch::Fallback) const;
  std::vector<std::string> names() const;

 private:
  std::vector<TrackFormat> formats_;
};

constexpr double kAnnotationStep = 0.4;  // [s], frame interval of ETH, UCY and TrajNet data sets

/// An observation at this place of the source.
TrackPoint pointAt(const Word& place, double time, const Vec2& position);
/// In the order of the ids.
std::vector<Track> tracksOf(std::map<int, Track> byId);

/// Collects observations by body, with frame numbers as times.
class FrameTracks {
 public:
  /// `line`, `column`: place in the source. Returns the point, to add further quantities.
  TrackPoint& add(int id, long long frame, const Vec2& position, int line, int column);
  /// Parses the words and adds the point; null: a word is invalid, which is reported.
  TrackPoint* add(WordReader& words, const Word& frame, const Word& id, const Word& x,
                  const Word& y);
  TrackFile finish(const std::string& path, double framesPerSecond);
  /// False: frame numbers decrease too often, so the file is rejected.
  bool isUsable() const { return backwards_ < kMaxBackwards; }

 private:
  static constexpr std::size_t kMaxBackwards = 10000;

  std::map<int, Track> tracks_;
  std::size_t backwards_ = 0;  // decreasing frame numbers
};

/// Converts frame numbers to seconds: with the rate, or (rate 0) so that the median step between
/// two observations is kAnnotationStep.
void framesToSeconds(TrackFile& file, double framesPerSecond);

/// Whether rows of numbers begin with id and frame rather than frame and id: that order gives
/// shorter steps.
bool hasIdsFirst(std::string_view text);

/// Column indices, from 0, of a format without column names: the default order, or the column
/// numbers given by the user. Invalid numbers are reported.
std::vector<std::size_t> numberedColumns(const TrackInput& input,
                                         const std::vector<const char*>& names, std::size_t most);

/// The frame rate given by the user, else the stated one; 0 and an error if neither exists.
double rateOf(const TrackInput& input, double stated);

/// Limit [bytes] for the unpacked content of a compressed file, by its size.
constexpr std::uint64_t maxUnpackedSize(std::uint64_t fileSize) {
  constexpr std::size_t kOfAny = std::size_t{16} << 20U;
  constexpr std::uint64_t kPerByte = 100;
  return kOfAny + kPerByte * fileSize;
}

/// The path of a file of this name in the folder of `path`.
std::string siblingPath(const std::string& path, const std::string& name);
/// Reads groups.txt, if it exists: the ids of one group per line. Groups are numbered from 1.
void readGroupsFile(const TrackInput& input, TrackFile& file);

/// Borders of the polygons in a WKT text ("POLYGON ((0 0, 4 0, 4 3), (1 1, 2 1, 2 2))", also
/// MULTIPOLYGON and collections), in which people walk: outside and holes are solid. Other shapes
/// are ignored. Errors: not WKT, or no polygon.
base::Result<std::vector<Outline>> walkableOutlines(const std::string& wkt);

/// Adds the borders, scaled by `unit` [m], as walls of the file. Invalid WKT causes a warning; an
/// empty text is ignored.
void addWalkableArea(const std::string& wkt, double unit, const TrackInput& input, TrackFile& file);

/// Reports the numbers assigned to named bodies (the first ones if there are many).
void reportAssignedIds(const TrackInput& input, const std::vector<const Track*>& numbered);

/// Parses an id, which must not be negative.
std::optional<int> idOf(WordReader& words, const Word& word);

/// Calls `take` with the words of each row that has `width` words.
template <class Take>
void forEachRow(const TrackInput& input, std::size_t width, const char* columns, Take take) {
  WordReader words(input.path, input.problems);
  TextRows rows(input.text);
  std::vector<Word> row;
  while (words.isUsable() && rows.next(row)) {
    if (row.size() == width) {
      take(words, row);
    } else {
      words.error(row.back(), "tracks.number-count", {row.size(), width, columns});
    }
  }
}

struct TableLayout {
  /// Column names by quantity: "time", "frame", "id", "x", "y", "heading", "vx", "vy", "omega",
  /// "group", "radius", "kind", "active" (rows with 0 are skipped). The first existing name is
  /// used; names given by the user take precedence. A unit may follow the name: "x [mm]", "t (s)".
  std::map<std::string, std::vector<std::string>> names;
  std::string_view text;  // beginning with the line of column names
  int firstLine = 1;      // line number of its start
  char separator = ',';
  std::map<std::string, std::string> units;  // by column name, if given separately
  double rate = 0.0;                         // frame rate stated in the file [1/s]
  std::string prefix;                        // text before the first name
};

/// Column names of the csv format: the names of the quantities.
std::map<std::string, std::vector<std::string>> ownColumnNames();

/// The first of comma, semicolon and tab that occurs in a line.
char separatorIn(std::string_view line);

/// Reads the rows. A second line with units is supported. Units given by the user take precedence.
TrackFile readTrackTable(const TrackInput& input, const TableLayout& layout);

}  // namespace sim2d
