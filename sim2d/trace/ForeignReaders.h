#pragma once

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

/// Numbers of a foreign file; every problem is noted with file, line and column.
class WordReader {
 public:
  WordReader(std::string file, base::Diagnostics& problems)
      : file_(std::move(file)), problems_(problems) {}

  void error(const Word& at, std::string_view code, base::ProblemValues values = {});
  std::optional<double> finite(const Word& word, const char* name);
  /// Also written with a point or an exponent: "12.0", "7.8e+02".
  std::optional<long long> whole(const Word& word, const char* name);
  const std::string& file() const { return file_; }

 private:
  std::string file_;
  base::Diagnostics& problems_;
};

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

 private:
  std::map<int, Track> tracks_;
};

/// Times that count frames become seconds: by the rate, or (0) so that the median step between two
/// observations is kAnnotationStep.
void framesToSeconds(TrackFile& file, double framesPerSecond);

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
  while (rows.next(row)) {
    if (row.size() == width) {
      take(words, row);
    } else {
      words.error(row.back(), "tracks.number-count", {row.size(), width, columns});
    }
  }
}

}  // namespace sim2d
