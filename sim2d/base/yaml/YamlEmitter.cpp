#include <algorithm>
#include <array>

#include "sim2d/base/Text.h"
#include "sim2d/base/yaml/YamlTree.h"

namespace base {
namespace {

/// Scalars that YAML 1.1 reads as null, true, false, merge or value.
bool isReservedWord(std::string_view text) {
  static constexpr std::array<std::string_view, 12> kWords = {
      "~", "null", "y", "n", "yes", "no", "true", "false", "on", "off", "<<", "="};
  const std::string lower = toLower(text);
  return std::find(kWords.begin(), kWords.end(), lower) != kWords.end();
}

/// Anything that begins like a number or a date and contains only their characters. Quotes too many
/// texts rather than too few.
bool looksLikeNumber(std::string_view text) {
  if (!text.empty() && (text.front() == '-' || text.front() == '+')) {
    text.remove_prefix(1);
  }
  static constexpr std::array<std::string_view, 5> kWords = {".inf", ".nan", "inf", "nan",
                                                             "infinity"};
  const std::string lower = toLower(text);
  if (std::find(kWords.begin(), kWords.end(), lower) != kWords.end()) {
    return true;
  }
  const std::size_t first = lower.empty() || lower[0] != '.' ? 0 : 1;
  return first < lower.size() && isDigit(lower[first]) &&
         lower.find_first_not_of("0123456789abcdefoxtz_.:+- ") == std::string::npos;
}

bool hasPlainShape(std::string_view text) {
  if (text.empty() || text.front() == ' ' || text.back() == ' ' || text.back() == ':') {
    return false;
  }
  // Not at the start of a document: end marker, byte order mark.
  if (text.substr(0, 3) == "..." || text.substr(0, 3) == "\xEF\xBB\xBF") {
    return false;
  }
  static constexpr std::string_view kIndicators = "-?:,[]{}#&*!|>'\"%@`";
  if (kIndicators.find(text.front()) != std::string_view::npos) {
    return false;
  }
  for (std::size_t i = 0; i < text.size(); ++i) {
    const auto c = static_cast<unsigned char>(text[i]);
    const bool flow = c == ',' || c == '[' || c == ']' || c == '{' || c == '}';
    const bool mark = (c == ':' && text[i + 1] == ' ') || (c == '#' && text[i - 1] == ' ');
    if (c < 0x20 || c == 0x7F || flow || mark) {
      return false;
    }
  }
  return true;
}

std::string scalarText(const YamlNode& node) {
  const bool quote = node.quoted || !hasPlainShape(node.text);
  // Plain numbers may begin with a sign, which hasPlainShape rejects.
  const bool number = !node.quoted && looksLikeNumber(node.text);
  return quote && !number ? quotedText(node.text) : node.text;
}

std::string keyText(const YamlNode& node) {
  const std::string& key = node.key;
  // Goal numbers and the coordinate y are unquoted in HuNavSim's files.
  const bool plain =
      key == "y" || parseInt(key).has_value() || (node.keyIsPlain && hasPlainShape(key));
  return needsQuotes(key) && !plain ? quotedText(key) : key;
}

std::string inlineText(const YamlNode& node) {
  const std::string tag = node.tag.empty() ? std::string() : node.tag + ' ';
  if (node.isScalar()) {
    return tag + scalarText(node);
  }
  return tag + (node.isNull() ? "null" : node.isMap() ? "{}" : "[]");
}

bool isBlock(const YamlNode& node) {
  return (node.isMap() || node.isList()) && !node.items.empty();
}

void emitBlock(const YamlNode& node, int indent, std::string& out) {
  const std::string margin(static_cast<std::size_t>(indent), ' ');
  for (const YamlNode& item : node.items) {
    out += &item == &node.items.front() ? "" : "\n";
    out += margin + (node.isMap() ? keyText(item) + ':' : "-");
    if (!isBlock(item)) {
      out += ' ' + inlineText(item);
      continue;
    }
    out += (item.tag.empty() ? "" : ' ' + item.tag) + '\n';
    emitBlock(item, indent + 2, out);
  }
}

/// Counts comments line by line, skipping quotes and block scalars.
class CommentCounter {
 public:
  void line(std::string_view text) {
    const std::size_t word = text.find_first_not_of(" \t\r");
    const int indent = static_cast<int>(word);
    if (word == std::string_view::npos || (blockIndent_ >= 0 && indent > blockIndent_)) {
      return;
    }
    const std::string content = trimmed(text.substr(0, contentEnd(text)));
    blockIndent_ = quote_ == 0 && startsBlockScalar(content) ? indent : -1;
  }
  int count() const { return count_; }

