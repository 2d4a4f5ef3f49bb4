#pragma once

#include <optional>

#include <QtWidgets>

#include "editor/canvas/MapScene.h"
#include "sim2d/trace/Recording.h"

namespace editor {

/// Reads the contacts and thoughts of a recording for the overlays of a scene, if the options of
/// the scene show them. GUI thread; reads for a limited time and schedules the rest.
class RunOverlayReader : public QObject {
 public:
  explicit RunOverlayReader(MapScene& scene, QObject* parent = nullptr);

  /// Call it for each shown state and when the options of the scene have changed. Null: no run.
  /// `isRunning`: thoughts are updated less often.
  void show(const std::shared_ptr<const sim2d::Recording>& recording, sim2d::FramePtr frame,
            bool isRunning);

 private:
  void readContacts();
  void updateThoughts(bool isRunning);

  MapScene& scene_;
  std::shared_ptr<const sim2d::Recording> recording_;  // Its contacts have been read.
  sim2d::FramePtr frame_;
  std::size_t read_ = 0;  // Number of events read.
  QTimer soon_;           // Schedules reading of further contacts.
  QElapsedTimer sinceThoughts_;
  std::optional<std::int64_t> thoughtStep_;  // Step of the shown thoughts.
  std::optional<int> thoughtAgent_;
};

}  // namespace editor
