#include "app/cli/FigureStyle.h"

#include "editor/look/FigurePainter.h"

namespace app {

const std::vector<std::string>& figureOverlayNames() {
  static const std::vector<std::string> kNames = {"density",    "zones",  "gaussian",
                                                  "velocities", "forces", "contacts"};
  return kNames;
}

void FigureText::write(QPainter& painter, const QPointF& baseline, const QFont& font,
                       editor::Role role, const QString& text) const {
  if (asOutlines_) {
    painter.fillPath(editor::textOutline(baseline, font, text), theme_.color(role));
  } else {
    painter.setFont(font);
    painter.setPen(theme_.color(role));
    painter.drawText(baseline, text);
  }
}

}  // namespace app
