#include "app/window/KeyRules.h"
#include "app/window/settings/ShortcutsPage.h"
#include "editor/document/EditCommands.h"
#include "editor/look/AppStyle.h"
#include "editor/look/Form.h"
#include "tests/app/QuietWindow.h"

/// The list of keys is made from the commands and tools, so that none is missing.
class ShortcutsDialogTest : public QObject, protected quiet::InFolder {
  Q_OBJECT

 private:
  app::ShortcutsDialog* dialog_ = nullptr;

  std::vector<const QTreeWidgetItem*> seenRows() const {
    std::vector<const QTreeWidgetItem*> rows;
    for (QTreeWidgetItemIterator each(&dialog_->list()); *each != nullptr; ++each) {
      if ((*each)->parent() != nullptr && !(*each)->isHidden()) {
        rows.push_back(*each);
      }
    }
    return rows;
  }

 private Q_SLOTS:
  void initTestCase() { editor::applyTheme(editor::Theme::light()); }
  void init() {
    begin();
    QVERIFY(window_->open(quiet::demoPath()));
    QCOMPARE(window_->actions().shortcuts->shortcut(), QKeySequence(int{Qt::CTRL} | Qt::Key_F1));
    window_->actions().shortcuts->trigger();
    dialog_ = window_->findChild<app::ShortcutsDialog*>();
    QVERIFY(dialog_ != nullptr && dialog_->isVisible());
  }
  void cleanup() { end(); }

  void list_namesOfUndoAndRedo_stay() {
    dialog_->reject();
    editor::pushChange<editor::ScenarioSettings>(
        document(), editor::kSettingsId, QStringLiteral("Change duration"),
        [](editor::ScenarioSettings& settings) { settings.desktop.duration = 7.0; });
    QVERIFY(window_->actions().undo->text().contains(QLatin1String("Change duration")));
    window_->actions().shortcuts->trigger();
    dialog_ = window_->findChildren<app::ShortcutsDialog*>().last();
    for (const char* name : {"Undo", "Redo"}) {
      const std::vector<const QTreeWidgetItem*> rows = seenRows();
      QVERIFY(std::any_of(rows.begin(), rows.end(),
                          [name](const auto* row) { return row->text(0) == QLatin1String(name); }));
    }
  }

  void list_everyCommandWithAKey_isThereOnce() {
    const std::vector<const QTreeWidgetItem*> rows = seenRows();
    QStringList wanted;
    for (const QAction* action : window_->findChildren<QAction*>()) {
      const QList<QWidget*> widgets = action->associatedWidgets();
      const bool isInMenu = std::any_of(widgets.begin(), widgets.end(), [](const QWidget* widget) {
        return qobject_cast<const QMenu*>(widget) != nullptr;
      });
      if (isInMenu && !action->shortcut().isEmpty()) {
        wanted << action->statusTip();
      }
    }
    QVERIFY(wanted.size() > 30);
    for (const QString& says : wanted) {
      QVERIFY2(std::any_of(rows.begin(), rows.end(),
                           [&says](const auto* row) { return row->text(2) == says; }),
               qPrintable(says));
    }
    for (const auto& entry : window_->workspace().tools().entries()) {
      const auto count = std::count_if(rows.begin(), rows.end(), [&entry](const auto* row) {
        return row->text(0) == entry.info.name && row->text(2) == entry.action->statusTip();
      });
      QVERIFY2(count == (entry.info.shortcut.isEmpty() ? 0 : 1), qPrintable(entry.info.name));
    }
  }

  void search_byKeyOrWords_leavesWhatFits() {
    dialog_->search().setText(QStringLiteral("ctrl+g"));
    QCOMPARE(seenRows().size(), std::size_t{1});
    QCOMPARE(seenRows().front()->text(0), QStringLiteral("Assign goals"));
    dialog_->search().setText(QStringLiteral("rotate"));
    QVERIFY(seenRows().size() >= 2);
    QCOMPARE(seenRows().front()->text(1), QStringLiteral("["));  // heard by the tool
    dialog_->search().setText(QStringLiteral("zzz"));
    QVERIFY(seenRows().empty());
    QVERIFY(dialog_->findChild<editor::NoMatchesPlaceholder*>()->isVisible());
  }

  void dialog_askedForAgain_isTheSame() {
    window_->actions().shortcuts->trigger();
    QCOMPARE(window_->findChildren<app::ShortcutsDialog*>().size(), 1);
    dialog_->close();
    QTRY_VERIFY(window_->findChildren<app::ShortcutsDialog*>().isEmpty());
    window_->actions().shortcuts->trigger();
    QCOMPARE(window_->findChildren<app::ShortcutsDialog*>().size(), 1);
  }

  void rules_forKeys_areToldAsTheyCount() {
    QCOMPARE(app::KeyRules::rules().size(), 4);
    for (const QString& rule : app::KeyRules::rules()) {
      const QList<QLabel*> labels = dialog_->findChildren<QLabel*>();
      QVERIFY(std::any_of(labels.begin(), labels.end(),
                          [&rule](const QLabel* label) { return label->text() == rule; }));
    }
    quiet::shoot(*dialog_, "shortcuts");
  }
};

QTEST_MAIN(ShortcutsDialogTest)
#include "tst_ShortcutsDialog.moc"
