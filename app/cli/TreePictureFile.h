#pragma once

#include <optional>
#include <string>

#include "app/run/TreeCoverage.h"
#include "bt/tree/TreeSpec.h"
#include "editor/trees/TreeLayout.h"
#include "sim2d/base/Result.h"

namespace app {

/// An error if a tree cannot be drawn into a file with this extension; none: .svg, .pdf or .png.
std::optional<base::Diagnostic> unknownTreePicture(const std::string& file);

/// The picture of a behaviour tree with all subtrees expanded, as the bytes of the file;
/// reproducible. Error: there is no node to draw, or a .png would be too large for memory. Requires
/// a QGuiApplication.
base::Result<std::string> treePictureBytes(
    const bt::TreeTable& table, const std::string& file,
    editor::TreeDirection direction = editor::TreeDirection::Down);
/// The same with the coverage of a batch: nodes that were never executed are pale; of the others
/// the mark shows SUCCESS if they ever returned it, otherwise FAILURE or RUNNING. Error also: the
/// batch has no such tree.
base::Result<std::string> treePictureBytes(const bt::TreeTable& table, const std::string& file,
                                           const std::vector<CoveredTree>& coverage);

}  // namespace app
