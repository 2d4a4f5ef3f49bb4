#pragma once

#include <QtTest>

#include "app/window/MainWindow.h"
#include "app/window/NoticeBar.h"
#include "app/window/files/FileDialogs.h"
#include "sim2d/base/Text.h"
#include "sim2d/scenario/ScenarioFile.h"
#include "tests/support/Widgets.h"

/// A window for tests: its theme and its memory do not depend on who runs them.
namespace quiet {

inline app::WindowSetup setup() {
  app::WindowSetup setup;
  setup.followsSystem = false;
  setup.storesSettings = false;
  setup.shippedMaps = QStringLiteral(SOURCE_DIR "/maps");
  return setup;
}

inline QString demoPath() {
  return QStringLiteral(SOURCE_DIR "/maps/corner_cafe/corner_cafe_agents.yaml");
}

inline std::unique_ptr<app::MainWindow> shownWindow(const app::WindowSetup& how = setup()) {
  auto window = std::make_unique<app::MainWindow>(how);
  window->resize(1280, 800);
  window->show();
  [&] { QVERIFY(QTest::qWaitForWindowExposed(window.get())); }();
  return window;
}

/// Closes it without a question about changes.
inline void leave(std::unique_ptr<app::MainWindow>& window) {
  window->workspace().document().undoStack().setClean();
  window.reset();
}

/// The café with its map found by name, as this file; empty when it cannot be written.
inline QString copyOfDemo(const QString& file) {
  sim2d::ScenarioReading demo = sim2d::readScenario(demoPath().toStdString());
  demo.scenario.yamlBaseName = "demo";
  const base::Diagnostics problems =
      base::writeFileAtomically(file.toStdString(), sim2d::writeScenario(demo.scenario));
  return problems.empty() ? file : QString();
}

/// A copy of the café that names this map.
inline QString copyOnMap(const QString& file, const char* map) {
  sim2d::ScenarioReading demo = sim2d::readScenario(demoPath().toStdString());
  demo.scenario.map = map;
  demo.scenario.desktop.mapFile.reset();
  const base::Diagnostics problems =
      base::writeFileAtomically(file.toStdString(), sim2d::writeScenario(demo.scenario));
  return problems.empty() ? file : QString();
}

/// The field or list of a dialog that screen readers call so.
template <class Part>
Part& part(const QWidget& dialog, const char* name) {
  return *widgets::named<Part>(dialog, QString::fromUtf8(name));
}

/// Chooses the simulator that an export is for.
inline void setTarget(const app::ExportDialog& dialog, const char* name) {
  QListWidget& targets = part<QListWidget>(dialog, "Simulator");
  for (int row = 0; row < targets.count(); ++row) {
    if (targets.item(row)->data(Qt::UserRole) == QString::fromUtf8(name)) {
      targets.setCurrentRow(row);
    }
  }
}

/// Sets the resolution of the image of a map by number.
inline void setResolution(const app::ImageMapDialog& dialog, double metresPerPixel) {
  dialog.findChildren<QRadioButton*>().last()->setChecked(true);
  part<QDoubleSpinBox>(dialog, "Resolution").setValue(metresPerPixel);
}

/// Without words: it is not told.
inline app::Notice noticeOf(app::MainWindow& window, const char* id) {
  for (const app::Notice& notice : window.notices().notices()) {
    if (notice.id == QString::fromUtf8(id)) {
      return notice;
    }
  }
  return {};
}

/// What is done with the next dialog of a kind that opens within five seconds.
template <class Dialog>
void answerDialog(const std::function<void(Dialog&)>& answer) {
  constexpr int kEvery = 50;  // [ms]
  auto* timer = new QTimer(qApp);
  QObject::connect(timer, &QTimer::timeout, timer, [timer, answer, left = 100]() mutable {
    auto* dialog = qobject_cast<Dialog*>(QApplication::activeModalWidget());
    if (dialog != nullptr || --left == 0) {
      timer->stop();
      timer->deleteLater();
    }
    if (dialog != nullptr) {
      answer(*dialog);
    }
  });
  timer->start(kEvery);
}

/// The next message box is answered so, and its text is kept.
inline void answerBox(QMessageBox::StandardButton button, QString& text) {
  text.clear();
  answerDialog<QMessageBox>([button, &text](QMessageBox& box) {
    text = box.text();
    box.button(button)->click();
  });
}

/// Pictures for people to look at, when HUNAV_PICTURES names a folder for them.
inline void shoot(QWidget& widget, const QByteArray& name) {
  const QByteArray folder = qgetenv("HUNAV_PICTURES");
  QCoreApplication::processEvents();
  if (!folder.isEmpty()) {
    QVERIFY(widget.grab().save(QString::fromLocal8Bit(folder + '/' + name + ".png")));
  }
}

/// For tests of one window with files in a folder of their own, both made anew for each.
class InFolder {
 protected:
  /// A tree of somebody's own.
  static constexpr const char* kTree =
      "<root BTCPP_format=\"4\" main_tree_to_execute=\"Mine\">\n  <BehaviorTree ID=\"Mine\">\n"
      "    <Sequence>\n      <GoTo agent_id=\"{id}\" goal_id=\"1\" time_step=\"{dt}\"/>\n"
      "      <RegularNav agent_id=\"{id}\" time_step=\"{dt}\"/>\n    </Sequence>\n"
      "  </BehaviorTree>\n</root>\n";

  void begin() {
    folder_ = std::make_unique<QTemporaryDir>();
    window_ = shownWindow();
  }
  void end() { leave(window_); }

  editor::ScenarioDocument& document() { return window_->workspace().document(); }
  QString at(const char* name) const { return folder_->filePath(QString::fromUtf8(name)); }
  QString copyOfDemo() const { return quiet::copyOfDemo(at("demo.yaml")); }
  QString demoOnMap(const char* map) const { return copyOnMap(at("demo.yaml"), map); }

  /// The café as cafe.yaml with an image of an uncommon name, and other maps beside it.
  QString mapWithNeighbours() const {
    const QString source = QStringLiteral(SOURCE_DIR "/maps/corner_cafe/corner_cafe");
    QFile::copy(source + QStringLiteral(".pgm"), at("cafe.image"));
    QFile::copy(source + QStringLiteral(".pgm"), at("other.pgm"));
    const std::string yaml = *base::readTextFile((source + QStringLiteral(".yaml")).toStdString());
    std::string own = yaml;
    const std::string image = "corner_cafe.pgm";
    own.replace(own.find(image), image.size(), "cafe.image");
    const bool isWritten =
        base::writeFileAtomically(at("cafe.yaml").toStdString(), own).empty() &&
        base::writeFileAtomically(at("other.yaml").toStdString(), yaml).empty() &&
        base::writeFileAtomically(at("damaged.yaml").toStdString(), yaml + "x: [\n").empty();
    QFile::link(at("cafe.yaml"), at("link.yaml"));
    return isWritten ? at("cafe.yaml") : QString();
  }

  app::Notice told(const char* id) const { return noticeOf(*window_, id); }
  /// Somewhere in the window.
  bool isSaid(const QString& words) const {
    return widgets::withText<QLabel>(*window_, words) != nullptr;
  }
  void answerBox(QMessageBox::StandardButton button) { quiet::answerBox(button, boxText_); }

  std::unique_ptr<QTemporaryDir> folder_;
  std::unique_ptr<app::MainWindow> window_;
  QString boxText_;  // of the last box that was answered
};

}  // namespace quiet
