#include "editor/trees/FilePlaces.h"

#include <cmath>
#include <string>

#include "sim2d/base/Text.h"

namespace editor {

namespace {

constexpr double kFarthestPlace = 1e6;  // [px]

std::optional<QPointF> placeOfTexts(const std::string& x, const std::string& y) {
  const std::optional<double> across = base::parseDouble(base::trimmed(x));
  const std::optional<double> down = base::parseDouble(base::trimmed(y));
  const bool isPlace = across && down && std::fabs(*across) <= kFarthestPlace &&
                       std::fabs(*down) <= kFarthestPlace;  // no NaN either
  return isPlace ? std::optional(QPointF(*across, *down)) : std::nullopt;
}

}  // namespace

std::optional<QPointF> placeInFile(const bt::NodeSpec& node) {
  const std::string* x = bt::findText(node.others, "_x");
  const std::string* y = bt::findText(node.others, "_y");
  if (x != nullptr && y != nullptr) {
    return placeOfTexts(*x, *y);
  }
  for (const char* name : {"_pos", "_position"}) {
    const std::string* both = bt::findText(node.others, name);
    const std::size_t middle = both == nullptr ? std::string::npos : both->find_first_of(";,");
    if (middle != std::string::npos) {
      return placeOfTexts(both->substr(0, middle), both->substr(middle + 1));
    }
  }
  return std::nullopt;
}

}  // namespace editor
