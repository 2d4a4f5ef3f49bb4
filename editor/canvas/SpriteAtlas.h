#pragma once

#include <map>
#include <tuple>
#include <vector>

#include <QPainter>
#include <QPixmap>

#include "editor/look/FigurePainter.h"

namespace editor {

/// Cached pictures of people: one sheet per appearance, kind and size with 64 headings and 3 step
/// phases. A picture is rendered on first use; a new zoom requires new sheets (`clear`).
class SpriteAtlas {
 public:
  void clear() { sheets_.clear(); }
  /// Draws figures centred at their points (painter in pixels). Figures too large for sheets are
  /// painted directly.
  void draw(QPainter& painter, const Theme& theme,
            const std::vector<std::pair<QPointF, PersonFigure>>& figures);

 private:
  using Key = std::tuple<Look, sim2d::PersonKind, int>;  // Radius in quarters of a pixel.
  struct Sheet {
    QPixmap pixmap;
    std::vector<bool> painted;
    int cell = 0;  // Side length [device pixels].
    std::vector<QPainter::PixmapFragment> fragments;
  };
  Sheet& sheetFor(const PersonFigure& figure, double ratio);
  static void add(Sheet& sheet, const Theme& theme, const QPointF& at, const PersonFigure& figure,
                  double ratio);

  std::map<Key, Sheet> sheets_;
};

}  // namespace editor
