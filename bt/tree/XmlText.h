#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "bt/tree/TreeSpec.h"

/// Helpers for reading and writing tree files; private to this folder.
namespace bt {

/// The first character that is not allowed in IDs and port names, 0: none.
char forbiddenCharacter(std::string_view name);

/// Reports text that cannot be XML (invalid UTF-8, a NUL byte), with its line.
std::optional<base::Diagnostic> encodingProblem(std::string_view text, const std::string& fileName);

/// The text with "&amp;" for each '&' that does not start a reference ("a && b"), outside comments
/// and CDATA. `firstLine` is the line of the first one, 0: none. tinyxml2 preserves such an '&' in
/// a separate text but corrupts it after a reference.
std::string withEscapedAmpersands(std::string_view text, int& firstLine);

struct XmlChunk {
  std::string text;
  std::vector<std::pair<int, int>> places;  // jumps: line in `text`, line in the file

  int lineInFile(int line) const;
};

/// tinyxml2 reads elements up to a nesting depth of 100. Splits the text into pieces of smaller
/// depth: deeper elements are moved, with their content, side by side into the next piece, and
/// <kChunkTag n="index"/> replaces each of them. The text is UTF-8.
std::vector<XmlChunk> splitByDepth(std::string_view text);
constexpr const char* kChunkTag = "\xFFpiece";  // not valid UTF-8, so no file has this tag

/// Message for an error number of tinyxml2.
std::string messageOfXmlError(int errorId);

std::string escapedXml(std::string_view text);

/// All XML attributes of a node except its ID.
Attributes attributesOf(const NodeSpec& node);

/// XML text as in a file, with each line indented by `margin`. `compact`: no explicit notation.
std::string toXmlText(const NodeSpec& node, const NodeCatalogue& catalogue, bool compact,
                      const std::string& margin);
std::string toXmlText(const TreeSpec& tree, const NodeCatalogue& catalogue,
                      const std::string& margin);

/// Whether this node name has another meaning, or none, since version 4 of BehaviorTree.CPP.
bool isVersion3Name(const std::string& id);
/// Converts the node, without its children, and adds a note about each change.
void convertFromVersion3(NodeSpec& node, const std::string& fileName, base::Diagnostics& notes);

}  // namespace bt
