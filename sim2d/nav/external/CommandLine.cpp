#include "sim2d/nav/external/CommandLine.h"

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <optional>
#include <string_view>
#include <sys/stat.h>
#include <system_error>
#include <unistd.h>

#include "sim2d/base/Text.h"

namespace sim2d {
namespace {

/// State machine that splits a command character by character.
class ArgumentSplitter {
 public:
  void take(char c) {
    if (isEscaped_) {
      consumeEscaped(c);
    } else if (c == '\\' && quote_ != '\'') {
      isEscaped_ = true;
      hasWord_ = true;
    } else if (quote_ != 0) {
      consumeQuoted(c);
    } else if (c == '\'' || c == '"') {
      quote_ = c;
      hasWord_ = true;
    } else if (c == ' ' || c == '\t' || c == '\n' || c == '\r') {
      endWord();
    } else {
      add(c);
    }
  }

  /// Returns false if a quote is open or nothing follows a backslash.
  bool end() {
    endWord();
    return quote_ == 0 && !isEscaped_;
  }
  const std::vector<std::string>& words() const { return words_; }

 private:
  void add(char c) {
    word_ += c;
    hasWord_ = true;
  }
  void consumeEscaped(char c) {
    const bool isMeant = quote_ == 0 || std::string_view("\"\\$`").find(c) != std::string::npos;
    if (!isMeant) {
      add('\\');
    }
    add(c);
    isEscaped_ = false;
  }
  void consumeQuoted(char c) {
    if (c == quote_) {
      quote_ = 0;
    } else {
      add(c);
    }
  }
  void endWord() {
    if (hasWord_) {
      words_.push_back(word_);
    }
    word_.clear();
    hasWord_ = false;
  }

  std::vector<std::string> words_;
  std::string word_;
  bool hasWord_ = false;  // '' is an empty argument
  bool isEscaped_ = false;
  char quote_ = 0;
};

/// 0, or the errno for why this file cannot be started.
int programError(const std::string& file) {
  struct stat status = {};
  if (::stat(file.c_str(), &status) != 0) {
    return errno;
  }
  if (S_ISDIR(status.st_mode)) {
    return EISDIR;
  }
  return ::access(file.c_str(), X_OK) == 0 ? 0 : errno;
}

}  // namespace

base::Result<std::vector<std::string>> splitCommandLine(const std::string& command) {
  ArgumentSplitter splitter;
  for (const char c : command) {
    splitter.take(c);
  }
  if (!splitter.end()) {
    return base::error("external.open-quote", {command});
  }
  if (splitter.words().empty() || splitter.words().front().empty()) {
    return base::error("external.no-command");
  }
  return splitter.words();
}

base::Result<std::string> resolveExecutable(const std::string& name) {
  int why = 0;
  if (name.find('/') != std::string::npos) {
    why = programError(name);
    if (why == 0) {
      return name;
    }
  } else {
    const char* path = std::getenv("PATH");
    why = ENOENT;
    for (const std::string& folder : base::split(path == nullptr ? "/usr/bin:/bin" : path, ':')) {
      const std::string file = (folder.empty() ? "." : folder) + "/" + name;
      const int error = programError(file);
      if (error == 0) {
        return file;
      }
      why = error == EACCES ? EACCES : why;
    }
  }
  return base::error("external.not-started", {name, std::generic_category().message(why)});
}

namespace {

bool isContinuationByte(char c) {  // UTF-8 continuation byte
  return (static_cast<unsigned char>(c) & 0xC0U) == 0x80U;
}

}  // namespace

std::string printableText(std::string_view text, std::size_t most) {
  std::size_t size = std::min(text.size(), most);
  while (size > 0 && size < text.size() && isContinuationByte(text[size])) {
    --size;
  }
  std::string shown(text.substr(0, size));
  std::replace_if(
      shown.begin(), shown.end(),
      [](char c) { return static_cast<unsigned char>(c) < 0x20U || c == 0x7F; }, '?');
  return size < text.size() ? shown + "…" : shown;
}

}  // namespace sim2d