 private:
  std::size_t contentEnd(std::string_view text) {
    char before = ' ';
    bool tokenStart = true;
    for (std::size_t i = 0; i < text.size(); ++i) {
      const char c = text[i];
      if (quote_ != 0) {
        const bool twice = c == '\'' && quote_ == c && i + 1 < text.size() && text[i + 1] == c;
        if (twice || (c == '\\' && quote_ == '"')) {
          ++i;
        } else if (c == quote_) {
          quote_ = 0;
        }
      } else if (c == '#' && (before == ' ' || before == '\t')) {
        ++count_;
        return i;
      } else if ((c == '"' || c == '\'') && tokenStart) {
        quote_ = c;
      }
      if (c != ' ' && c != '\t') {
        static constexpr std::string_view kOpeners = ":-,[{?";
        tokenStart = kOpeners.find(c) != std::string_view::npos;
      }
      before = c;
    }
    return text.size();
  }
  static bool startsBlockScalar(std::string_view content) {
    const std::size_t sign = content.find_last_of("|>");
    if (sign == std::string_view::npos || sign == 0 || content[sign - 1] != ' ') {
      return false;
    }
    return content.find_first_not_of("+-123456789", sign + 1) == std::string_view::npos;
  }

  char quote_ = 0;        // the quote character inside a quoted scalar, else 0
  int blockIndent_ = -1;  // indentation of the key inside a block scalar, else -1
  int count_ = 0;
};

}  // namespace

std::string quotedText(std::string_view text) {
  static constexpr std::string_view kHex = "0123456789ABCDEF";
  std::string result = "\"";
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if (c == '"' || c == '\\') {
      result += '\\';
      result += c;
    } else if (c == '\n') {
      result += "\\n";
    } else if (c == '\t') {
      result += "\\t";
    } else if (byte < 0x20 || byte == 0x7F) {
      result += "\\x";
      result += kHex[byte >> 4U];
      result += kHex[byte & 15U];
    } else {
      result += c;
    }
  }
  return result + '"';
}

bool needsQuotes(std::string_view text) {
  return !hasPlainShape(text) || isReservedWord(text) || looksLikeNumber(text);
}

std::string emitYaml(const YamlNode& node) {
  if (!isBlock(node)) {
    return inlineText(node);
  }
  std::string out;
  emitBlock(node, 0, out);
  return out;
}

namespace {

bool isInName(char c) {
  return isDigit(c) || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_';
}

/// Whether a key can follow these characters of its line: "  {", "\"/robot_1/", "/**/".
bool isBeforeKey(std::string_view begin) {
  const std::size_t at = begin.find_first_not_of(" \t\r{\"'\xEF\xBB\xBF");
  const std::string_view space = at == std::string_view::npos ? "" : begin.substr(at);
  return space.empty() ||
         (space.back() == '/' && std::all_of(space.begin(), space.end(), [](char c) {
            return isInName(c) || c == '/' || c == '*';
          }));
}

}  // namespace

bool hasKeyLine(std::string_view text, std::string_view key) {
  for (std::size_t at = text.find(key); at != std::string_view::npos; at = text.find(key, at + 1)) {
    const std::size_t line = text.substr(0, at).rfind('\n') + 1;  // 0 in the first line
    const std::size_t end = text.find_first_not_of(" \t\"'", at + key.size());
    const bool isKey = end != std::string_view::npos && text[end] == ':';
    if (isKey && isBeforeKey(text.substr(line, at - line))) {
      return true;
    }
  }
  return false;
}

int countComments(std::string_view text) {
  CommentCounter counter;
  for (const std::string& line : split(text, '\n')) {
    counter.line(line);
  }
  return counter.count();
}

}  // namespace base
