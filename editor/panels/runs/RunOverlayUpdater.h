#pragma once

#include <cstdint>
#include <map>
#include <optional>

#include <QtWidgets>

#include "editor/canvas/MapView.h"
#include "editor/panels/EventsPanel.h"
#include "editor/run/SimulationRunner.h"

namespace editor {

/// Transfers contacts and thoughts from the recording of a run to the active map overlays. A
/// tooltip at the mouse shows name, action, reason and speech of an agent.
class RunOverlayUpdater : public QObject {
  Q_OBJECT
 public:
  RunOverlayUpdater(SimulationRunner& runner, const RunEvents& events, MapView& view);

  /// Text lines about a person or robot in the shown state; empty: not in it.
  QString tooltipFor(int id) const;

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void follow();
  void readContacts();
  void updateThoughts();
  QString thoughtOf(int id) const;
  QStringList speechOf(int id, double time) const;

  SimulationRunner& runner_;
  const RunEvents& events_;
  MapView& view_;
  QTimer soon_;             // Schedules reading of further contacts.
  RecordingPtr recording_;  // Its contacts have been read.
  std::size_t read_ = 0;    // Number of events read.
  QElapsedTimer sinceThoughts_;
  std::optional<std::int64_t> thoughtStep_;  // Step of the shown thoughts.
  std::optional<int> thoughtAgent_;
};

}  // namespace editor
