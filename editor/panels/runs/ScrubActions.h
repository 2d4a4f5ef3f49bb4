#pragma once

#include <functional>
#include <optional>

#include "editor/canvas/ComparedRunLayers.h"
#include "editor/canvas/MapScene.h"
#include "editor/look/Theme.h"
#include "editor/panels/EventsPanel.h"
#include "editor/run/SimulationRunner.h"

namespace editor {

/// Navigation in a run: previous and next contact, loop, onion skin. GUI thread.
class ScrubActions : public QObject {
  Q_OBJECT
 public:
  ScrubActions(SimulationRunner& runner, RunEvents& events, MapScene& scene);
  void setTheme(const Theme& theme);

  QAction *const previousContact, *const nextContact, *const loop, *const onionSkin;
  QList<QAction*> all() const { return {previousContact, nextContact, loop, onionSkin}; }
  /// Trail lengths; exactly one is checked.
  QList<QAction*> trailLengths() const { return lengths_->actions(); }
  const OnionLayer& onion() const { return *onion_; }
  static constexpr double kSkinGap = 1.0;  // Time between two skins [s].

 private:
  void follow();
  void addContacts(int first, int last);
  /// Step of a contact in a state other than the shown one; -1: none.
  std::int64_t neighbouringContact(bool later) const;
  void goTo(bool later);
  void setLoopEnabled(bool on);
  void showOnionSkin();
  void makeLengths();

  SimulationRunner& runner_;
  RunEvents& events_;
  MapScene& scene_;
  OnionLayer* onion_;  // Belongs to the scene.
  QActionGroup* lengths_ = new QActionGroup(this);
  std::vector<std::int64_t> contacts_;  // Steps in ascending order.
};

/// The markers A and B of the loop on a timeline: painting, hit testing and dragging.
class LoopMarks {
 public:
  /// Conversion between time [s] and x [px].
  struct Scale {
    std::function<double(double)> xOf, timeAt;
  };
  LoopMarks(SimulationRunner& runner, Scale scale) : runner_(runner), scale_(std::move(scale)) {}

  void paint(QPainter& painter, const Theme& theme) const;
  /// Returns true if the mouse has grabbed a part of the loop; `fresh`: a new loop starts at `at`.
  bool press(const QPointF& at, bool fresh);
  bool drag(double x);  // Returns true during a drag.
  void release() { held_ = Held::Nothing; }
  bool isOver(const QPointF& at) const { return markAt(at) != Held::Nothing; }

 private:
  enum class Held { Nothing, From, To };
  Held markAt(const QPointF& at) const;

  SimulationRunner& runner_;
  Scale scale_;
  Held held_ = Held::Nothing;
  double anchor_ = 0.0;  // The other end [s].
};

}  // namespace editor
