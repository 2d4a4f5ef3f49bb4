#include "bt/tree/XmlText.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <map>
#include <set>
#include <utility>

#include <tinyxml2.h>

#include "bt/tree/NodeCatalogue.h"
#include "sim2d/base/Text.h"

namespace bt {
namespace {

constexpr std::string_view kForbidden = " \t\r\n<>&\"'/\\:*?.|";

/// Length of the UTF-8 character at `at` in bytes; 0: invalid.
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

/// Whether "65" or "x41" of "&#65;" or "&#x41;" is a character that XML allows.
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

/// Whether `text`, which starts with '&', starts with a reference.
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

/// Length of the comment or CDATA section at the start of `text`; 0: none.
std::size_t verbatimLength(std::string_view text) {
  constexpr std::array<std::pair<std::string_view, std::string_view>, 2> kSections = {
      {{"<!--", "-->"}, {"<![CDATA[", "]]>"}}};
  for (const auto& [begin, end] : kSections) {
    if (base::startsWith(text, begin)) {
      const std::size_t at = text.find(end, begin.size());
      return at == std::string_view::npos ? text.size() : at + end.size();
    }
  }
  return 0;
}

/// Length of the tag at the start of `text`; '>' inside quotes is skipped.
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

/// Distributes a text to pieces while it is read sequentially.
class ChunkWriter {
 public:
  void open(std::string_view tag) {
    if (depths_.back() == kMostDeep) {
      if (depths_.size() == writers_.size()) {
        writers_.emplace_back();
      }
      const std::size_t number = writers_[depths_.size()].elements++;
      add("<" + std::string(kChunkTag) + " n=\"" + std::to_string(number) + "\"/>");
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
  /// Starts a new line if preceding text went to another piece.
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
  std::vector<XmlChunk> take() {
    std::vector<XmlChunk> pieces;
    pieces.reserve(writers_.size());
    for (Writer& writer : writers_) {
      pieces.push_back(std::move(writer.piece));
    }
    return pieces;
  }

 private:
  static constexpr int kMostDeep = 80;
  struct Writer {
    XmlChunk piece;
    std::size_t elements = 0;  // elements at the top level of the piece
    int line = 1;              // current line in the piece
    int source = 0;            // current line in the file; 0: nothing written yet
  };
  void leave() {
    if (depths_.size() > 1 && depths_.back() <= 0) {
      depths_.pop_back();
    }
  }

  std::vector<Writer> writers_ = std::vector<Writer>(1);
  std::vector<int> depths_ = std::vector<int>(1);  // current depth in each open piece
  int line_ = 1;
};

}  // namespace

int XmlChunk::lineInFile(int line) const {
  const auto next = std::upper_bound(places.begin(), places.end(), line,
                                     [](int a, const auto& place) { return a < place.first; });
  return next == places.begin() ? line : line - (next - 1)->first + (next - 1)->second;
}

std::vector<XmlChunk> splitByDepth(std::string_view text) {
  ChunkWriter pieces;
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

std::optional<base::Diagnostic> encodingProblem(std::string_view text,
                                                const std::string& fileName) {
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
      {tinyxml2::XML_ERROR_PARSING_ATTRIBUTE, "an attribute is malformed"},
      {tinyxml2::XML_ERROR_PARSING_COMMENT, "a comment is not closed"},
      {tinyxml2::XML_ERROR_PARSING_CDATA, "a CDATA section is not closed"},
      {tinyxml2::XML_ERROR_PARSING_TEXT, "the text is truncated"},
      {tinyxml2::XML_ERROR_PARSING_DECLARATION, "the XML declaration is malformed"},
      {tinyxml2::XML_ERROR_PARSING_UNKNOWN, "a <! section is malformed"}};
  if (errorId == tinyxml2::XML_ERROR_EMPTY_DOCUMENT) {
    return "the file is empty";
  }
  if (errorId == tinyxml2::XML_ELEMENT_DEPTH_EXCEEDED) {
    return "elements are nested too deeply";
  }
  const auto cause = kCauses.find(errorId);
  return cause == kCauses.end() ? "not well-formed XML, or truncated"
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

namespace {

using Names = std::map<std::string, const char*>;

const Names kRenamedNodes = {{"SubTreePlus", "SubTree"},
                             {"SequenceStar", "SequenceWithMemory"},
                             {"RetryUntilSuccesful", "RetryUntilSuccessful"}};
const Names kParallelPorts = {{"success_threshold", "success_count"},
                              {"failure_threshold", "failure_count"}};
const std::set<std::string> kBlackboardChecks = {"BlackboardCheckInt", "BlackboardCheckDouble",
                                                 "BlackboardCheckString", "BlackboardCheckBool"};

/// Returns false if there is no new name.
bool rename(std::string& name, const Names& names) {
  const auto now = names.find(name);
  if (now == names.end()) {
    return false;
  }
  name = now->second;
  return true;
}

/// Whether the text is an identifier that names an entry; numbers and text with blanks are
/// constants.
bool isKeyName(const std::string& text) {
  const auto part = [](char c) {
    return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_';
  };
  return !text.empty() && std::isdigit(static_cast<unsigned char>(text[0])) == 0 &&
         std::all_of(text.begin(), text.end(), part);
}

bool takeFlag(Attributes& attributes, const char* name) {
  const std::string* const text = findAttribute(attributes, name);
  const bool set = text && boolFromText(*text).value_or(false);
  removeAttribute(attributes, name);
  return set;
}

bool convertSubTree(NodeSpec& node) {
  bool changed = false;
  for (Attribute& port : node.ports) {
    if (isKeyName(port.text)) {
      port.text = "{" + port.text + "}";
      changed = true;
    }
  }
  const bool shared = takeFlag(node.others, "__shared_blackboard");
  const bool automatic = takeFlag(node.others, "__autoremap");
  node.autoRemap = node.autoRemap || shared || automatic;
  return changed || shared || automatic;
}

/// One side of a comparison in the script language.
std::string operandOf(const std::string& text, const std::string& port, bool isText) {
  if (const std::optional<std::string> key = referencedKey(text, port)) {
    return *key;
  }
  if (isText) {
    return "'" + text + "'";
  }
  const std::optional<bool> flag = boolFromText(text);
  const bool word = flag && !doubleFromText(text);
  return word ? (*flag ? "true" : "false") : text;
}

void convertCheck(NodeSpec& node) {
  const bool isText = node.id == "BlackboardCheckString";
  const auto side = [&](const char* port) {
    const std::string* const text = findAttribute(node.ports, port);
    return operandOf(text ? *text : std::string(), port, isText);
  };
  Attributes ports = {{"if", side("value_A") + " == " + side("value_B")}};
  if (const std::string* const result = findAttribute(node.ports, "return_on_mismatch")) {
    ports.push_back({"else", *result});
  }
  node.ports = std::move(ports);
  node.id = "Precondition";
}

}  // namespace

bool isVersion3Name(const std::string& id) {
  return kBlackboardChecks.count(id) > 0 || kRenamedNodes.count(id) > 0;
}

void convertFromVersion3(NodeSpec& node, const std::string& fileName, base::Diagnostics& notes) {
  const std::string before = node.id;
  bool changed = rename(node.id, kRenamedNodes);
  if (node.isSubTree()) {
    changed = convertSubTree(node) || changed;
  } else if (node.id == "Parallel") {
    for (Attribute& port : node.ports) {
      changed = rename(port.name, kParallelPorts) || changed;
    }
  } else if (kBlackboardChecks.count(node.id) > 0) {
    convertCheck(node);
    changed = true;
  }
  if (changed) {
    notes.push_back(base::warning("tree.converted", {before}, fileName, node.line));
  }
}

}  // namespace bt
