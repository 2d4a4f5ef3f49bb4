#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "bt/tree/TreeSpec.h"

/// What reading and writing tree files needs; private to the folder.
namespace bt {

/// The first character that IDs and port names must not hold, 0 = none.
char forbiddenCharacter(std::string_view name);

/// What cannot be XML at all: no UTF-8, a NUL byte; with its line.
std::optional<base::Diagnostic> problemOfText(std::string_view text, const std::string& fileName);

/// The text with "&amp;" for each '&' that begins no reference ("a && b"), outside of comments and
/// CDATA; `firstLine` = where the first one stands, 0 = there was none. tinyxml2 keeps such an '&'
/// in a text of its own, but garbles it behind a reference.
std::string withEscapedAmpersands(std::string_view text, int& firstLine);

struct XmlPiece {
  std::string text;
  std::vector<std::pair<int, int>> places;  // lines of it that begin elsewhere in the file: there

  int lineInFile(int line) const;
};

/// tinyxml2 reads elements within each other to a depth of 100. The text in pieces that are less
/// deep: elements that stand deeper are taken out with all within them and lie side by side in the
/// next piece; <kPieceTag n="its number there"/> stands in the place of each. The text is UTF-8.
std::vector<XmlPiece> shallowPieces(std::string_view text);
constexpr const char* kPieceTag = "\xFFpiece";  // no UTF-8 has this byte: no file names such a tag

/// An error number of tinyxml2 in words.
std::string messageOfXmlError(int errorId);

std::string escapedXml(std::string_view text);

/// As in a file, each line behind `margin`. `compact`: not in explicit notation.
std::string textOf(const NodeSpec& node, const NodeCatalogue& catalogue, bool compact,
                   const std::string& margin);
std::string textOf(const TreeSpec& tree, const NodeCatalogue& catalogue, const std::string& margin);

/// Whether a node's name means another node (or none) since version 4 of BehaviorTree.CPP.
bool isVersion3Name(const std::string& id);
/// Converts the node itself, not its children. Says what was changed.
void convertFromVersion3(NodeSpec& node, const std::string& fileName, base::Diagnostics& notes);

}  // namespace bt
