#include "editor/canvas/SpriteAtlas.h"

#include <cmath>

namespace editor {

namespace {

constexpr int kHeadings = 64;
constexpr int kSteps = 3;
constexpr std::size_t kSprites = std::size_t{kHeadings} * kSteps;
constexpr int kColumns = 16;
constexpr double kLargestPx = 40.0;  // Radius.
constexpr double kReach = 1.5;       // Extent of luggage and feet in radii.

int headingIndex(double headingDeg) {
  const int index = static_cast<int>(std::lround(headingDeg * kHeadings / 360.0)) % kHeadings;
  return index < 0 ? index + kHeadings : index;
}

int stepIndex(double stride) {
  return stride > 0.33 ? 2 : stride < -0.33 ? 0 : 1;
}

}  // namespace

SpriteAtlas::Sheet& SpriteAtlas::sheetFor(const PersonFigure& figure, double ratio) {
  const int quarters = static_cast<int>(std::lround(4.0 * figure.radiusPx));
  Sheet& sheet = sheets_[{figure.look, figure.kind, quarters}];
  if (sheet.cell == 0) {
    sheet.cell = 2 * static_cast<int>(std::ceil(kReach * figure.radiusPx * ratio + 1.0));
    const int rows = kHeadings * kSteps / kColumns;
    sheet.pixmap = QPixmap(kColumns * sheet.cell, rows * sheet.cell);
    sheet.pixmap.fill(Qt::transparent);
    sheet.painted.assign(kSprites, false);
  }
  return sheet;
}

void SpriteAtlas::add(Sheet& sheet, const Theme& theme, const QPointF& at,
                      const PersonFigure& figure, double ratio) {
  const int heading = headingIndex(figure.headingDeg);
  const int step = stepIndex(figure.stride);
  const int number = step * kHeadings + heading;
  const int column = number % kColumns;
  const int row = number / kColumns;
  const QRectF source(column * sheet.cell, row * sheet.cell, sheet.cell, sheet.cell);
  if (!sheet.painted[static_cast<std::size_t>(number)]) {
    sheet.painted[static_cast<std::size_t>(number)] = true;
    PersonFigure sprite = figure;
    sprite.headingDeg = heading * 360.0 / kHeadings;
    sprite.stride = step - 1.0;
    QPainter painter(&sheet.pixmap);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.translate(source.center());
    painter.scale(ratio, ratio);
    FigurePainter(theme).person(painter, sprite);
  }
  sheet.fragments.push_back(QPainter::PixmapFragment::create(at, source, 1.0 / ratio, 1.0 / ratio));
}

void SpriteAtlas::draw(QPainter& painter, const Theme& theme,
                       const std::vector<std::pair<QPointF, PersonFigure>>& figures) {
  const double ratio = painter.device()->devicePixelRatioF();
  for (const auto& [at, figure] : figures) {
    if (figure.radiusPx > kLargestPx) {
      painter.save();
      painter.translate(at);
      FigurePainter(theme).person(painter, figure);
      painter.restore();
    } else {
      add(sheetFor(figure, ratio), theme, at, figure, ratio);
    }
  }
  painter.setRenderHint(QPainter::SmoothPixmapTransform);
  for (auto& [key, sheet] : sheets_) {
    if (!sheet.fragments.empty()) {
      painter.drawPixmapFragments(sheet.fragments.data(), static_cast<int>(sheet.fragments.size()),
                                  sheet.pixmap);
      sheet.fragments.clear();
    }
  }
}

}  // namespace editor
