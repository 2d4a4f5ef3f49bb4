#pragma once

#include <QtWidgets>

#include "sim2d/scenario/Scenario.h"

namespace app {

/// What the gallery shows and filters by, from the card of the scenario as far as it has one.
struct ScenarioInfo {
  QString title;       // "Corner cafe"
  QString family;      // group of the gallery: "Planners"
  QString purpose;     // one sentence; empty: unknown
  QString difficulty;  // "easy"; empty: unknown
  int people = -1;     // -1: not read yet
  int robots = 0;

  QString contents() const;  // "8 people · robot"
  /// Whether title, family, purpose or difficulty contain each word of the text.
  bool contains(const QString& words) const;
};

/// The info of a shipped scenario without its contents: from its card, name and folder.
ScenarioInfo infoOfFile(const QString& name, const QString& path);

/// Adds what the scenario itself says.
void addContents(ScenarioInfo& info, const sim2d::Scenario& scenario);

/// Stores the info as texts of an image, and reads it from there.
void writeInfo(QImage& image, const ScenarioInfo& info);
ScenarioInfo readInfo(const QImage& image);

}  // namespace app
