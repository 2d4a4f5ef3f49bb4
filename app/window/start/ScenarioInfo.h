#pragma once

#include <QtWidgets>

#include "sim2d/scenario/Scenario.h"

namespace app {

/// What the gallery shows and filters by, from the card of the scenario as far as it has one.
struct ScenarioInfo {
  QString name;        // of the file
  QString title;       // "Corner café"
  QString family;      // group of the gallery: "Daily life"
  QString purpose;     // one sentence; empty: unknown
  QString details;     // the other texts of the card, one per line
  QString difficulty;  // "easy"; empty: unknown
  int people = -1;     // -1: not read yet
  int robots = 0;

  QString contents() const;  // "8 people · robot"
  /// Whether the texts contain each word.
  bool contains(const QString& words) const;
};

/// The info from the card of a scenario; what it lacks, from the name of the file and its folder.
ScenarioInfo infoOf(const QString& path, const sim2d::ScenarioCard& card);

/// Reads the card of a file. Safe in any thread. A file that cannot be read has the info of its
/// name.
ScenarioInfo infoOfFile(const QString& path);

}  // namespace app
