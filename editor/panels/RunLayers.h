#pragma once

#include <cstdint>
#include <map>
#include <optional>

#include <QElapsedTimer>
#include <QObject>
#include <QString>
#include <QTimer>

#include "editor/canvas/MapView.h"
#include "editor/panels/RunEvents.h"
#include "editor/run/SimulationRunner.h"

namespace editor {

/// Brings to the map what overlays tell of the record of a run, while they are on: contacts and
/// thoughts. Beside the mouse it says who somebody is, what they do, why, and what they say and
/// hear.
class RunLayers : public QObject {
  Q_OBJECT
 public:
  RunLayers(SimulationRunner& runner, const RunEvents& events, MapView& view);

  /// Some lines about a person or robot of the moment that is shown; empty: not there.
  QString wordsOn(int id) const;

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void follow();
  void readContacts();
  void tellThoughts();
  QString thoughtOf(int id) const;
  QStringList speechOf(int id, double time) const;

  SimulationRunner& runner_;
  const RunEvents& events_;
  MapView& view_;
  QTimer soon_;             // goes on reading contacts
  RecordingPtr recording_;  // whose contacts are read
  std::size_t read_ = 0;    // of its events
  QElapsedTimer sinceThoughts_;
  std::optional<std::int64_t> thoughtStep_;  // of the thoughts that are shown
  std::optional<int> thoughtGuest_;
};

}  // namespace editor
