#pragma once

#include "editor/look/Theme.h"

class QwtPlot;

namespace editor {

/// Removes the frames of a plot and gives it thin axes with few labels.
void useThinAxes(QwtPlot& plot);
/// Sets the colours and fonts of the background and the axes.
void stylePlot(QwtPlot& plot, const Theme& theme);

}  // namespace editor
