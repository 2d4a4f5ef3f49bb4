#pragma once

#include <string>

#include <QtWidgets>

#include "app/cli/FigureStyle.h"
#include "app/window/Docks.h"
#include "app/window/WindowActions.h"

class QMimeData;

namespace app {

/// Copies figures for publications to the clipboard as PNG (300 dpi) and SVG: the displayed frame
/// with its overlays, or the selected metric.
class FigureCommands : public QObject {
  Q_OBJECT
 public:
  FigureCommands(Workspace& workspace, Docks& docks, const WindowActions& actions, QObject* parent);

 Q_SIGNALS:
  void message(const QString& words);

 private:
  void updateEnabled();
  void copyMap();
  void copyPlot();
  std::string selectedMetric() const;  // metric key; empty: none
  FigureOptions options() const;

  Workspace& workspace_;
  Docks& docks_;
  const WindowActions& actions_;
};

/// The frames of a recording up to `time`, thinned out so that the figure is created quickly.
sim2d::Trace figureTrace(const sim2d::Recording& recording, double time);

}  // namespace app
