#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "sim2d/trace/ForeignFiles.h"

/// What the readers of the formats share, and where they register. Problems are added.
namespace sim2d {

/// A word of a text file with its place, both from 1.
struct Word {
  std::string_view text;
  int line = 1, column = 1;
};

/// Lines of words between blanks, tabs and commas. Empty lines are passed over. The text must
/// outlive the reader.
class TextRows {
 public:
  /// What follows the mark is a comment. A '-' is one only where no number begins with it.
  explicit TextRows(std::string_view text, char comment = '#') : text_(text), comment_(comment) {}
  bool next(std::vector<Word>& row);

 private:
  std::string_view withoutComment(std::string_view line) const;

  std::string_view text_;
  char comment_;
  std::size_t position_ = 0;
  int line_ = 0;
};

/// Numbers of a foreign file; every problem is noted with file, line and column, up to a limit.
class WordReader {
 public:
  WordReader(std::string file, base::Diagnostics& problems)
      : file_(std::move(file)), problems_(problems) {}

  /// False: there were so many problems that the rest of the file need not be read.
  bool isUsable() const { return problems_.size() < kMostProblems; }
  void error(const Word& at, std::string_view code, base::ProblemValues values = {});
  std::optional<double> finite(const Word& word, const char* name);
  /// Also written with a point or an exponent: "12.0", "7.8e+02".
  std::optional<long long> whole(const Word& word, const char* name);
  const std::string& file() const { return file_; }

 private:
  static constexpr std::size_t kMostProblems = 100000;  // 300 bytes each

  std::string file_;
  base::Diagnostics& problems_;
};

/// [m] of a unit of length in lower case: "m", "cm", "mm", "ft", also spelled out.
std::optional<double> lengthUnitOf(std::string_view word);
/// [s] of "s", "ms", "us", "ns", "min", also spelled out.
std::optional<double> timeUnitOf(std::string_view word);
/// [m] of the first word in a lower-case text that is a unit of length.
std::optional<double> lengthUnitIn(std::string_view text);

/// The comments before the first row of a text: in lower case, without their marks.
std::vector<std::string> leadingComments(std::string_view text, char mark = '#');
/// Frames per second that a comment states ("framerate: 25 fps", "fps=25"); 0: none does.
double statedRate(const std::vector<std::string>& comments);

struct ForeignInput {
  const std::string& path;
  const std::string& text;
  const ForeignOptions& options;
  base::Diagnostics& problems;
};

/// What can be told of a file at a glance.
struct FirstLook {
  const std::string& path;
  std::string_view text;
  std::vector<Word> row;   // the first that is not empty
  bool isNumbers = false;  // nothing else in it

  /// Its first kilobytes hold these words.
  bool mentions(std::string_view words) const;
  bool endsWith(std::string_view end) const {
    return path.size() >= end.size() &&
           path.compare(path.size() - end.size(), end.size(), end) == 0;
  }
};

/// How surely a file is of a format; the highest claim wins.
enum class Claim { None, Fallback, ByContent, ByName };

struct TrackFormat {
  std::string name;  // of --format
  int order = 0;     // in the list of names
  Claim (*claim)(const FirstLook& look) = nullptr;
  TrackFile (*read)(const ForeignInput& input) = nullptr;
  bool takesDegrees = false;  // its angles may be in degrees, if the user says so
  bool takesColumns = false;  // the user may say which column is what
};

/// The formats that can be read. A file Foo.cpp in formats/ defines addFoo(TrackFormats&).
class TrackFormats {
 public:
  void add(TrackFormat format) { formats_.push_back(std::move(format)); }
  const TrackFormat* find(const std::string& name) const;  // null: there is none
  /// Null: nobody claims it, or not that surely.
  const TrackFormat* formatOf(const std::string& path, const std::string& text,
                              Claim least = Claim::Fallback) const;
  std::vector<std::string> names() const;

 private:
  std::vector<TrackFormat> formats_;
};

constexpr double kAnnotationStep = 0.4;  // [s] of the ETH, UCY and TrajNet sets

/// Observations by person, numbered by frames of a film.
class FrameTracks {
 public:
  /// `line`, `column`: where it stands in the source. The point, for what else is known of it.
  TrackPoint& add(int id, long long frame, const Vec2& position, int line, int column);
  /// The same from its words; null when one of them is wrong, which is noted.
  TrackPoint* add(WordReader& words, const Word& frame, const Word& id, const Word& x,
                  const Word& y);
  TrackFile finish(const std::string& path, double framesPerSecond);
  /// False: the frames of bodies decrease so often that the file is refused.
  bool isUsable() const { return backwards_ < kMostBackwards; }

 private:
  static constexpr std::size_t kMostBackwards = 10000;

  std::map<int, Track> tracks_;
  std::size_t backwards_ = 0;  // frames that do not follow the one before
};

/// Times that count frames become seconds: by the rate, or (0) so that the median step between two
/// observations is kAnnotationStep.
void framesToSeconds(TrackFile& file, double framesPerSecond);

/// Rows of numbers that begin with id and frame, not with frame and id: the paths that follow from
/// the first reading have shorter steps.
bool beginWithIds(std::string_view text);

/// Positions of the columns of a format without names, from 0: as usual, or by the numbers from 1
/// that the user gave. Wrong numbers are noted.
std::vector<std::size_t> numberedColumns(const ForeignInput& input,
                                         const std::vector<const char*>& names, std::size_t most);

/// The rate that the user gave, else the one that the file states; 0 and an error: neither.
double rateOf(const ForeignInput& input, double stated);

/// Bytes that a file of a size may unpack to, by its own compression.
constexpr std::uint64_t mostUnpacked(std::uint64_t fileSize) {
  constexpr std::size_t kOfAny = std::size_t{16} << 20U;
  constexpr std::uint64_t kPerByte = 100;
  return kOfAny + kPerByte * fileSize;
}

/// The file of this name beside `path`.
std::string besideFile(const std::string& path, const std::string& name);
/// Ids of a group per line, if the file is there; groups are numbered from 1.
void readGroupsBeside(const ForeignInput& input, TrackFile& file);

/// Tells the numbers that stand for the names of bodies; of many, the first.
void tellNumbers(const ForeignInput& input, const std::vector<const Track*>& numbered);

/// An id that is not negative.
std::optional<int> idOf(WordReader& words, const Word& word);

/// Calls `take` with the words of each row that has `width` of them.
template <class Take>
void forEachRow(const ForeignInput& input, std::size_t width, const char* columns, Take take) {
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

}  // namespace sim2d
