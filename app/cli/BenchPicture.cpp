#include <QFileInfo>
#include <qwt_legend.h>
#include <qwt_plot.h>
#include <qwt_plot_canvas.h>
#include <qwt_plot_curve.h>
#include <qwt_plot_grid.h>
#include <qwt_plot_marker.h>
#include <qwt_plot_renderer.h>
#include <qwt_scale_draw.h>
#include <qwt_scale_engine.h>
#include <qwt_scale_widget.h>
#include <qwt_symbol.h>

#include "app/cli/BenchScene.h"
#include "editor/look/Theme.h"

namespace app {
namespace {

using editor::Role;

constexpr double kTickMs = 50.0;               // [ms] of simulated time
constexpr int kDotsPerInch = 144;              // twice the size of the text on a screen
const QSizeF kMillimetres = {254.0, 142.875};  // 1440 x 810 dots

/// 10, 100, 1 000 …; small times as they are.
class Powers : public QwtScaleDraw {
 public:
  QwtText label(double value) const override {
    const QLocale plain = QLocale::c();
    QString text = plain.toString(value, 'g', 12);
    for (int at = text.size() - 3; at > 0 && value >= 1000.0; at -= 3) {
      text.insert(at, QChar(0x202f));
    }
    return text;
  }
};

QwtText titled(const QString& text, const QFont& font, const QColor& color) {
  QwtText title(text);
  title.setFont(font);
  title.setColor(color);
  return title;
}

void setAxes(QwtPlot& plot, const editor::Theme& theme) {
  const QColor words = theme.color(Role::TextSecondary);
  plot.setAxisTitle(QwtPlot::xBottom, titled(QStringLiteral("people"), theme.font(9.0), words));
  plot.setAxisTitle(QwtPlot::yLeft,
                    titled(QStringLiteral("ms per step of 50 ms"), theme.font(9.0), words));
  for (const int axis : {int(QwtPlot::xBottom), int(QwtPlot::yLeft)}) {
    plot.setAxisScaleEngine(axis, new QwtLogScaleEngine);
    plot.setAxisScaleDraw(axis, new Powers);
    plot.setAxisMaxMinor(axis, 0);
    plot.setAxisFont(axis, theme.font(8.5));
    plot.axisScaleDraw(axis)->enableComponent(QwtAbstractScaleDraw::Backbone, false);
  }
}

void addCurve(QwtPlot& plot, const QString& name, const QVector<QPointF>& samples,
              const QPen& pen) {
  auto* curve = new QwtPlotCurve(name);
  curve->setSamples(samples);
  curve->setPen(pen);
  curve->setRenderHint(QwtPlotItem::RenderAntialiased);
  curve->setLegendAttribute(QwtPlotCurve::LegendShowLine);
  curve->setLegendIconSize(QSize(24, 8));
  if (pen.style() == Qt::SolidLine) {
    curve->setSymbol(new QwtSymbol(QwtSymbol::Ellipse, pen.color(), Qt::NoPen, QSize(6, 6)));
  }
  curve->setItemAttribute(QwtPlotItem::Legend, !name.isEmpty());
  curve->attach(&plot);
}

QVector<QPointF> samplesOf(const std::vector<BenchPoint>& points, double BenchPoint::*time) {
  QVector<QPointF> samples;
  for (const BenchPoint& point : points) {
    samples.push_back({static_cast<double>(point.people), point.*time});
  }
  return samples;
}

/// What was measured in one line, what follows from it dashed.
void addPlain(QwtPlot& plot, const std::vector<BenchPoint>& points, const QColor& color) {
  QVector<QPointF> measured;
  QVector<QPointF> scaled;
  for (const BenchPoint& point : points) {
    const QPointF sample(point.people, point.plain);
    if (!point.isScaled) {
      measured.push_back(sample);
      scaled.clear();
    }
    scaled.push_back(sample);
  }
  addCurve(plot, QStringLiteral("forces over all pairs, written plainly"), measured,
           QPen(color, 2.0));
  addCurve(plot, {}, scaled, QPen(color, 2.0, Qt::DashLine));
}

void addRealTime(QwtPlot& plot, const editor::Theme& theme) {
  auto* line = new QwtPlotMarker;
  line->setLineStyle(QwtPlotMarker::HLine);
  line->setLinePen(theme.color(Role::TextSecondary), 1.0, Qt::DotLine);
  line->setYValue(kTickMs);
  line->setLabel(
      titled(QStringLiteral("real time"), theme.font(8.5), theme.color(Role::TextSecondary)));
  line->setLabelAlignment(Qt::AlignLeft | Qt::AlignTop);
  line->attach(&plot);
}

}  // namespace

bool drawBench(const std::vector<BenchPoint>& points, const QString& machine, const QString& file) {
  const editor::Theme theme = editor::Theme::light();
  QwtPlot plot(titled(machine, theme.font(10.0, QFont::DemiBold), theme.color(Role::Text)));
  plot.setCanvasBackground(theme.color(Role::Panel));
  QPalette colors = plot.palette();
  colors.setColor(QPalette::Window, theme.color(Role::Panel));
  colors.setColor(QPalette::Text, theme.color(Role::TextSecondary));
  colors.setColor(QPalette::WindowText, theme.color(Role::FieldEdge));
  plot.setPalette(colors);
  plot.setFont(theme.font(9.0));
  static_cast<QwtPlotCanvas*>(plot.canvas())->setFrameStyle(QFrame::NoFrame);
  setAxes(plot, theme);
  auto* grid = new QwtPlotGrid;
  grid->setPen(theme.color(Role::Line), 1.0);
  grid->attach(&plot);
  addPlain(plot, points, theme.color(Role::TextSecondary));
  addCurve(plot, QStringLiteral("whole step, with trees, bodies and lidar"),
           samplesOf(points, &BenchPoint::whole), QPen(theme.color(Role::Text), 2.0));
  addCurve(plot, QStringLiteral("of which forces"), samplesOf(points, &BenchPoint::forces),
           QPen(theme.color(Role::Accent), 2.4));
  addRealTime(plot, theme);
  auto* legend = new QwtLegend;
  legend->setFont(theme.font(9.0));
  plot.insertLegend(legend, QwtPlot::BottomLegend);
  plot.setContentsMargins(12, 10, 16, 10);
  plot.resize(720, 405);
  plot.replot();
  QwtPlotRenderer renderer;
  renderer.setDiscardFlag(QwtPlotRenderer::DiscardCanvasFrame);
  renderer.renderDocument(&plot, file, kMillimetres, kDotsPerInch);
  return QFileInfo(file).size() > 0;
}

}  // namespace app
