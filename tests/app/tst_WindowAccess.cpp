#include <set>

#include "app/window/help/CommandPalette.h"
#include "app/window/settings/PreferencesDialog.h"
#include "editor/look/AppStyle.h"
#include "tests/app/QuietWindow.h"

namespace {

bool needsName(QAccessible::Role role) {
  switch (role) {
    case QAccessible::PushButton:
    case QAccessible::ButtonMenu:
    case QAccessible::ButtonDropDown:
    case QAccessible::CheckBox:
    case QAccessible::RadioButton:
    case QAccessible::ComboBox:
    case QAccessible::EditableText:
    case QAccessible::SpinBox:
    case QAccessible::Slider:
    case QAccessible::List:
    case QAccessible::Tree:
    case QAccessible::Table:
    case QAccessible::MenuItem:
    case QAccessible::PageTab:
    case QAccessible::Dialog:
      return true;
    default:
      return false;
  }
}

/// Parts of a combo box, a spin box or a scroll bar belong to it.
bool isPart(const QAccessibleInterface& item) {
  for (QAccessibleInterface* parent = item.parent(); parent != nullptr; parent = parent->parent()) {
    const QAccessible::Role role = parent->role();
    if (role == QAccessible::ComboBox || role == QAccessible::SpinBox ||
        role == QAccessible::ScrollBar) {
      return true;
    }
  }
  return false;
}

QString placeOf(const QAccessibleInterface& item) {
  QStringList names;
  QObject* object = item.object();
  names << QStringLiteral("role %1").arg(static_cast<int>(item.role()));
  for (; object != nullptr; object = object->parent()) {
    names << QLatin1String(object->metaObject()->className()) + QLatin1Char('#') +
                 object->objectName();
  }
  return names.join(QStringLiteral(" < "));
}

/// Visible controls without a name, in the tree that screen readers see.
void collectUnnamed(QAccessibleInterface* item, QStringList& unnamed, int& controls) {
  if (item == nullptr || !item->isValid() || item->state().invisible) {
    return;
  }
  auto* widget = qobject_cast<QWidget*>(item->object());
  const bool isSeparator = item->role() == QAccessible::Separator;
  if (needsName(item->role()) && !isPart(*item) && !isSeparator) {
    ++controls;
    if (item->text(QAccessible::Name).trimmed().isEmpty()) {
      unnamed << placeOf(*item);
    }
  }
  const bool isItemView = qobject_cast<QAbstractItemView*>(widget) != nullptr;
  for (int i = 0; !isItemView && i < item->childCount(); ++i) {
    collectUnnamed(item->child(i), unnamed, controls);
  }
}

}  // namespace

/// Screen readers and the keyboard: every control has a name, and Tab reaches every field.
class WindowAccessTest : public QObject, protected quiet::InFolder {
  Q_OBJECT

 private:
  static void verifyNamed(QWidget& root, int least) {
    QCoreApplication::processEvents();
    QStringList unnamed;
    int controls = 0;
    collectUnnamed(QAccessible::queryAccessibleInterface(&root), unnamed, controls);
    QCOMPARE(unnamed.join(QLatin1Char('\n')), QString());
    QVERIFY2(controls >= least, qPrintable(QString::number(controls)));
  }
  editor::EntityId first(base::EntityKind kind) {
    const std::vector<editor::EntityId> all = document().entities(kind);
    return all.empty() ? editor::EntityId() : all.front();
  }

