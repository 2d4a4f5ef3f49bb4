#pragma once

#include "app/report/Figure.h"
#include "app/window/Workspace.h"
#include "editor/panels/PanelRegistry.h"

namespace app {

/// Copies and saves the plots of the panels as figures for publications: light colours, 170 mm
/// wide, with scenario and seed below. Copies are PNG (300 dpi) and SVG; files are PNG, SVG or PDF.
class PlotExport : public QObject {
  Q_OBJECT
 public:
  PlotExport(Workspace& workspace, editor::PanelContext& context, QWidget& window);

 Q_SIGNALS:
  void message(const QString& words);

 private:
  void copy(const editor::PlottedFigure& plot);
  void save(const editor::PlottedFigure& plot);
  report::Figure figureOf(const editor::PlottedFigure& plot) const;

  Workspace& workspace_;
  QWidget& window_;
};

}  // namespace app
