#pragma once

#include <cstdint>
#include <vector>

#include <QAction>
#include <QActionGroup>

#include "editor/canvas/GhostLayer.h"
#include "editor/canvas/MapScene.h"
#include "editor/panels/RunEvents.h"

namespace editor {

/// Looking for something in a run: from contact to contact, a part again and again, where everybody
/// was and will be. GUI thread.
class ScrubActions : public QObject {
  Q_OBJECT
 public:
  ScrubActions(SimulationRunner& runner, RunEvents& events, MapScene& scene);
  void setTheme(const Theme& theme);

  QAction *const previousContact, *const nextContact, *const loop, *const onionSkin;
  QList<QAction*> all() const { return {previousContact, nextContact, loop, onionSkin}; }
  /// Of the trails, one of them checked.
  QList<QAction*> trailLengths() const { return lengths_->actions(); }
  const OnionLayer& onion() const { return *onion_; }
  static constexpr double kSkinGap = 1.0;  // [s] between two skins

 private:
  void follow();
  void takeContacts(int first, int last);
  /// Of a contact in another state than the one that is shown; -1: none.
  std::int64_t contactBeside(bool later) const;
  void goTo(bool later);
  void switchLoop(bool on);
  void showSkins();
  void makeLengths();

  SimulationRunner& runner_;
  RunEvents& events_;
  MapScene& scene_;
  OnionLayer* onion_;  // of the scene
  QActionGroup* lengths_;
  std::vector<std::int64_t> contacts_;  // steps, rising
};

}  // namespace editor
