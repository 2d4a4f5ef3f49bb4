#include "app/window/help/ManualPages.h"

#include "app/run/DataPaths.h"
#include "editor/look/Form.h"

namespace app {

const std::vector<ManualPage>& manualPages() {
  static const std::vector<ManualPage> kPages = {
      {"index", QT_TRANSLATE_NOOP("Manual", "Contents")},
      {"install", QT_TRANSLATE_NOOP("Manual", "Installation")},
      {"first-scenario", QT_TRANSLATE_NOOP("Manual", "First scenario")},
      {"window", QT_TRANSLATE_NOOP("Manual", "The window")},
      {"your-map", QT_TRANSLATE_NOOP("Manual", "Your own map")},
      {"people-and-groups", QT_TRANSLATE_NOOP("Manual", "People and groups")},
      {"behaviour-tree", QT_TRANSLATE_NOOP("Manual", "Behaviour trees")},
      {"robots-and-sensors", QT_TRANSLATE_NOOP("Manual", "Robots and sensors")},
      {"robots", QT_TRANSLATE_NOOP("Manual", "List of robots")},
      {"planners", QT_TRANSLATE_NOOP("Manual", "Planners")},
      {"models", QT_TRANSLATE_NOOP("Manual", "Pedestrian models")},
      {"compare-planners", QT_TRANSLATE_NOOP("Manual", "Compare planners")},
      {"leaderboard", QT_TRANSLATE_NOOP("Manual", "Leaderboard")},
      {"sensitivity", QT_TRANSLATE_NOOP("Manual", "Sensitivity analysis")},
      {"tuning", QT_TRANSLATE_NOOP("Manual", "Parameter tuning")},
      {"share", QT_TRANSLATE_NOOP("Manual", "Share a study")},
      {"find-failures", QT_TRANSLATE_NOOP("Manual", "Find failures")},
      {"nav2", QT_TRANSLATE_NOOP("Manual", "Nav2")},
      {"own-planner", QT_TRANSLATE_NOOP("Manual", "Your own planner")},
      {"python", QT_TRANSLATE_NOOP("Manual", "Python")},
      {"ros2", QT_TRANSLATE_NOOP("Manual", "ROS 2 and other simulators")},
      {"recordings", QT_TRANSLATE_NOOP("Manual", "Recordings and bags")},
      {"metrics", QT_TRANSLATE_NOOP("Manual", "Metrics")},
      {"nodes", QT_TRANSLATE_NOOP("Manual", "Nodes of behaviour trees")},
      {"file-formats", QT_TRANSLATE_NOOP("Manual", "File formats")},
      {"commands", QT_TRANSLATE_NOOP("Manual", "Commands")},
      {"gate", QT_TRANSLATE_NOOP("Manual", "Tests on a build server")},
      {"cluster", QT_TRANSLATE_NOOP("Manual", "Studies on a cluster")},
      {"scenarios", QT_TRANSLATE_NOOP("Manual", "List of scenarios")},
      {"troubleshooting", QT_TRANSLATE_NOOP("Manual", "Troubleshooting")},
      {"cite", QT_TRANSLATE_NOOP("Manual", "How to cite")},
      {"glossary", QT_TRANSLATE_NOOP("Manual", "Glossary")}};
  return kPages;
}

namespace {

struct PageOf {
  const char* key;
  const char* page;
};

/// Pages by class. A class in the table also stands for the classes derived from it.
constexpr PageOf kClasses[] = {{"app::StartPage", "first-scenario"},
                               {"app::StudyPanel", "compare-planners"},
                               {"app::ExportDialog", "ros2"},
                               {"app::RoomDialog", "your-map"},
                               {"app::ImageMapDialog", "your-map"},
                               {"app::TreeChoiceDialog", "behaviour-tree"},
                               {"app::HistoryDialog", "recordings"},
                               {"editor::ScenarioPanel", "people-and-groups"},
                               {"editor::IssuesPanel", "troubleshooting"},
                               {"editor::MetricsDock", "metrics"},
                               {"editor::RunsPanel", "recordings"},
                               {"editor::FuturesPanel", "recordings"},
                               {"editor::TimelineBar", "recordings"},
                               {"editor::SideView", "recordings"},
                               {"editor::BehaviorPanel", "behaviour-tree"},
                               {"editor::TreeEditor", "behaviour-tree"},
                               {"editor::NodePalette", "nodes"},
                               {"editor::Nav2Form", "nav2"},
                               {"editor::Nav2Panel", "nav2"},
                               {"editor::LayersPanel", "window"},
                               {"app::RunExportDialog", "recordings"},
                               {"editor::GoalAssignment", "people-and-groups"},
                               {"editor::BehaviorMixDialog", "behaviour-tree"},
                               {"editor::BlockDialog", "behaviour-tree"},
                               {"editor::BranchDialog", "recordings"},
                               {"app::SavePictureDialog", "recordings"},
                               {"app::SaveFilmDialog", "recordings"},
                               {"editor::TextViewer", "file-formats"},
                               {"editor::PropertyPanel", "window"},
                               {"editor::MapView", "window"},
                               {"QMainWindow", "window"},
                               {"QDialog", "window"}};

constexpr PageOf kTools[] = {{"tool-person", "people-and-groups"},
                             {"tool-brush", "people-and-groups"},
                             {"tool-fill", "people-and-groups"},
                             {"tool-goal", "people-and-groups"},
                             {"tool-route", "people-and-groups"},
                             {"tool-robot", "robots-and-sensors"},
                             {"tool-dock", "nav2"},
                             {"tool-wall", "your-map"},
                             {"tool-box", "your-map"},
                             {"tool-circle", "your-map"},
                             {"tool-polygon", "your-map"},
                             {"tool-door", "your-map"},
                             {"tool-area", "your-map"},
                             {"tool-map", "your-map"}};

template <std::size_t Size>
const char* pageIn(const PageOf (&table)[Size], const char* key) {
  for (const PageOf& row : table) {
    if (std::strcmp(row.key, key) == 0) {
      return row.page;
    }
  }
  return nullptr;
}

QString pageOfClass(const QMetaObject* type) {
  for (; type != nullptr; type = type->superClass()) {
    if (const char* page = pageIn(kClasses, type->className())) {
      return QString::fromLatin1(page);
    }
  }
  return {};
}

}  // namespace

QString manualPageOf(const QWidget* widget) {
  for (const QWidget* each = widget; each != nullptr; each = each->parentWidget()) {
    const QString own = each->property(editor::kManualPageProperty).toString();
    QString page = own.isEmpty() ? pageOfClass(each->metaObject()) : own;
    if (!page.isEmpty()) {
      return page;
    }
  }
  return QStringLiteral("index");
}

QString manualPageOfTool(const QString& icon) {
  const char* page = pageIn(kTools, icon.toLatin1().constData());
  return QString::fromLatin1(page == nullptr ? "window" : page);
}

ManualFolders installedManual() {
  const QString staged = QFileInfo(QString::fromStdString(programPath())).absolutePath() +
                         QStringLiteral("/manual/source");  // with the generated pages
  const QString shipped = QString::fromStdString(shippedResources("manual"));
  ManualFolders folders;
  folders.html = QString::fromStdString(builtManual());
  for (const QString& folder : {shipped, staged}) {
    if (!folder.isEmpty() && QFileInfo::exists(folder + QStringLiteral("/index.md"))) {
      folders.markdown = folder;
    }
  }
  return folders;
}

}  // namespace app
