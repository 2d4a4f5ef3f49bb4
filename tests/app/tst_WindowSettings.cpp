#include "app/window/files/FileDialogs.h"
#include "app/window/help/Commands.h"
#include "app/window/settings/PreferencesDialog.h"
#include "editor/look/AppStyle.h"
#include "editor/look/Fields.h"
#include "tests/app/QuietWindow.h"

/// Preferences and the key map, changed as a user does and remembered by the next window.
class WindowSettingsTest : public QObject, protected quiet::InFolder {
  Q_OBJECT

 private:
  void restart() {
    quiet::leave(window_);
    QSettings::setPath(QSettings::NativeFormat, QSettings::UserScope, folder_->path());
    app::WindowSetup setup = quiet::setup();
    setup.storesSettings = true;
    setup.recoveryFolder = at("recovery");
    window_ = quiet::shownWindow(setup);
  }
  app::PreferencesDialog& dialog() {
    window_->actions().preferences->trigger();
    return *window_->findChild<app::PreferencesDialog*>();
  }
  app::ShortcutsPage& keys() {
    app::PreferencesDialog& all = dialog();
    all.pages().setCurrentIndex(2);
    return all.shortcuts();
  }
  static void select(app::ShortcutsPage& page, const QString& name) {
    for (QTreeWidgetItemIterator row(&page.list()); *row != nullptr; ++row) {
      if ((*row)->text(0) == name && (*row)->parent() != nullptr) {
        page.list().setCurrentItem(*row);
        return;
      }
    }
    QFAIL(qPrintable(name));
  }
  static void press(const QWidget& in, const char* text) {
    auto* button = widgets::withText<QPushButton>(in, QString::fromUtf8(text));
    QVERIFY2(button != nullptr && button->isEnabled(), text);
    QTest::mouseClick(button, Qt::LeftButton);
  }

 private Q_SLOTS:
  void initTestCase() { editor::applyTheme(editor::Theme::light()); }
  void init() {
    begin();
    restart();
    QVERIFY(window_->open(quiet::demoPath()));
  }
  void cleanup() { end(); }

  void keys_changed_workAtOnceAndInTheNextWindow() {
    app::ShortcutsPage& page = keys();
    select(page, QStringLiteral("Grid"));
    QTest::keyClick(&page.field(), Qt::Key_F6);
    QCOMPARE(page.warning(), QString());
    press(page, "&Assign");
    QCOMPARE(window_->actions().grid->shortcut(), QKeySequence(Qt::Key_F6));
    QVERIFY(window_->actions().grid->toolTip().contains(QStringLiteral("F6")));
    window_->findChild<app::PreferencesDialog*>()->close();
    restart();
    QVERIFY(window_->open(quiet::demoPath()));
    QCOMPARE(window_->actions().grid->shortcut(), QKeySequence(Qt::Key_F6));
    window_->activateWindow();
    QVERIFY(QTest::qWaitForWindowActive(window_.get()));
    const bool before = window_->actions().grid->isChecked();
    QTest::keyClick(window_->windowHandle(), Qt::Key_F6);
    QCOMPARE(window_->actions().grid->isChecked(), !before);
    QTest::keyClick(window_->windowHandle(), Qt::Key_G, Qt::ShiftModifier);  // the former key
    QCOMPARE(window_->actions().grid->isChecked(), !before);
  }

  void keys_ofAnotherCommand_areWarnedAboutAndTaken() {
    app::ShortcutsPage& page = keys();
    select(page, QStringLiteral("Grid"));
    QTest::keyClick(&page.field(), Qt::Key_S, Qt::ControlModifier);
    QVERIFY2(page.warning().contains(QStringLiteral("\"Save\" (File)")),
             qPrintable(page.warning()));
    QVERIFY(!window_->actions().save->shortcut().isEmpty());  // not before it is assigned
    quiet::shoot(dialog(), "preferences-keys");
    press(page, "&Assign");
    QVERIFY(window_->actions().save->shortcut().isEmpty());
    QCOMPARE(window_->actions().grid->shortcut(), QKeySequence(int{Qt::CTRL} | Qt::Key_S));
    select(page, QStringLiteral("Save"));
    press(page, "&Default");
    QCOMPARE(window_->actions().save->shortcut(), QKeySequence(QKeySequence::Save));
    QVERIFY(window_->actions().grid->shortcut().isEmpty());
    press(page, "Restore a&ll defaults");
    QCOMPARE(window_->actions().grid->shortcut(), QKeySequence(int{Qt::SHIFT} | Qt::Key_G));
    QVERIFY(!window_->keyMap().isAnyChanged());
  }

  void keys_storedForTheFormerNameOfACommand_areKept() {
    app::UserSettings(true).setValue(
        "keys/changed",
        QVariantMap{{QStringLiteral("Run › Reset"), QStringList{QStringLiteral("F6")}}});
    restart();
    QCOMPARE(window_->workspace().playback().reset->shortcut(), QKeySequence(Qt::Key_F6));
    QCOMPARE(app::commandName(*window_->workspace().playback().reset),
             QStringLiteral("Return to editing"));
  }

  void keys_ofFields_cannotBeAssigned() {
    app::ShortcutsPage& page = keys();
    select(page, QStringLiteral("Grid"));
    QTest::keyClick(&page.field(), Qt::Key_Left);
    QVERIFY(!page.warning().isEmpty());
    QVERIFY(!widgets::withText<QPushButton>(page, QStringLiteral("&Assign"))->isEnabled());
  }

