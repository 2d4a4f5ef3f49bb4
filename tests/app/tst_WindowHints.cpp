#include "editor/look/AppStyle.h"
#include "tests/app/QuietWindow.h"

using app::MainWindow;

/// Every command says what it does: in the status bar, and in a tooltip where it is an icon.
class WindowHintsTest : public QObject {
  Q_OBJECT

 private:
  std::unique_ptr<MainWindow> window_;

  /// All entries of a menu and of those within it.
  static std::vector<QAction*> entriesOf(const QMenu& menu) {
    std::vector<QAction*> found;
    for (QAction* action : menu.actions()) {
      if (action->menu() != nullptr) {
        const std::vector<QAction*> more = entriesOf(*action->menu());
        found.insert(found.end(), more.begin(), more.end());
      } else if (!action->isSeparator()) {
        found.push_back(action);
      }
    }
    return found;
  }

 private Q_SLOTS:
  void initTestCase() {
    editor::applyTheme(editor::Theme::light());
    window_ = std::make_unique<MainWindow>(quiet::setup());
    window_->show();
    QVERIFY(window_->open(quiet::demoPath()));
    QVERIFY(QTest::qWaitForWindowExposed(window_.get()));
  }
  void cleanupTestCase() { window_.reset(); }

  void menus_everyEntry_hasASentence() {
    int count = 0;
    for (QAction* top : window_->menuBar()->actions()) {
      for (const QAction* entry : entriesOf(*top->menu())) {
        ++count;
        QVERIFY2(!entry->statusTip().isEmpty(), qPrintable(entry->text()));
        QVERIFY2(entry->toolTip().contains(entry->statusTip()), qPrintable(entry->text()));
      }
    }
    QVERIFY(count > 60);
  }

  void buttons_everyone_hasATooltip_data() {
    QTest::addColumn<QString>("selected");
    QTest::newRow("nothing") << QString();
    QTest::newRow("person") << QStringLiteral("Human");
    QTest::newRow("goal") << QStringLiteral("Goal");
    QTest::newRow("robot") << QStringLiteral("Robot");
    QTest::newRow("obstacle") << QStringLiteral("Obstacle");
  }

  void buttons_everyone_hasATooltip() {
    QFETCH(QString, selected);
    const std::map<QString, base::EntityKind> kinds = {
        {QStringLiteral("Human"), base::EntityKind::Human},
        {QStringLiteral("Goal"), base::EntityKind::Goal},
        {QStringLiteral("Robot"), base::EntityKind::Robot},
        {QStringLiteral("Obstacle"), base::EntityKind::Obstacle}};
    editor::ScenarioDocument& document = window_->workspace().document();
    const auto kind = kinds.find(selected);
    document.setSelection(
        kind == kinds.end() ? std::vector<base::EntityId>()
                            : std::vector<base::EntityId>{document.entities(kind->second).front()});
    QCoreApplication::processEvents();
    QStringList silent;
    for (const QToolButton* button : window_->findChildren<QToolButton*>()) {
      const bool isOurs = !button->objectName().startsWith(QStringLiteral("qt_")) &&
                          qobject_cast<QMenuBar*>(button->parentWidget()) == nullptr &&
                          qobject_cast<QTabBar*>(button->parentWidget()) == nullptr &&
                          button->metaObject()->className() != QByteArray("QLineEditIconButton");
      const QString where =
          QStringLiteral("%1 '%2' in %3")
              .arg(QLatin1String(button->metaObject()->className()), button->text(),
                   QLatin1String(button->parentWidget()->metaObject()->className()));
      if (isOurs && button->toolTip().isEmpty()) {
        silent << where;
      }
    }
    QCOMPARE(silent.join(QLatin1Char('\n')), QString());
    for (const QComboBox* box : window_->findChildren<QComboBox*>()) {
      QVERIFY2(!box->toolTip().isEmpty() || !box->accessibleName().isEmpty(),
               qPrintable(box->currentText()));
    }
  }
};

QTEST_MAIN(WindowHintsTest)
#include "tst_WindowHints.moc"
