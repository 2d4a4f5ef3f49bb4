#pragma once

#include <QCoreApplication>

namespace editor {

class MapScene;
class ScenarioDocument;

/// The status texts of the selection tool.
class SelectToolTexts {
  Q_DECLARE_TR_FUNCTIONS(editor::SelectTool)
 public:
  /// During a run.
  static QString ofRun(const MapScene& scene);
  /// What can be done with the selected entities, of which there is at least one.
  static QString ofSelection(const ScenarioDocument& document);
};

}  // namespace editor