  /// How many pixels of the widget with the focus change with it, to a visible colour.
  static int markedPixels(QWidget& control, const editor::Theme& theme) {
    QWidget& top = *control.window();
    const QRect place =
        QRect(control.mapTo(&top, QPoint()), control.size()).adjusted(-3, -3, 3, 3) & top.rect();
    const QImage with = top.grab(place).toImage();
    control.clearFocus();
    const QImage without = top.grab(place).toImage();
    control.setFocus(Qt::TabFocusReason);
    int visible = 0;
    for (int k = 0; k < with.width() * with.height(); ++k) {
      const QPoint at(k % with.width(), k / with.width());
      const QColor now = with.pixelColor(at);
      visible += now != without.pixelColor(at) &&
                 editor::contrastRatio(now, theme.color(editor::Role::Window)) >= 3.0;
    }
    return visible;
  }
  /// Presses Tab until the first widget has the focus again; each must show that it has it.
  static void walkTabStops(QWidget& top, const editor::Theme& theme, int least) {
    top.activateWindow();
    QVERIFY(QTest::qWaitForWindowActive(&top));
    QTest::qWait(100);  // panels are placed
    QStringList unmarked;
    std::set<const QWidget*> seen;
    if (!top.isAncestorOf(QApplication::focusWidget())) {
      top.setFocus();
    }
    for (int i = 0; i < 400; ++i) {
      QWidget* const before = QApplication::focusWidget();
      QTest::keyClick(before != nullptr ? before : &top, Qt::Key_Tab);
      QWidget* const stop = QApplication::focusWidget();
      QVERIFY(stop != nullptr && stop != before);
      if (!seen.insert(stop).second) {
        break;
      }
      if (markedPixels(*stop, theme) < 20) {
        unmarked << QLatin1String(stop->metaObject()->className()) + QLatin1Char(' ') +
                        stop->objectName() + QLatin1Char(' ') + stop->accessibleName() +
                        QLatin1String(" < ") +
                        QLatin1String(stop->parentWidget()->metaObject()->className());
      }
    }
    QCOMPARE(unmarked.join(QLatin1Char('\n')), QString());
    QVERIFY2(static_cast<int>(seen.size()) >= least, qPrintable(QString::number(seen.size())));
  }

 private Q_SLOTS:
  void initTestCase() {
    editor::applyTheme(editor::Theme::light());
    QAccessible::setActive(true);
  }
  void init() { begin(); }
  void cleanup() { end(); }

  void startPage_everyControl_hasAName() { verifyNamed(*window_, 15); }

  void panels_everyControl_hasAName_data() {
    QTest::addColumn<int>("kind");
    QTest::newRow("nothing") << -1;
    QTest::newRow("person") << static_cast<int>(base::EntityKind::Human);
    QTest::newRow("robot") << static_cast<int>(base::EntityKind::Robot);
    QTest::newRow("goal") << static_cast<int>(base::EntityKind::Goal);
    QTest::newRow("obstacle") << static_cast<int>(base::EntityKind::Obstacle);
  }
  void panels_everyControl_hasAName() {
    QFETCH(int, kind);
    QVERIFY(window_->open(quiet::demoPath()));
    if (kind >= 0) {
      document().setSelection({first(static_cast<base::EntityKind>(kind))});
    }
    for (const QString& name : window_->docks().names()) {
      window_->docks().show({name, QStringLiteral("properties")});
      verifyNamed(*window_, 40);
    }
  }

  void tools_theirOptions_haveNames() {
    QVERIFY(window_->open(quiet::demoPath()));
    for (const auto& tool : window_->workspace().tools().entries()) {
      tool.action->trigger();
      verifyNamed(*window_, 40);
    }
  }

  void windows_everyControl_hasAName() {
    QVERIFY(window_->open(quiet::demoPath()));
    window_->actions().preferences->trigger();
    auto& preferences = *window_->findChild<app::PreferencesDialog*>();
    for (int i = 0; i < preferences.pages().count(); ++i) {
      preferences.pages().setCurrentIndex(i);
      verifyNamed(preferences, 5);
    }
    preferences.close();
    window_->help().palette().open();
    verifyNamed(window_->help().palette(), 2);
    window_->help().palette().hide();
    window_->actions().tour->trigger();
    verifyNamed(window_->tour(), 1);
    app::RoomDialog room(editor::Theme::light());
    room.show();
    verifyNamed(room, 5);
  }

