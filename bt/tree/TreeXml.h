#pragma once

#include <functional>
#include <string>
#include <string_view>

#include "bt/tree/TreeSpec.h"

/// Reading and writing the XML of BehaviorTree.CPP, version 4; files of version 3 are converted
/// while they are read. Never throws; work and memory are bounded by the size of the input.
namespace bt {

constexpr int kMaxNesting = 256;      // elements within each other
constexpr int kMaxIncludeDepth = 32;  // files within each other

/// One file, includes not followed. `fileName` is for messages and relative includes.
base::Result<TreeFile> readTreeText(std::string_view xml, const std::string& fileName = {});
base::Result<TreeFile> readTree(const std::string& path);

/// A file with all that it includes. The file's own trees win over included ones, a later include
/// over an earlier one. `packageFolder` gives the folder of a ROS package (empty = unknown).
using PackageFolder = std::function<std::string(const std::string& package)>;
base::Result<TreeTable> resolveIncludes(const TreeFile& file, const PackageFolder& packages = {});
base::Result<TreeTable> loadTrees(const std::string& path, const PackageFolder& packages = {});

/// The file as XML text. `catalogue` decides nothing but the tag of explicit notation.
std::string writeTree(const TreeFile& file, const NodeCatalogue& catalogue);
/// The file as XML text again, where `before` is the text that it was read from: what has not
/// changed since stays byte by byte, with its comments, its layout and the order of its attributes.
/// Reading the result gives `file`. Where that cannot be had (other includes, other model …) it is
/// the text of writeTree.
std::string rewriteTree(const std::string& before, const TreeFile& file,
                        const NodeCatalogue& catalogue);
/// A node with all that is below it, as an element without a file around it.
std::string writeNode(const NodeSpec& node, const NodeCatalogue& catalogue);
/// A file with the model block alone, for Groot2.
std::string writeModel(const NodeCatalogue& catalogue);
/// The model block of all nodes that are not part of BehaviorTree.CPP itself.
XmlBlock modelOf(const NodeCatalogue& catalogue);

}  // namespace bt
