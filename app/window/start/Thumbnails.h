#pragma once

#include <deque>

#include "editor/look/Theme.h"

namespace app {

/// A scenario drawn as on the canvas, and what it contains.
struct Thumbnail {
  QImage picture;   // null: the scenario cannot be read
  int people = -1;  // -1: unknown
  int robots = 0;
};

/// Pictures of scenarios. They are kept in a folder, so that they are drawn once per change of the
/// file; drawing takes place in the event loop, one scenario at a time.
class Thumbnails : public QObject {
  Q_OBJECT
 public:
  struct Request {
    QString path;
    QSize size;  // [px]
    double ratio = 1.0;
  };

  /// `folder` empty: nothing is kept.
  Thumbnails(QString folder, QObject* parent);
  /// The newest request comes first; a waiting request for the same file is replaced.
  void request(const Request& request);
  /// Discards the waiting requests. The next ones are drawn in this theme.
  void setTheme(const editor::Theme& theme);
  bool isIdle() const { return waiting_.empty(); }
  int drawnCount() const { return drawn_; }  // not read from the folder

 Q_SIGNALS:
  void ready(const QString& path, const app::Thumbnail& thumbnail);

 private:
  void next();
  void schedule();
  QString fileOf(const Request& request) const;

  QString folder_;
  editor::Theme theme_;
  std::deque<Request> waiting_;
  bool isScheduled_ = false;
  int drawn_ = 0;
};

}  // namespace app
