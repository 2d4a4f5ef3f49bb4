#include "bt/tree/XmlText.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <map>
#include <utility>

#include <tinyxml2.h>

namespace bt {
namespace {

constexpr std::string_view kForbidden = " \t\r\n<>&\"'/\\:*?.|";

/// Bytes of the UTF-8 character at `at`; 0 = not valid.
std::size_t utf8Length(std::string_view text, std::size_t at) {
  const auto byte = [&text](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  const unsigned char first = byte(at);
  if (first < 0x80) {
    return 1;
  }
  const std::size_t length = first >= 0xF0 ? 4 : (first >= 0xE0 ? 3 : 2);
  if (first < 0xC2 || first > 0xF4 || at + length > text.size()) {
    return 0;
  }
  for (std::size_t i = 1; i < length; ++i) {
    if ((byte(at + i) & 0xC0) != 0x80) {
      return 0;
    }
  }
  const unsigned char second = byte(at + 1);
  const bool wrong = (first == 0xE0 && second < 0xA0) || (first == 0xED && second > 0x9F) ||
                     (first == 0xF0 && second < 0x90) || (first == 0xF4 && second > 0x8F);
  return wrong ? 0 : length;
}

/// "&#65;", "&#x41;": digits of a character that XML allows.
bool isCharacter(std::string_view digits) {
  const bool isHex = !digits.empty() && digits[0] == 'x';
  digits.remove_prefix(isHex ? 1 : 0);
  unsigned long code = 0;
  const char* const end = digits.data() + digits.size();
  const auto [rest, problem] = std::from_chars(digits.data(), end, code, isHex ? 16 : 10);
  if (problem != std::errc() || rest != end) {
    return false;
  }
  const bool isBlank = code == '\t' || code == '\n' || code == '\r';
  return isBlank || (code >= 0x20 && code < 0xD800) || (code >= 0xE000 && code < 0xFFFE) ||
         (code >= 0x10000 && code <= 0x10FFFF);
}

/// `text` begins with '&'.
bool beginsReference(std::string_view text) {
  constexpr std::size_t kLongest = 12;
  const std::size_t end = text.substr(0, kLongest).find(';');
  if (end == std::string_view::npos) {
    return false;
  }
  const std::string_view name = text.substr(1, end - 1);
  if (!name.empty() && name[0] == '#') {
    return isCharacter(name.substr(1));
  }
  return name == "lt" || name == "gt" || name == "amp" || name == "quot" || name == "apos";
}

/// Length of the comment or CDATA section at the begin of `text`; 0 = there is none.
std::size_t verbatimLength(std::string_view text) {
  constexpr std::array<std::pair<std::string_view, std::string_view>, 2> kSections = {
      {{"<!--", "-->"}, {"<![CDATA[", "]]>"}}};
  for (const auto& [begin, end] : kSections) {
    if (text.substr(0, begin.size()) == begin) {
      const std::size_t at = text.find(end, begin.size());
      return at == std::string_view::npos ? text.size() : at + end.size();
    }
  }
  return 0;
}

/// Length of the tag at the begin of `text`, quotes in mind.
std::size_t tagLength(std::string_view text) {
  char quote = 0;
  for (std::size_t at = 0; at < text.size(); ++at) {
    const char c = text[at];
    if (quote == 0 && c == '>') {
      return at + 1;
    }
    if (quote == c) {
      quote = 0;
    } else if (quote == 0 && (c == '"' || c == '\'')) {
      quote = c;
    }
  }
  return text.size();
}

/// Shares a text out among its pieces while it is read from the begin.
class Pieces {
 public:
  void open(std::string_view tag) {
    if (depths_.back() == kMostDeep) {
      if (depths_.size() == writers_.size()) {
        writers_.emplace_back();
      }
      const std::size_t number = writers_[depths_.size()].elements++;
      add("<" + std::string(kPieceTag) + " n=\"" + std::to_string(number) + "\"/>");
      depths_.push_back(0);
    }
    add(tag);
    depths_.back() += tag.substr(tag.size() - std::min<std::size_t>(2, tag.size())) != "/>";
    leave();
  }
  void close(std::string_view tag) {
    add(tag);
    --depths_.back();
    leave();
  }
  /// Begins a line of its own where something went into another piece.
  void add(std::string_view text) {
    Writer& to = writers_[depths_.size() - 1];
    if (to.source != line_) {
      to.piece.text += '\n';
      to.piece.places.emplace_back(++to.line, line_);
    }
    to.piece.text += text;
    const auto lines = static_cast<int>(std::count(text.begin(), text.end(), '\n'));
    line_ += lines;
    to.line += lines;
    to.source = line_;
  }
  std::vector<XmlPiece> take() {
    std::vector<XmlPiece> pieces;
    pieces.reserve(writers_.size());
    for (Writer& writer : writers_) {
      pieces.push_back(std::move(writer.piece));
    }
    return pieces;
  }

 private:
  static constexpr int kMostDeep = 80;
  struct Writer {
    XmlPiece piece;
    std::size_t elements = 0;  // that lie side by side in it
    int line = 1;              // that is written
    int source = 0;            // the same in the file; 0 = nothing yet
  };
  void leave() {
    if (depths_.size() > 1 && depths_.back() <= 0) {
      depths_.pop_back();
    }
  }

  std::vector<Writer> writers_ = std::vector<Writer>(1);
  std::vector<int> depths_ = std::vector<int>(1);  // within each piece down to the present one
  int line_ = 1;
};

}  // namespace

int XmlPiece::lineInFile(int line) const {
  const auto next = std::upper_bound(places.begin(), places.end(), line,
                                     [](int a, const auto& place) { return a < place.first; });
  return next == places.begin() ? line : line - (next - 1)->first + (next - 1)->second;
}

std::vector<XmlPiece> shallowPieces(std::string_view text) {
  Pieces pieces;
  while (!text.empty()) {
    const bool isMarkup = text[0] == '<';
    const std::size_t verbatim = isMarkup ? verbatimLength(text) : 0;
    const std::size_t length = verbatim > 0 ? verbatim
                               : isMarkup   ? tagLength(text)
                                            : std::min(text.find('<'), text.size());
    const std::string_view part = text.substr(0, length);
    const char second = part.size() > 1 ? part[1] : '\0';
    if (!isMarkup || verbatim > 0 || second == '?' || second == '!') {
      pieces.add(part);
    } else if (second == '/') {
      pieces.close(part);
    } else {
      pieces.open(part);
    }
    text.remove_prefix(length);
  }
  return pieces.take();
}

std::string withEscapedAmpersands(std::string_view text, int& firstLine) {
  std::string result;
  result.reserve(text.size());
  firstLine = 0;
  for (std::size_t at = 0; at < text.size();) {
    const std::string_view rest = text.substr(at);
    const std::size_t verbatim = rest[0] == '<' ? verbatimLength(rest) : 0;
    const bool isBare = rest[0] == '&' && !beginsReference(rest);
    if (isBare && firstLine == 0) {
      const std::string_view before = text.substr(0, at);
      firstLine = 1 + static_cast<int>(std::count(before.begin(), before.end(), '\n'));
    }
    const std::size_t length = std::max<std::size_t>(verbatim, 1);
    result += isBare ? std::string_view("&amp;") : rest.substr(0, length);
    at += length;
  }
  return result;
}

char forbiddenCharacter(std::string_view name) {
  for (const char c : name) {
    const auto code = static_cast<unsigned char>(c);
    if (kForbidden.find(c) != std::string_view::npos || code < 0x20 || code == 0x7F) {
      return c;
    }
  }
  return 0;
}

std::optional<base::Diagnostic> problemOfText(std::string_view text, const std::string& fileName) {
  int line = 1;
  for (std::size_t at = 0; at < text.size();) {
    if (text[at] == '\0') {
      return base::error("tree.nul-byte", {}, fileName, line);
    }
    const std::size_t length = utf8Length(text, at);
    if (length == 0) {
      return base::error("tree.not-utf8", {}, fileName, line);
    }
    line += text[at] == '\n' ? 1 : 0;
    at += length;
  }
  return std::nullopt;
}

std::string messageOfXmlError(int errorId) {
  static const std::map<int, const char*> kCauses = {
      {tinyxml2::XML_ERROR_MISMATCHED_ELEMENT, "a closing tag does not match, or one is missing"},
      {tinyxml2::XML_ERROR_PARSING_ATTRIBUTE, "an attribute is broken"},
      {tinyxml2::XML_ERROR_PARSING_COMMENT, "a comment is not closed"},
      {tinyxml2::XML_ERROR_PARSING_CDATA, "a CDATA section is not closed"},
      {tinyxml2::XML_ERROR_PARSING_TEXT, "the text ends too early"},
      {tinyxml2::XML_ERROR_PARSING_DECLARATION, "the XML declaration is broken"},
      {tinyxml2::XML_ERROR_PARSING_UNKNOWN, "a <! section is broken"}};
  if (errorId == tinyxml2::XML_ERROR_EMPTY_DOCUMENT) {
    return "the file is empty";
  }
  if (errorId == tinyxml2::XML_ELEMENT_DEPTH_EXCEEDED) {
    return "elements are nested too deeply";
  }
  const auto cause = kCauses.find(errorId);
  return cause == kCauses.end() ? "not well-formed XML, or cut off"
                                : std::string("not well-formed XML: ") + cause->second;
}

std::string escapedXml(std::string_view text) {
  static const std::map<char, const char*> kReferences = {
      {'&', "&amp;"},  {'<', "&lt;"},   {'>', "&gt;"}, {'"', "&quot;"},
      {'\n', "&#10;"}, {'\r', "&#13;"}, {'\t', "&#9;"}};
  std::string result;
  for (const char c : text) {
    const auto reference = kReferences.find(c);
    result += reference == kReferences.end() ? std::string(1, c) : reference->second;
  }
  return result;
}

}  // namespace bt
