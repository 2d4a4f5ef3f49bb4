#include "sim2d/trace/JsonInput.h"

#include <algorithm>
#include <iterator>
#include <string>
#include <utility>
#include <vector>

#include <nlohmann/json.hpp>

#include "sim2d/base/JsonText.h"

namespace sim2d {

base::Diagnostic jsonSyntaxError(std::string_view text, std::size_t byte, const std::string& file) {
  const std::string_view before = text.substr(0, byte > 0 ? byte - 1 : 0);
  const auto line = 1 + std::count(before.begin(), before.end(), '\n');
  const std::size_t lineStart = before.rfind('\n') + 1;  // 0: the first line
  return base::error("trace.not-json", {}, file, static_cast<int>(line),
                     static_cast<int>(before.size() - lineStart) + 1);
}

std::optional<nlohmann::json> parseJsonInput(const TrackInput& input) {
  try {
    return nlohmann::json::parse(base::shallowJson(input.text));
  } catch (const nlohmann::json::parse_error& problem) {
    input.problems.push_back(jsonSyntaxError(input.text, problem.byte, input.path));
  } catch (const nlohmann::json::exception& problem) {  // number out of range
    input.error("tracks.bad-json", {base::jsonErrorMessage(problem.what())});
  }
  return std::nullopt;
}

namespace {

/// Iterator over a text that counts lines.
class LineCounter {
 public:
  using iterator_category = std::input_iterator_tag;
  using value_type = char;
  using difference_type = std::ptrdiff_t;
  using pointer = const char*;
  using reference = const char&;

  LineCounter(const char* at, int* line) : at_(at), line_(line) {}
  reference operator*() const { return *at_; }
  LineCounter& operator++() {
    *line_ += *at_ == '\n' ? 1 : 0;
    ++at_;
    return *this;
  }
  bool operator==(const LineCounter& other) const { return at_ == other.at_; }
  bool operator!=(const LineCounter& other) const { return at_ != other.at_; }

 private:
  const char* at_;
  int* line_;
};

/// Records the line of each key and of each object in a list.
class LineRecorder : public nlohmann::json_sax<nlohmann::json> {
 public:
  LineRecorder(std::map<std::string, int>& lines, const int& line) : lines_(lines), line_(line) {}

  bool null() override { return next(); }
  bool boolean(bool /*value*/) override { return next(); }
  bool number_integer(number_integer_t /*value*/) override { return next(); }
  bool number_unsigned(number_unsigned_t /*value*/) override { return next(); }
  bool number_float(number_float_t /*value*/, const string_t& /*text*/) override { return next(); }
  bool string(string_t& /*value*/) override { return next(); }
  bool binary(binary_t& /*value*/) override { return next(); }
  bool start_object(std::size_t /*size*/) override { return begin(false); }
  bool start_array(std::size_t /*size*/) override { return begin(true); }
  bool end_object() override { return end(); }
  bool end_array() override { return end(); }
  bool key(string_t& name) override {
    levels_.back().key = name;
    note();
    return true;
  }
  bool parse_error(std::size_t /*byte*/, const std::string& /*token*/,
                   const nlohmann::json::exception& /*problem*/) override {
    return false;
  }

 private:
  struct Level {
    bool isList = false;
    std::size_t index = 0;  // of a list
    std::string key;        // of an object
  };

  /// Limits depth and length of paths, sufficient for files of hunavsim: otherwise memory could
  /// grow quadratically.
  void note() {
    constexpr std::size_t kMaxLevels = 32;
    constexpr std::size_t kLongest = 256;  // [B] of all keys
    std::size_t length = 0;
    for (std::size_t k = 0; k < std::min(levels_.size(), kMaxLevels); ++k) {
      length += levels_[k].key.size();
    }
    if (levels_.size() <= kMaxLevels && length <= kLongest) {
      lines_.emplace(path(), line_);
    }
  }

  std::string path() const {
    std::string text;
    for (const Level& level : levels_) {
      if (level.isList) {
        text += "[" + std::to_string(level.index) + "]";
      } else {
        text += (text.empty() ? "" : ".") + level.key;
      }
    }
    return text;
  }
  bool begin(bool isList) {
    if (!levels_.empty() && levels_.back().isList) {
      note();
    }
    levels_.push_back({isList, 0, {}});
    return true;
  }
  bool end() {
    levels_.pop_back();
    return next();
  }
  bool next() {
    if (!levels_.empty() && levels_.back().isList) {
      ++levels_.back().index;
    }
    return true;
  }

  std::map<std::string, int>& lines_;
  const int& line_;
  std::vector<Level> levels_;
};

}  // namespace

JsonLineIndex::JsonLineIndex(const std::string& text) {
  int line = 1;
  LineRecorder notes(lines_, line);
  const char* const end = text.data() + text.size();
  if (!nlohmann::json::sax_parse(LineCounter(text.data(), &line), LineCounter(end, &line),
                                 &notes)) {
    lines_.clear();
  }
}

int JsonLineIndex::lineOf(std::string path) const {
  for (;;) {
    const auto found = lines_.find(path);
    if (found != lines_.end()) {
      return found->second;
    }
    const std::size_t part = path.find_last_of(".[");
    if (part == std::string::npos) {
      return 0;
    }
    path.resize(part);
  }
}

}  // namespace sim2d