  /// Fields of the properties, the start page and the preferences can be reached with Tab.
  void fields_visible_takeTheKeyboardFocus() {
    QVERIFY(window_->open(quiet::demoPath()));
    document().setSelection({first(base::EntityKind::Human)});
    window_->actions().preferences->trigger();
    QCoreApplication::processEvents();
    QStringList unreachable;
    for (QWidget* top : {static_cast<QWidget*>(window_.get()),
                         static_cast<QWidget*>(window_->findChild<app::PreferencesDialog*>())}) {
      for (const QWidget* field : top->findChildren<QWidget*>()) {
        const bool isField = qobject_cast<const QLineEdit*>(field) != nullptr ||
                             qobject_cast<const QAbstractSpinBox*>(field) != nullptr ||
                             qobject_cast<const QComboBox*>(field) != nullptr ||
                             qobject_cast<const QCheckBox*>(field) != nullptr;
        const bool isPartOfOne =
            qobject_cast<const QAbstractSpinBox*>(field->parentWidget()) != nullptr ||
            qobject_cast<const QComboBox*>(field->parentWidget()) != nullptr;
        if (isField && !isPartOfOne && field->isVisible() && field->isEnabled() &&
            (field->focusPolicy() & Qt::TabFocus) == 0) {
          unreachable << field->accessibleName() + QLatin1Char(' ') +
                             QLatin1String(field->metaObject()->className());
        }
      }
    }
    QCOMPARE(unreachable.join(QLatin1Char('\n')), QString());
  }

  /// The focus of the keyboard changes what is drawn, in both themes.
  void focus_ofAControl_isVisible_data() {
    QTest::addColumn<bool>("isDark");
    QTest::newRow("light") << false;
    QTest::newRow("dark") << true;
  }
  void focus_ofAControl_isVisible() {
    QFETCH(bool, isDark);
    const editor::Theme theme(isDark);
    editor::applyTheme(theme);
    QWidget form;
    auto* rows = new QVBoxLayout(&form);
    const std::vector<QWidget*> controls = {new QPushButton(QStringLiteral("Button")),
                                            new QCheckBox(QStringLiteral("Check")),
                                            new QRadioButton(QStringLiteral("Radio")),
                                            new QComboBox,
                                            new QLineEdit,
                                            new QSpinBox,
                                            new QSlider(Qt::Horizontal)};
    for (QWidget* control : controls) {
      rows->addWidget(control);
    }
    form.show();
    QVERIFY(QTest::qWaitForWindowActive(&form));
    for (std::size_t i = 0; i < controls.size(); ++i) {
      QWidget* const control = controls[i];
      QWidget* const before = controls[(i + controls.size() - 1) % controls.size()];
      const QRect place = control->geometry().adjusted(-3, -3, 3, 3);
      before->setFocus();
      const QImage without = form.grab(place).toImage();
      QTest::keyClick(before, Qt::Key_Tab);  // the ring is shown while the keyboard is used
      QVERIFY2(control->hasFocus(), control->metaObject()->className());
      const QImage with = form.grab(place).toImage();
      int visible = 0;
      for (int k = 0; k < with.width() * with.height(); ++k) {
        const QPoint at(k % with.width(), k / with.width());
        const QColor now = with.pixelColor(at);
        const bool isNew = now != without.pixelColor(at);
        visible += isNew && editor::contrastRatio(now, theme.color(editor::Role::Window)) >= 3.0;
      }
      QVERIFY2(visible >= 20, control->metaObject()->className());
    }
    editor::applyTheme(editor::Theme::light());
  }

  /// Every stop of Tab in the window with its panels, on the start page and in dialogs.
  void tabStops_all_showTheFocus_data() { focus_ofAControl_isVisible_data(); }
  void tabStops_all_showTheFocus() {
    QFETCH(bool, isDark);
    const editor::Theme theme(isDark);
    editor::applyTheme(theme);
    walkTabStops(*window_, theme, 5);
    QVERIFY(window_->open(quiet::demoPath()));
    document().setSelection({first(base::EntityKind::Human)});
    for (const QString& name : window_->docks().names()) {
      window_->docks().show({name, QStringLiteral("properties")});
    }
    walkTabStops(*window_, theme, 40);
    window_->actions().preferences->trigger();
    auto& preferences = *window_->findChild<app::PreferencesDialog*>();
    for (int i = 0; i < preferences.pages().count(); ++i) {
      preferences.pages().setCurrentIndex(i);
      walkTabStops(preferences, theme, 3);
    }
    preferences.close();
    editor::applyTheme(editor::Theme::light());
  }

