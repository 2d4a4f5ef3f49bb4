#include "editor/look/AppStyle.h"
#include "editor/panels/properties/PropertyPanel.h"
#include "tests/app/QuietWindow.h"

/// Somebody whom a source brought into a run, in the whole window.
class WatchedGuestTest : public QObject, protected quiet::InFolder {
  Q_OBJECT

 private:
  bool isShown(const QString& words) const {
    const auto& panel = window_->docks().panel<editor::PropertyPanel>();
    const QList<QLabel*> labels = panel.findChildren<QLabel*>();
    return std::any_of(labels.begin(), labels.end(), [&](const QLabel* label) {
      return label->text() == words && label->isVisibleTo(&panel);
    });
  }
  void watch() {
    sim2d::TraceHeader header;
    header.humans.resize(1);
    header.humans[0].id = 99;
    header.humans[0].name = "entrance_1";
    header.humans[0].behavior = static_cast<int>(sim2d::BehaviorType::Regular);
    auto recording = std::make_shared<sim2d::Recording>();
    recording->setHeader(header);
    sim2d::Frame frame;
    frame.humans.add(99, {{7.0, 7.0}, 0.0}, {0.0, 0.0}, 0.0, sim2d::kNoGoal);
    frame.humans.group = {-1};
    frame.humans.state = {0};
    recording->addState(frame);
    window_->workspace().openRecorded(recording, QStringLiteral("run"));
    window_->workspace().scene().setSpawnedAgent(99);
  }

 private Q_SLOTS:
  void initTestCase() { editor::applyTheme(editor::Theme::light()); }
  void init() {
    begin();
    QVERIFY(window_->open(copyOfDemo()));
    document().setSelection({});
  }
  void cleanup() {
    window_->workspace().runner().reset();
    end();
  }

  void guest_onTheMap_isInTheProperties() {
    watch();
    QVERIFY(isShown(QStringLiteral("entrance_1")));
    document().setSelection({document().entities(base::EntityKind::Human).front()});
    QVERIFY(!isShown(QStringLiteral("entrance_1")));
  }

  void settings_andDeselecting_leaveTheGuest() {
    for (QAction* action : {window_->actions().settings, window_->actions().deselect}) {
      watch();
      QVERIFY(isShown(QStringLiteral("entrance_1")));
      action->trigger();
      QVERIFY(!window_->workspace().scene().spawnedAgent());
      QVERIFY(!isShown(QStringLiteral("entrance_1")));
    }
  }
};

QTEST_MAIN(WatchedGuestTest)
#include "tst_WatchedGuest.moc"
