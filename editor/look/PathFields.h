#pragma once

#include <QLineEdit>

namespace editor {

/// Shows the end of a path that is too long for the field, "…/params/nav2.yaml", while the field
/// has no keyboard focus, and the whole path in its tooltip. Other texts are shown as usual.
void showEndOfPaths(QLineEdit& field);
/// The path of which such a field shows only the end; empty: none.
QString pathShownInPart(const QWidget& widget);

}  // namespace editor
