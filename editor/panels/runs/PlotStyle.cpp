#include "editor/panels/runs/PlotStyle.h"

#include <qwt_plot.h>
#include <qwt_plot_canvas.h>
#include <qwt_scale_div.h>
#include <qwt_scale_draw.h>
#include <qwt_scale_widget.h>

namespace editor {

void useThinAxes(QwtPlot& plot) {
  plot.setFrameShape(QFrame::NoFrame);
  static_cast<QwtPlotCanvas*>(plot.canvas())->setFrameStyle(QFrame::NoFrame);
  plot.setAxisMaxMajor(QwtPlot::xBottom, 5);
  plot.setAxisMaxMajor(QwtPlot::yLeft, 4);
  plot.setAxisMaxMinor(QwtPlot::xBottom, 0);
  plot.setAxisMaxMinor(QwtPlot::yLeft, 0);
  for (const int axis : {int(QwtPlot::xBottom), int(QwtPlot::yLeft)}) {
    plot.axisScaleDraw(axis)->enableComponent(QwtAbstractScaleDraw::Backbone, false);
    plot.axisScaleDraw(axis)->setTickLength(QwtScaleDiv::MajorTick, 3);
  }
}

void stylePlot(QwtPlot& plot, const Theme& theme) {
  plot.setCanvasBackground(theme.color(Role::Panel));
  QPalette colors = plot.palette();
  colors.setColor(QPalette::Window, theme.color(Role::Panel));
  colors.setColor(QPalette::WindowText, theme.color(Role::FieldEdge));
  colors.setColor(QPalette::Text, theme.color(Role::TextSecondary));
  plot.setPalette(colors);
  plot.setAutoFillBackground(true);
  for (const int axis : {int(QwtPlot::xBottom), int(QwtPlot::yLeft)}) {
    plot.axisWidget(axis)->setPalette(colors);
    plot.setAxisFont(axis, theme.font(8.0));
  }
}

}  // namespace editor
