#pragma once

#include <deque>

#include "app/window/start/ScenarioInfo.h"
#include "editor/look/Theme.h"

namespace app {

/// Pictures of scenarios, drawn as on the canvas. They are kept in a folder, so that they are drawn
/// once per change of the file; drawing takes place in the event loop, one scenario at a time.
class Thumbnails : public QObject {
  Q_OBJECT
 public:
  struct Request {
    QString path;
    ScenarioInfo info;  // from the name of the file
    QSize size;         // [px]
    double ratio = 1.0;
  };

  /// `folder` empty: nothing is kept.
  Thumbnails(QString folder, QObject* parent);
  /// Replaces the requests that are still waiting.
  void request(std::deque<Request> requests, const editor::Theme& theme);
  bool isIdle() const { return waiting_.empty(); }
  int drawnCount() const { return drawn_; }  // not read from the folder

 Q_SIGNALS:
  /// A picture is ready; null: the scenario cannot be read.
  void ready(const QString& path, const QImage& picture, const app::ScenarioInfo& info);

 private:
  void next();
  QString fileOf(const Request& request) const;

  QString folder_;
  editor::Theme theme_;
  std::deque<Request> waiting_;
  bool isScheduled_ = false;
  int drawn_ = 0;
};

}  // namespace app
