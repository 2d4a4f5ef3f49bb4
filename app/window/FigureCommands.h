#pragma once

#include <string>

#include <QObject>
#include <QString>

#include "app/cli/FigureStyle.h"
#include "app/window/Docks.h"
#include "app/window/WindowActions.h"

class QMimeData;

namespace app {

/// Figures for papers to the clipboard, as PNG of 300 dots per inch and as SVG: the moment of the
/// run that is shown, with the overlays that are on, and the metric that is selected.
class FigureCommands : public QObject {
  Q_OBJECT
 public:
  FigureCommands(Workspace& workspace, Docks& docks, const WindowActions& actions, QObject* parent);

 Q_SIGNALS:
  void told(const QString& words);

 private:
  void follow();
  void copyMap();
  void copyPlot();
  std::string selectedMetric() const;  // key; empty: none
  FigureOptions options() const;

  Workspace& workspace_;
  Docks& docks_;
  const WindowActions& actions_;
};

/// The states of a recording up to a time, thinned out so that a figure of them is made at once.
sim2d::Trace figureTrace(const sim2d::Recording& recording, double time);

}  // namespace app
