#pragma once

#include <functional>
#include <string>
#include <string_view>

#include "bt/tree/TreeSpec.h"

/// Reads and writes the XML of BehaviorTree.CPP, version 4. Files of version 3 are converted on
/// reading. Does not throw; time and memory are bounded by the size of the input.
namespace bt {

constexpr int kMaxNesting = 256;      // nested elements
constexpr int kMaxIncludeDepth = 32;  // nested files

/// Reads one file; includes are not followed. `fileName` is used in messages and for relative
/// includes.
base::Result<TreeFile> readTreeText(std::string_view xml, const std::string& fileName = {});
base::Result<TreeFile> readTree(const std::string& path);

/// Resolves the includes of a file. The file's own trees override included ones, a later include
/// overrides an earlier one. `packages` returns the folder of a ROS package (empty: unknown).
using PackageFolder = std::function<std::string(const std::string& package)>;
base::Result<TreeTable> resolveIncludes(const TreeFile& file, const PackageFolder& packages = {});
base::Result<TreeTable> loadTrees(const std::string& path, const PackageFolder& packages = {});

/// The file as XML text. `catalogue` only selects the tags of the explicit notation.
std::string writeTree(const TreeFile& file, const NodeCatalogue& catalogue);
/// The file as XML text, where `before` is the text that it was read from. Unchanged parts are
/// preserved byte for byte, with comments, layout and attribute order. Reading the result gives
/// `file`. Changes that this does not support (other includes, other model …) give the text of
/// writeTree.
std::string rewriteTree(const std::string& before, const TreeFile& file,
                        const NodeCatalogue& catalogue);
/// A node and its subtree as an XML element.
std::string writeNode(const NodeSpec& node, const NodeCatalogue& catalogue);
/// A file that contains only the model block, for Groot2.
std::string writeModel(const NodeCatalogue& catalogue);
/// The model block of all nodes that are not part of BehaviorTree.CPP.
XmlElement modelOf(const NodeCatalogue& catalogue);

}  // namespace bt
