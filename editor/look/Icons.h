#pragma once

#include <QIcon>
#include <QString>

#include "editor/look/Theme.h"

namespace editor {

/// An icon of resources/icons in the colours of the theme: strokes in the text colour, dots in the
/// accent; paler when disabled, all accent when on. Sharp at every pixel ratio. Unknown names give
/// a null icon.
QIcon themedIcon(const QString& name, const Theme& theme);
/// The same with all strokes in one colour, for example that of a severity.
QIcon tintedIcon(const QString& name, const QColor& color);

}  // namespace editor
