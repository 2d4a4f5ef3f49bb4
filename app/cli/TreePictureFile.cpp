#include "app/cli/TreePictureFile.h"

#include <algorithm>
#include <cmath>

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

base::Result<std::string> treePictureBytes(const bt::TreeTable& table, const std::string& file,
                                           editor::TreeDirection direction) {
  if (const std::optional<base::Diagnostic> unknown = unknownTreePicture(file)) {
    return *unknown;
  }
  const editor::TreePicture picture(table, direction);
  if (picture.isEmpty()) {
    return base::error("trees.nothing-to-draw", {}, file);
  }
  const Paint paint = [&picture](QPainter& painter) { picture.paint(painter); };
  const std::string ending = endingOf(file);
  if (ending == ".svg") {
    return svgOf(picture.size(), QString::fromStdString(table.mainTree), paint);
  }
  if (ending == ".pdf") {
    return pdfOf(picture.size(), paint);
  }
  return pngOfTree(picture);
}

}  // namespace app
