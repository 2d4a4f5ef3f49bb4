#pragma once

#include <vector>

#include <QRectF>

namespace editor {

/// A text that wants to stand at something round, pixels.
struct LabelWish {
  QPointF centre;
  double clearance = 18.0;  // from the centre to the edge of the label
  QSizeF size;
  int priority = 0;       // higher ones choose first
  bool isAbove = false;   // would rather stand above than below
  bool isNeeded = false;  // where there is no room: on what is taken, off other labels alone
};

/// A rectangle for each wish, below, above, beside or askew of its centre; a null rectangle where
/// there is no room. Labels keep off each other and off `taken`, and stay wholly within `window`:
/// near its edge they move along it, as long as they stay beside their centre.
std::vector<QRectF> layoutLabels(const std::vector<LabelWish>& wishes,
                                 const std::vector<QRectF>& taken, const QRectF& window);

}  // namespace editor
