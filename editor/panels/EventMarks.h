#pragma once

#include <QIcon>
#include <QPainter>

#include "editor/look/Theme.h"
#include "editor/panels/RunEvents.h"

namespace editor {

/// Draws the mark about `centre`, some 10 px wide.
void paintEventMark(QPainter& painter, EventMark mark, const QPointF& centre, const Theme& theme);
QIcon eventIcon(EventMark mark, const Theme& theme);

}  // namespace editor
