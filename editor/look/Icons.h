#pragma once

#include "editor/look/Theme.h"

namespace editor {

/// An icon of resources/icons in the colours of the theme: strokes in the text colour, dots in the
/// accent colour; paler when disabled, accent only when checked. Sharp at every pixel ratio.
/// Unknown names give a null icon.
QIcon themedIcon(const QString& name, const Theme& theme);
/// The same icon with all strokes in one colour, for example the colour of a severity.
QIcon tintedIcon(const QString& name, const QColor& color);

}  // namespace editor
