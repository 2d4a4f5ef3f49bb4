#include "sim2d/trace/ForeignReaders.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <utility>

#include "sim2d/base/Text.h"

namespace sim2d {
namespace {

bool isBlank(char c) {
  return c == ' ' || c == '\t' || c == '\r' || c == ',';
}

bool beginsNumber(std::string_view text, std::size_t minus) {
  const char next = minus + 1 < text.size() ? text[minus + 1] : ' ';
  return (next >= '0' && next <= '9') || next == '.';
}

}  // namespace

std::string_view TextRows::withoutComment(std::string_view line) const {
  for (std::size_t k = line.find(comment_); k != std::string_view::npos;
       k = line.find(comment_, k + 1)) {
    const bool inWord =
        comment_ == '-' && (beginsNumber(line, k) || (k > 0 && !isBlank(line[k - 1])));
    if (!inWord) {
      return line.substr(0, k);
    }
  }
  return line;
}

bool TextRows::next(std::vector<Word>& row) {
  row.clear();
  while (row.empty() && position_ < text_.size()) {
    const std::size_t end = std::min(text_.find('\n', position_), text_.size());
    const std::string_view line = withoutComment(text_.substr(position_, end - position_));
    position_ = end + 1;
    ++line_;
    for (std::size_t k = 0; k < line.size();) {
      if (isBlank(line[k])) {
        ++k;
        continue;
      }
      const std::size_t begin = k;
      while (k < line.size() && !isBlank(line[k])) {
        ++k;
      }
      row.push_back({line.substr(begin, k - begin), line_, static_cast<int>(begin) + 1});
    }
  }
  return !row.empty();
}

void WordReader::error(const Word& at, std::string_view code, base::ProblemValues values) {
  problems_.push_back(base::error(code, std::move(values), file_, at.line, at.column));
}

std::optional<double> WordReader::finite(const Word& word, const char* name) {
  const std::optional<double> value = base::parseDouble(word.text);
  if (!value || !std::isfinite(*value)) {
    error(word, "trace.not-finite", {name, word.text});
    return std::nullopt;
  }
  return value;
}

std::optional<long long> WordReader::whole(const Word& word, const char* name) {
  constexpr double kLargest = 2e9;
  const std::optional<double> value = base::parseDouble(word.text);
  if (!value || !(std::fabs(*value) <= kLargest) || *value != std::floor(*value)) {
    error(word, "trace.not-whole", {name, word.text});
    return std::nullopt;
  }
  return static_cast<long long>(*value);
}

TrackPoint& FrameTracks::add(int id, long long frame, const Vec2& position, int line, int column) {
  Track& track = tracks_[id];
  track.id = id;
  TrackPoint& point = track.points.emplace_back();
  point.time = static_cast<double>(frame);
  point.position = position;
  point.line = line;
  point.column = column;
  return point;
}

std::optional<int> idOf(WordReader& words, const Word& word) {
  const std::optional<long long> id = words.whole(word, "the id");
  if (id && *id < 0) {
    words.error(word, "tracks.negative-id");
    return std::nullopt;
  }
  return id ? std::make_optional(static_cast<int>(*id)) : std::nullopt;
}

TrackPoint* FrameTracks::add(WordReader& words, const Word& frame, const Word& id, const Word& x,
                             const Word& y) {
  const std::optional<long long> itsFrame = words.whole(frame, "the frame");
  const std::optional<int> itsId = idOf(words, id);
  const std::optional<double> itsX = words.finite(x, "x");
  const std::optional<double> itsY = words.finite(y, "y");
  const bool isWhole = itsFrame && itsId && itsX && itsY;
  return isWhole ? &add(*itsId, *itsFrame, {*itsX, *itsY}, frame.line, frame.column) : nullptr;
}

TrackFile FrameTracks::finish(const std::string& path, double framesPerSecond) {
  TrackFile file;
  file.file = path;
  for (auto& [id, track] : tracks_) {
    file.tracks.push_back(std::move(track));
  }
  framesToSeconds(file, framesPerSecond);
  return file;
}

void framesToSeconds(TrackFile& file, double framesPerSecond) {
  const double median = medianInterval(file.tracks);
  const double step = median > 0.0 ? median : 1.0;
  file.isByFrames = true;
  file.step = framesPerSecond > 0.0 ? step / framesPerSecond : kAnnotationStep;
  for (Track& track : file.tracks) {
    for (TrackPoint& point : track.points) {
      point.time = point.time * file.step / step;
    }
  }
}

std::string besideFile(const std::string& path, const std::string& name) {
  return std::filesystem::path(path).replace_filename(name).string();
}

void tellNumbers(const ForeignInput& input, const std::vector<const Track*>& numbered) {
  constexpr std::size_t kMostTold = 5;
  std::vector<std::string> told;
  for (const Track* track : numbered) {
    if (told.size() == kMostTold) {
      break;
    }
    told.push_back(track->name + " = " + std::to_string(track->id));
  }
  if (!told.empty()) {
    input.problems.push_back(base::warning(
        "tracks.ids-numbered", {base::join(told, ", ") + (numbered.size() > kMostTold ? " …" : "")},
        input.path));
  }
}

void readGroupsBeside(const ForeignInput& input, TrackFile& file) {
  const std::string path = besideFile(input.path, "groups.txt");
  const base::Result<std::string> text = base::readTextFile(path, base::kMostRecord);
  if (!text) {
    return;  // not every set has one
  }
  WordReader words(path, input.problems);
  TextRows rows(*text);
  std::vector<Word> row;
  for (int group = 1; rows.next(row); ++group) {
    for (const Word& word : row) {
      const std::optional<long long> id = words.whole(word, "an id of a group");
      for (Track& track : file.tracks) {
        track.group = id && track.id == *id ? group : track.group;
      }
    }
  }
}

}  // namespace sim2d
