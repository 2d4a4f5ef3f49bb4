#pragma once

#include <QIcon>
#include <QPainter>
#include <QPainterPath>

#include "editor/look/Theme.h"

namespace editor {

/// The sign that tells what an area does, without colour: an arrow out of a gate (source) or into
/// one (sink), a clock (waiting), a running figure (exit). Strokes around the origin, 16 units
/// wide.
QPainterPath areaGlyph(sim2d::AreaKind kind);
/// The sign in pixels, with a rim in the colour of the ground.
void paintAreaGlyph(QPainter& painter, sim2d::AreaKind kind, const QPointF& centre, double sizePx,
                    const Theme& theme);
/// For lists.
QIcon areaIcon(sim2d::AreaKind kind, const Theme& theme, int sizePx = 16);

}  // namespace editor
