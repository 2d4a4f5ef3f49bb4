#include "app/window/MainWindow.h"
#include "app/window/files/FileDialogs.h"
#include "editor/document/MapEdit.h"
#include "editor/look/AppStyle.h"
#include "tests/app/QuietWindow.h"

namespace {

/// Letters that two of these texts share.
QStringList sharedLetters(const QStringList& texts) {
  QMap<QString, QStringList> byLetter;
  for (const QString& text : texts) {
    const QKeySequence keys = QKeySequence::mnemonic(text);
    if (!keys.isEmpty()) {
      byLetter[keys.toString()] << text;
    }
  }
  QStringList shared;
  for (const QStringList& same : byLetter) {
    if (same.size() > 1) {
      shared << same.join(QStringLiteral(" / "));
    }
  }
  return shared;
}

QStringList sharedLettersOf(const QMenu& menu) {
  QStringList texts;
  QStringList shared;
  for (const QAction* action : menu.actions()) {
    texts << action->text();
    if (action->menu() != nullptr) {
      shared << sharedLettersOf(*action->menu());
    }
  }
  return shared << sharedLetters(texts);
}

/// What Tab goes through, from the first to the last.
std::vector<QWidget*> tabStops(QWidget& dialog) {
  std::vector<QWidget*> stops;
  QWidget* first = dialog.nextInFocusChain();
  for (QWidget* widget = first; widget != &dialog; widget = widget->nextInFocusChain()) {
    const bool takesTab = widget->focusPolicy() & Qt::TabFocus;
    if (takesTab && widget->isVisibleTo(&dialog) && widget->isEnabled()) {
      stops.push_back(widget);
    }
  }
  return stops;
}

int placeOf(const std::vector<QWidget*>& stops, const QString& name) {
  for (std::size_t i = 0; i < stops.size(); ++i) {
    const auto* button = qobject_cast<const QAbstractButton*>(stops[i]);
    QString text = button != nullptr ? button->text() : stops[i]->accessibleName();
    if (text.remove(QLatin1Char('&')) == name) {
      return static_cast<int>(i);
    }
  }
  return -1;
}

}  // namespace

/// Everything without a mouse: letters of menus and dialogs, Tab, Enter, Escape.
class KeyboardTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void initTestCase() { editor::applyTheme(editor::Theme::light()); }

  void menus_lettersAreUnique() {
    app::MainWindow window(quiet::setup());
    QStringList texts;
    QStringList shared;
    for (const QAction* action : window.menuBar()->actions()) {
      texts << action->text();
      shared << sharedLettersOf(*action->menu());
    }
    shared << sharedLetters(texts);
    QVERIFY2(shared.isEmpty(), qPrintable(shared.join(QStringLiteral("; "))));
  }

  void dialogs_lettersAreUniqueAndEscapeLeaves_data() {
    QTest::addColumn<int>("which");
    QTest::newRow("export") << 0;
    QTest::newRow("room") << 1;
    QTest::newRow("image") << 2;
    QTest::newRow("trees") << 3;
  }
  void dialogs_lettersAreUniqueAndEscapeLeaves() {
    QFETCH(int, which);
    const std::unique_ptr<QDialog> dialog = make(which);
    dialog->show();
    QStringList texts;
    int defaults = 0;
    for (const QAbstractButton* button : dialog->findChildren<QAbstractButton*>()) {
      const auto* push = qobject_cast<const QPushButton*>(button);
      defaults += push != nullptr && push->isDefault() ? 1 : 0;
      texts << (button->isVisibleTo(dialog.get()) ? button->text() : QString());
    }
    QCOMPARE(sharedLetters(texts), QStringList());
    QCOMPARE(defaults, 1);
    QTest::keyClick(dialog.get(), Qt::Key_Escape);
    QVERIFY(dialog->isHidden());
    QCOMPARE(dialog->result(), static_cast<int>(QDialog::Rejected));
  }

  void exportDialog_tab_goesDownThePage() {
    const std::unique_ptr<QDialog> dialog = make(0);
    dialog->show();
    const std::vector<QWidget*> stops = tabStops(*dialog);
    int before = -1;
    for (const char* name : {"Simulator", "Folder", "Choose…", "Format", "Missing trees",
                             "Files to write", "Remarks", "Copy", "Launch command", "Export"}) {
      const int place = placeOf(stops, QString::fromUtf8(name));
      QVERIFY2(place > before, name);
      before = place;
    }
  }

  void roomDialog_enter_creates() {
    app::RoomDialog dialog(editor::Theme::light());
    dialog.show();
    QTest::keyClicks(dialog.focusWidget(), QStringLiteral("7"));
    QTest::keyClick(dialog.focusWidget(), Qt::Key_Return);
    QCOMPARE(dialog.result(), static_cast<int>(QDialog::Accepted));
    QCOMPARE(dialog.size().width(), 7.0);
  }

 private:
  std::unique_ptr<QDialog> make(int which) {
    const editor::Theme theme = editor::Theme::light();
    switch (which) {
      case 0: {
        app::Bundle source;
        source.scenario = std::make_shared<const sim2d::Scenario>(
            sim2d::readScenario(quiet::demoPath().toStdString()).scenario);
        return std::make_unique<app::ExportDialog>(source, folder_.path(), theme);
      }
      case 1:
        return std::make_unique<app::RoomDialog>(theme);
      case 2:
        return std::make_unique<app::ImageMapDialog>(editor::emptyRoom(4.0, 3.0),
                                                     QImage(80, 60, QImage::Format_RGB32), theme);
      default:
        return std::make_unique<app::TreeChoiceDialog>(
            std::vector<editor::TreeConflict>{
                {{base::EntityKind::Human, 1}, "Ana", "a.xml", "a", "b"},
                {{base::EntityKind::Human, 2}, "Ben", "b.xml", "a", "b"}},
            theme);
    }
  }

  QTemporaryDir folder_;
};

QTEST_MAIN(KeyboardTest)
#include "tst_Keyboard.moc"
