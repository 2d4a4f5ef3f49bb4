#include "sim2d/nav/external/CommandLine.h"

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <optional>
#include <string_view>
#include <sys/stat.h>
#include <system_error>
#include <unistd.h>
#include <utility>

#include "sim2d/base/Text.h"

namespace sim2d {
namespace {

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

bool isBlank(char c) {
  return c == ' ' || c == '\t' || c == '\n' || c == '\r';
}

/// Does a character begin a quotation, or end the one that `quote` began? 0: none is open.
bool isQuote(char c, char quote) {
  return quote != 0 ? c == quote : c == '\'' || c == '"';
}

/// What a backslash and the character after it stand for.
std::string escaped(char c, char quote) {
  const bool isMeant = quote == 0 || std::string_view("\"\\$`").find(c) != std::string_view::npos;
  return isMeant ? std::string(1, c) : std::string("\\") + c;
}

}  // namespace

base::Result<std::vector<std::string>> splitCommandLine(const std::string& command) {
  std::vector<std::string> words;
  std::string word;
  bool hasWord = false;  // '' is an empty argument
  char quote = 0;
  for (std::size_t i = 0; i < command.size(); ++i) {
    const char c = command[i];
    const bool isGap = quote == 0 && isBlank(c);
    if (isGap && hasWord) {
      words.push_back(std::exchange(word, {}));
    }
    hasWord = !isGap;
    if (c == '\\' && quote != '\'') {
      if (++i == command.size()) {
        return base::error("external.open-quote", {command});
      }
      word += escaped(command[i], quote);
    } else if (isQuote(c, quote)) {
      quote = quote != 0 ? '\0' : c;
    } else if (!isGap) {
      word += c;
    }
  }
  if (hasWord) {
    words.push_back(word);
  }
  if (quote != 0) {
    return base::error("external.open-quote", {command});
  }
  if (words.empty() || words.front().empty()) {
    return base::error("external.no-command");
  }
  return words;
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