  /// Texts, trees and the map have no mark of their own; a click needs none.
  void focus_byMouse_hasNoFrame() {
    QVERIFY(window_->open(quiet::demoPath()));
    window_->activateWindow();
    QVERIFY(QTest::qWaitForWindowActive(window_.get()));
    editor::MapView& view = window_->workspace().view();
    const auto isFramed = [this] {
      const auto* frame = window_->findChild<QFocusFrame*>();
      return frame != nullptr && frame->isVisible();
    };
    QTest::keyClick(&view, Qt::Key_Tab);
    QTest::keyClick(QApplication::focusWidget(), Qt::Key_Backtab);
    QVERIFY(view.hasFocus() && isFramed());
    QTest::mouseClick(view.viewport(), Qt::LeftButton, {}, QPoint(3, 3));
    QVERIFY(view.hasFocus() && !isFramed());
  }

  /// What the desktop's accessibility service sees, read by another program.
  void atSpi_dumpOfTheProgram_hasNoUnnamedControl() {
    const QString program = QStringLiteral(SOURCE_DIR "/tests/app/atspi_dump.sh");
    const QString window = QCoreApplication::applicationDirPath() + QStringLiteral("/../hunavsim");
    QProcess process;
    process.start(QStringLiteral("bash"), {program, window, quiet::demoPath()});
    QVERIFY(process.waitForFinished(120000));
    const QString out =
        QString::fromUtf8(process.readAllStandardOutput() + process.readAllStandardError());
    if (process.exitCode() == 77) {
      QSKIP(qPrintable(out.trimmed()));
    }
    QVERIFY2(process.exitCode() == 0, qPrintable(out));
  }

  void file_openInTwoWindows_bothSaySoUntilOneCloses() {
    const QString file = copyOfDemo();
    app::WindowSetup setup = quiet::setup();
    setup.openFilesFolder = at("open-files");
    quiet::leave(window_);
    window_ = quiet::shownWindow(setup);
    QVERIFY(window_->open(file));
    const QString id = QStringLiteral("open-elsewhere");
    QVERIFY(!window_->notices().has(id));
    std::unique_ptr<app::MainWindow> second = quiet::shownWindow(setup);
    QVERIFY(QFile::link(file, at("link.yaml")));
    QVERIFY(second->open(at("link.yaml")));  // another name of the same file
    QVERIFY(second->notices().has(id));
    QTRY_VERIFY(window_->notices().has(id));
    quiet::leave(second);
    QTRY_VERIFY(!window_->notices().has(id));
  }

  void file_openInAWindowThatCrashed_saysNothing() {
    const QString file = copyOfDemo();
    QDir(folder_->path()).mkdir(QStringLiteral("open-files"));
    const QByteArray key =
        QCryptographicHash::hash(file.toUtf8(), QCryptographicHash::Sha1).toHex();
    QFile lock(at("open-files/") + QString::fromLatin1(key) + QStringLiteral("-dead.open"));
    QVERIFY(lock.open(QIODevice::WriteOnly));
    lock.write("999999999\nhunavsim\n" + QSysInfo::machineHostName().toUtf8() + "\n");
    lock.close();
    app::WindowSetup setup = quiet::setup();
    setup.openFilesFolder = at("open-files");
    quiet::leave(window_);
    window_ = quiet::shownWindow(setup);
    QVERIFY(window_->open(file));
    QVERIFY(!window_->notices().has(QStringLiteral("open-elsewhere")));
  }
};

QTEST_MAIN(WindowAccessTest)
#include "tst_WindowAccess.moc"
