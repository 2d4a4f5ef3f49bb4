#pragma once

#include "editor/look/Theme.h"

class QwtPlot;

namespace editor {

/// A plot without frames, with thin axes and few labels.
void useThinAxes(QwtPlot& plot);
/// The colours and fonts of background and axes.
void stylePlot(QwtPlot& plot, const Theme& theme);

}  // namespace editor