  void keys_removed_restoredWithAll() {
    app::ShortcutsPage& page = keys();
    select(page, QStringLiteral("Names"));
    press(page, "&Remove");
    QVERIFY(window_->actions().names->shortcut().isEmpty());
    window_->keyMap().resetAll();
    QCOMPARE(window_->actions().names->shortcut(), QKeySequence(Qt::Key_N));
  }

  void keys_rotationByTheTool_isFixed() {
    app::ShortcutsPage& page = keys();
    page.search().setText(QStringLiteral("rotate"));
    select(page, QStringLiteral("Rotate 15° left"));
    QVERIFY(!page.field().isEnabled());
    QVERIFY(!page.warning().isEmpty());
  }

  void dialog_lettersAreUniqueOnEachPage() {
    app::PreferencesDialog& all = dialog();
    for (int i = 0; i < all.pages().count(); ++i) {
      QStringList letters;
      for (const QAbstractButton* button : all.findChildren<QAbstractButton*>()) {
        const QWidget* page = all.pages().widget(i);
        const bool isHere = page->isAncestorOf(button) || !all.pages().isAncestorOf(button);
        const QString letter = QKeySequence::mnemonic(button->text()).toString();
        if (isHere && !letter.isEmpty()) {
          QVERIFY2(!letters.contains(letter), qPrintable(button->text()));
          letters << letter;
        }
      }
    }
    quiet::shoot(all, "preferences");
    QTest::keyClick(&all, Qt::Key_Escape);
    QVERIFY(all.isHidden());
  }

  void theme_chosen_changesAtOnceAndIsStored() {
    auto& theme = quiet::part<QComboBox>(dialog(), "Theme");
    theme.setCurrentIndex(2);
    Q_EMIT theme.activated(2);
    QVERIFY(window_->workspace().theme().isDark());
    QVERIFY(!window_->actions().systemTheme->isChecked());
    window_->actions().switchTheme->trigger();  // elsewhere
    QCOMPARE(theme.currentIndex(), 1);
    quiet::shoot(dialog(), "preferences-general");
  }

  void animation_off_fitMovesAtOnce() {
    auto* box =
        widgets::withText<QCheckBox>(dialog(), QStringLiteral("&Animate zooming and fitting"));
    QVERIFY(box->isChecked());
    box->click();
    editor::MapView& view = window_->workspace().view();
    view.fitAll();
    const double fitted = view.pixelsPerMetre();
    view.zoomBy(2.0);
    view.fitAll();
    QCOMPARE(view.pixelsPerMetre(), fitted);
    restart();
    QVERIFY(!window_->preferences().isAnimated());
  }

  void folder_preferred_isWhereDialogsStart() {
    document().clear();
    QDir(folder_->path()).mkdir(QStringLiteral("mine"));
    auto& folder = quiet::part<QLineEdit>(dialog(), "Default folder");
    folder.clear();
    QTest::keyClicks(&folder, at("mine"));
    QCOMPARE(window_->files().folder(), at("mine"));
    QTest::keyClicks(&folder, QStringLiteral("/none"));
    QVERIFY(folder.property(editor::kInvalidProperty).toBool());
    QCOMPARE(window_->files().folder(), at("mine"));
    QVERIFY(window_->open(copyOfDemo()));
    QCOMPARE(window_->files().folder(), folder_->path());  // beside the open scenario
  }

  void autosave_off_writesNoCopies() {
    window_->preferences().setAutosave(true, 1);
    window_->actions().selectAll->trigger();
    window_->actions().duplicate->trigger();
    const auto hasCopy = [this] {
      const QString folder = window_->guard().autosave()->folder();
      return !folder.isEmpty() && QFileInfo::exists(folder + QStringLiteral("/recovery.json"));
    };
    QTRY_VERIFY_WITH_TIMEOUT(hasCopy(), 20000);
    auto* box =
        widgets::withText<QCheckBox>(dialog(), QStringLiteral("&Keep copies of unsaved changes"));
    box->click();
    QTRY_VERIFY(!hasCopy());
    window_->actions().duplicate->trigger();
    window_->guard().autosave()->writeNow();  // an error in the program still keeps the work
    QVERIFY(hasCopy());
  }

  void reset_all_restoresEverything() {
    app::Preferences& preferences = window_->preferences();
    preferences.setAnimated(false);
    preferences.setAutosave(false, 40);
    preferences.setHistoryMegabytes(64);
    preferences.setFolder(folder_->path());
    window_->keyMap().assign(*window_->actions().grid, QKeySequence(Qt::Key_F6));
    press(dialog(), "R&estore defaults");
    QVERIFY(preferences.isAnimated());
    QVERIFY(preferences.isAutosaved());
    QCOMPARE(preferences.autosaveSeconds(), 3);
    QCOMPARE(preferences.historyMegabytes(), 256);
    QCOMPARE(preferences.folder(), QString());
    QVERIFY(!window_->keyMap().isAnyChanged());
  }

  void number_typedWithAComma_isTheDecimalPoint() {
    editor::NumberField field({0.0, 5.0, 2, 0.1}, QStringLiteral("m"));
    field.show(1.0, false);
    field.selectAll();
    QTest::keyClicks(&field, QStringLiteral("2,5"));
    QTest::keyClick(&field, Qt::Key_Return);
    QCOMPARE(field.value(), 2.5);
    QCOMPARE(field.text(), QStringLiteral("2.50 m"));
  }
};

QTEST_MAIN(WindowSettingsTest)
#include "tst_WindowSettings.moc"
