#include "app/cli/TreePictureFile.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "app/cli/PictureFiles.h"
#include "editor/trees/TreePicture.h"
#include "sim2d/base/Text.h"

namespace app {

namespace {

constexpr double kImageScale = 2.0;       // image pixels per CSS pixel, for print
constexpr double kLongestSide = 32000.0;  // [image pixels]
constexpr double kMostPixels = 64e6;

std::string pngOfTree(const editor::TreePicture& picture) {
  const QSizeF size = picture.size();
  const double side = std::max({size.width(), size.height(), 1.0});
  const double area = std::max(size.width() * size.height(), 1.0);
  const double scale = std::min({kImageScale, kLongestSide / side, std::sqrt(kMostPixels / area)});
  return pngOf(scale * size, [&picture, scale](QPainter& painter) {
    painter.scale(scale, scale);
    picture.paint(painter);
  });
}

}  // namespace

std::optional<base::Diagnostic> unknownTreePicture(const std::string& file) {
  const std::string ending = endingOf(file);
  const bool isKnown = ending == ".svg" || ending == ".pdf" || ending == ".png";
  return isKnown ? std::nullopt
                 : std::optional(base::error("trees.picture-format", {ending}, file));
}

namespace {

base::NodeStatus shownStatus(std::size_t success, std::size_t failure, std::size_t running) {
  using base::NodeStatus;
  return success > 0   ? NodeStatus::Success
         : failure > 0 ? NodeStatus::Failure
         : running > 0 ? NodeStatus::Running
                       : NodeStatus::Idle;
}

/// Per node, over all trees of the batch with the same paths; empty: there is none.
std::vector<base::NodeStatus> coveredStatuses(const std::vector<std::string>& paths,
                                              const std::vector<CoveredTree>& coverage) {
  std::map<std::string, CoveredNode> sums;
  for (const CoveredTree& tree : coverage) {
    const bool isSame = tree.nodes.size() == paths.size() &&
                        std::equal(paths.begin(), paths.end(), tree.nodes.begin(),
                                   [](const std::string& path, const CoveredNode& node) {
                                     return path == node.path;
                                   });
    for (const CoveredNode& node : isSame ? tree.nodes : std::vector<CoveredNode>()) {
      CoveredNode& sum = sums[node.path];
      sum.success += node.success;
      sum.failure += node.failure;
      sum.running += node.running;
    }
  }
  std::vector<base::NodeStatus> statuses;
  for (const std::string& path : sums.empty() ? std::vector<std::string>() : paths) {
    const CoveredNode& sum = sums[path];
    statuses.push_back(shownStatus(sum.success, sum.failure, sum.running));
  }
  return statuses;
}

base::Result<std::string> bytesOf(const editor::TreePicture& picture, const std::string& title,
                                  const std::string& file) {
  if (picture.isEmpty()) {
    return base::error("trees.nothing-to-draw", {}, file);
  }
  const Paint paint = [&picture](QPainter& painter) { picture.paint(painter); };
  const std::string ending = endingOf(file);
  if (ending == ".svg") {
    return svgOf(picture.size(), QString::fromStdString(title), paint);
  }
  if (ending == ".pdf") {
    return pdfOf(picture.size(), paint);
  }
  return pngOfTree(picture);
}

}  // namespace

base::Result<std::string> treePictureBytes(const bt::TreeTable& table, const std::string& file,
                                           editor::TreeDirection direction) {
  if (const std::optional<base::Diagnostic> unknown = unknownTreePicture(file)) {
    return *unknown;
  }
  return bytesOf(editor::TreePicture(table, direction), table.mainTree, file);
}

base::Result<std::string> treePictureBytes(const bt::TreeTable& table, const std::string& file,
                                           const std::vector<CoveredTree>& coverage) {
  if (const std::optional<base::Diagnostic> unknown = unknownTreePicture(file)) {
    return *unknown;
  }
  editor::TreePicture picture(table);
  std::vector<base::NodeStatus> statuses = coveredStatuses(picture.paths(), coverage);
  if (statuses.empty() && !picture.isEmpty()) {
    return base::error("trees.not-covered");
  }
  picture.showStatuses(std::move(statuses));
  return bytesOf(picture, table.mainTree, file);
}

}  // namespace app
