#include "app/window/help/Commands.h"
#include "app/window/settings/Language.h"
#include "app/window/settings/PreferencesDialog.h"
#include "editor/document/PersonTree.h"
#include "editor/look/AppStyle.h"
#include "editor/look/Fields.h"
#include "editor/panels/MetricsTable.h"
#include "tests/app/CutTexts.h"
#include "tests/app/QuietWindow.h"
#include "tests/support/CommaLocale.h"

using app::Translation;

namespace {

/// Marks every translated text except for the titles of panels, which are found by their names.
class MarkingTranslator : public QTranslator {
 public:
  explicit MarkingTranslator(QStringList titles) : titles_(std::move(titles)) {}
  static constexpr char16_t kMark = u'\u2021';
  QString translate(const char* /*context*/, const char* source, const char* /*disambiguation*/,
                    int /*n*/) const override {
    const QString text = QString::fromUtf8(source);
    return titles_.contains(text) ? text : text + QChar(kMark);
  }
  bool isEmpty() const override { return false; }
  const QStringList& titles() const { return titles_; }

 private:
  QStringList titles_;
};

}  // namespace

/// The window in each language of the program.
class LanguagesTest : public QObject {
  Q_OBJECT

 private:
  static QStringList codes() {
    QStringList all;
    for (const app::Language& each : app::languages()) {
      all << each.code;
    }
    return all;
  }
  /// The selections whose properties are shown: nothing, one of each kind, and two people.
  static std::vector<std::vector<editor::EntityId>> selectionsOf(
      const editor::ScenarioDocument& document) {
    std::vector<std::vector<editor::EntityId>> all = {{}};
    for (const base::EntityKind kind :
         {base::EntityKind::Human, base::EntityKind::Robot, base::EntityKind::Goal,
          base::EntityKind::Obstacle, base::EntityKind::Door, base::EntityKind::Area,
          base::EntityKind::Dock}) {
      const std::vector<editor::EntityId> ids = document.entities(kind);
      if (!ids.empty()) {
        all.push_back({ids.front()});
      }
      if (kind == base::EntityKind::Human && ids.size() > 1) {
        all.push_back({ids[0], ids[1]});
      }
    }
    return all;
  }
  /// Looks at a window or dialog; the text names what it shows.
  using Check = std::function<void(const QWidget&, const QString&)>;

  /// Opens each dialog of the window.
  static void inDialogs(app::MainWindow& window, const Check& check) {
    const app::WindowActions& actions = window.actions();
    for (QAction* action : {actions.newEmptyRoom, actions.exportTo, actions.history,
                            actions.savePicture, actions.assignGoals, actions.about}) {
      bool isSeen = false;
      quiet::answerDialog<QDialog>([&](QDialog& dialog) {
        check(dialog, action->text());
        isSeen = true;
        dialog.reject();
      });
      action->trigger();
      QTRY_VERIFY2(isSeen, qPrintable(action->text()));
    }
    actions.preferences->trigger();  // stays open beside the window
    auto* preferences = window.findChild<app::PreferencesDialog*>();
    for (int page = 0; page < preferences->pages().count(); ++page) {
      preferences->pages().setCurrentIndex(page);
      QCoreApplication::processEvents();
      check(*preferences, preferences->pages().tabText(page));
    }
    preferences->close();
  }
  /// Calls `check` with the window in all its states: start page, each selection, each panel, a
  /// run.
  static void inAllStates(app::MainWindow& window, const Check& check) {
    QCoreApplication::processEvents();
    check(window, QStringLiteral("start page"));
    QVERIFY(window.open(quiet::demoPath()));
    editor::ScenarioDocument& document = window.workspace().document();
    for (const std::vector<editor::EntityId>& selection : selectionsOf(document)) {
      document.setSelection(selection);
      QCoreApplication::processEvents();
      check(window,
            QStringLiteral("selection %1").arg(selection.empty() ? 0 : int(selection[0].kind)));
    }
    document.setSelection({document.entities(base::EntityKind::Human).front()});
    for (const QString& name : window.docks().names()) {
      window.docks().show({name});
      QCoreApplication::processEvents();
      check(window, name);
    }
    for (QAction* tool : window.workspace().tools().actions().actions()) {
      tool->trigger();
      QCoreApplication::processEvents();
      check(window, tool->text());
    }
    inDialogs(window, check);
    window.workspace().runner().stepOnce();
    QTRY_VERIFY(window.workspace().runner().newestFrame() != nullptr);
    for (const QString& name : window.docks().names()) {
      window.docks().show({name});
      QCoreApplication::processEvents();
      check(window, name + QStringLiteral(" in a run"));
    }
  }
  static void addProperties(const QObject& of, const std::vector<const char*>& names,
                            QStringList& to) {
    for (const char* name : names) {
      to << of.property(name).toString();
    }
  }
  /// The cells and headings of a list, as far as it is loaded.
  static void addCells(const QAbstractItemModel& model, const QModelIndex& parent,
                       QStringList& to) {
    for (int row = 0; row < model.rowCount(parent); ++row) {
      for (int column = 0; column < model.columnCount(parent); ++column) {
        const QModelIndex at = model.index(row, column, parent);
        to << at.data().toString() << at.data(Qt::ToolTipRole).toString();
        if (column == 0) {
          addCells(model, at, to);
        }
      }
    }
  }
  /// All texts of the widgets and commands of the window.
  static QStringList textsOf(const QWidget& window) {
    QStringList all;
    for (const QWidget* each : window.findChildren<QWidget*>()) {
      const bool isField = qobject_cast<const QLineEdit*>(each) != nullptr ||
                           qobject_cast<const QAbstractSpinBox*>(each) != nullptr ||
                           qobject_cast<const QPlainTextEdit*>(each) != nullptr;
      addProperties(*each,
                    {isField ? "toolTip" : "text", "toolTip", "accessibleName", "placeholderText",
                     "windowTitle", "title", "currentText", "statusTip", "suffix", "prefix",
                     "specialValueText"},
                    all);
    }
    for (const QAbstractItemView* each : window.findChildren<QAbstractItemView*>()) {
      if (each->model() != nullptr) {
        addCells(*each->model(), {}, all);
      }
    }
    for (const QAction* each : window.findChildren<QAction*>()) {
      addProperties(*each, {"text", "toolTip", "statusTip"}, all);
    }
    all.removeDuplicates();
    return all;
  }
  /// Whether a text without the mark should have it: a word with a capital letter, or several
  /// words, that are no names of the scenario, of files, nodes, planners or of parts of a library.
  static bool isWording(const QString& text, app::MainWindow& window) {
    static const QRegularExpression kWords(
        QStringLiteral("^[A-Z][a-z]{2,}$|[A-Za-z]{2,}[,:;]? [A-Za-z]{2,}"));
    if (text.contains(QChar(MarkingTranslator::kMark)) || !text.contains(kWords)) {
      return false;
    }
    const sim2d::Scenario& scenario = window.workspace().document().scenario();
    QStringList names = {QStringLiteral("HuNavSim"), QStringLiteral("hunavsim_desktop"),
                         QStringLiteral("Gazebo"), QStringLiteral("cafe, house, warehouse")};
    for (const sim2d::Human& human : scenario.humans) {
      names << QString::fromStdString(human.name);
    }
    for (const sim2d::Robot& robot : scenario.robots) {
      names << QString::fromStdString(robot.name);
    }
    for (const bt::NodeManifest& node : editor::treeCatalogue().all()) {
      names << QString::fromStdString(node.id);
    }
    return std::none_of(names.begin(), names.end(),
                        [&](const QString& name) { return text.contains(name); });
  }
  static QString menuName(const QWidget& menu) {
    const auto* of = qobject_cast<const QMenu*>(&menu);
    return of == nullptr ? QStringLiteral("menu bar") : of->title();
  }
  static QStringList commandIds(const app::MainWindow& window) {
    QStringList ids;
    for (const app::Command& command : app::commandsOf(*window.menuBar())) {
      ids << command.id;
    }
    return ids;
  }
  static void addLanguages() {
    QTest::addColumn<QString>("code");
    for (const QString& code : codes()) {
      QTest::newRow(qPrintable(code)) << code;
    }
  }

 private Q_SLOTS:
  void initTestCase() { editor::applyTheme(editor::Theme::light()); }

  void languages_areInTheProgram() {
    if (codes().size() == 1) {
      QSKIP("built without Qt Linguist's tools");
    }
    QCOMPARE(codes(), QStringList() << QStringLiteral("en") << QStringLiteral("es")
                                    << QStringLiteral("zh_CN"));
    QCOMPARE(app::languages()[1].name, QStringLiteral("Español"));
    QCOMPARE(app::languages()[2].name, QStringLiteral("简体中文"));
  }

  void bestLanguage_data() {
    QTest::addColumn<QStringList>("wanted");
    QTest::addColumn<QString>("best");
    const auto row = [](const char* wanted, const char* best) {
      QTest::newRow(*wanted == 0 ? "none" : wanted)
          << QString::fromUtf8(wanted).split(QLatin1Char(' ')) << QString::fromUtf8(best);
    };
    row("", "en");
    row("C", "en");
    row("es-MX en-US", "es");
    row("es", "es");
    row("zh-Hans-CN", "zh_CN");
    row("zh-CN", "zh_CN");
    row("zh-TW en", "en");  // other characters
    row("de-DE es-ES", "es");
    row("en-GB es-ES", "en");
  }
  void bestLanguage() {
    QFETCH(const QStringList, wanted);
    QFETCH(const QString, best);
    if (codes().size() == 1) {
      QSKIP("built without Qt Linguist's tools");
    }
    QCOMPARE(app::bestLanguage(wanted), best);
  }

  void languageFor_variableThenStoredThenSystem() {
    if (codes().size() == 1) {
      QSKIP("built without Qt Linguist's tools");
    }
    qputenv(app::kLanguageVariable, "zh_CN");
    QCOMPARE(app::languageFor(QStringLiteral("es")), QStringLiteral("zh_CN"));
    qputenv(app::kLanguageVariable, "xx");
    QCOMPARE(app::languageFor(QStringLiteral("es")), QStringLiteral("es"));
    qunsetenv(app::kLanguageVariable);
    QCOMPARE(app::languageFor(QStringLiteral("es")), QStringLiteral("es"));
    QVERIFY(codes().contains(app::languageFor(QStringLiteral("xx"))));
  }

  /// Names that are stored or typed do not depend on the language.
  void namesOfPanelsAndCommands_areThoseOfEnglish_data() { addLanguages(); }
  void namesOfPanelsAndCommands_areThoseOfEnglish() {
    QFETCH(const QString, code);
    std::unique_ptr<app::MainWindow> english = quiet::shownWindow();
    const QStringList panels = english->docks().names();
    const QStringList ids = commandIds(*english);
    quiet::leave(english);
    QVERIFY(panels.contains(QStringLiteral("scenario")));
    QVERIFY(ids.contains(QStringLiteral("File › Open")));
    QCOMPARE(QSet<QString>(ids.begin(), ids.end()).size(), ids.size());
    const Translation translation(code);
    std::unique_ptr<app::MainWindow> window = quiet::shownWindow();
    QCOMPARE(window->docks().names(), panels);
    QCOMPARE(commandIds(*window), ids);
    quiet::leave(window);
  }

  void letters_inEachMenu_areUnique_data() { addLanguages(); }
  void letters_inEachMenu_areUnique() {
    QFETCH(const QString, code);
    const Translation translation(code);
    std::unique_ptr<app::MainWindow> window = quiet::shownWindow();
    QVERIFY(window->open(quiet::demoPath()));
    QList<QWidget*> menus = {window->menuBar()};
    for (QMenu* menu : window->menuBar()->findChildren<QMenu*>()) {
      Q_EMIT menu->aboutToShow();
      menus << menu;
    }
    QStringList twice;
    for (const QWidget* menu : menus) {
      QStringList letters;
      for (const QAction* action : menu->actions()) {
        const QString letter = QKeySequence::mnemonic(action->text()).toString();
        if (!letter.isEmpty() && letters.contains(letter)) {
          twice << QStringLiteral("%1 › %2").arg(menuName(*menu), action->text());
        }
        letters << letter;
      }
    }
    QVERIFY2(twice.isEmpty(), qPrintable(twice.join(QLatin1Char('\n'))));
    quiet::leave(window);
  }

  /// In a locale that writes 1,5 and with a default locale that does.
  void numbers_haveADecimalPoint_data() { addLanguages(); }
  void numbers_haveADecimalPoint() {
    QFETCH(const QString, code);
    const CommaLocale commas;
    QLocale::setDefault(QLocale(QStringLiteral("es_ES")));
    const Translation translation(code);
    QCOMPARE(QLocale().name(), QStringLiteral("es_ES"));
    QTemporaryDir folder;
    const QString file = folder.filePath(QStringLiteral("demo.yaml"));
    std::unique_ptr<app::MainWindow> window = quiet::shownWindow();
    QVERIFY(window->open(quiet::copyOfDemo(file)));
    editor::ScenarioDocument& document = window->workspace().document();
    document.setSelection({document.entities(base::EntityKind::Human).front()});
    QCoreApplication::processEvents();
    auto* panel = window->docks().dock(QStringLiteral("properties"));
    int fields = 0;
    for (const auto* box : panel->findChildren<editor::NumberField*>()) {
      QVERIFY2(!box->text().contains(QLatin1Char(',')), qPrintable(box->text()));
      fields += box->text().contains(QLatin1Char('.')) ? 1 : 0;
    }
    QVERIFY(fields > 3);
    auto* speed = widgets::findIf<editor::NumberField>(*panel, [](const editor::NumberField* each) {
      return each->isVisible() && each->objectName() == QLatin1String("max_vel");
    });
    QVERIFY(speed != nullptr);
    speed->setFocus();
    speed->selectAll();
    QTest::keyClicks(speed, QStringLiteral("1.5"));
    QTest::keyClick(speed, Qt::Key_Return);
    QCOMPARE(document.scenario().humans.front().maxVel.value_or(0.0), 1.5);
    QVERIFY2(speed->text().startsWith(QStringLiteral("1.5")), qPrintable(speed->text()));
    window->actions().save->trigger();
    QTRY_VERIFY(document.undoStack().isClean());
    const base::Result<std::string> text = base::readTextFile(file.toStdString());
    QVERIFY(text);
    QVERIFY(text->find("max_vel: 1.5") != std::string::npos);
    QVERIFY(text->find("1,5") == std::string::npos);
    quiet::leave(window);
    QLocale::setDefault(QLocale::c());
  }

  void texts_ofTheWindow_areNotCut_data() { addLanguages(); }
  void texts_ofTheWindow_areNotCut() {
    QFETCH(const QString, code);
    const Translation translation(code);
    std::unique_ptr<app::MainWindow> window = quiet::shownWindow();
    QStringList found;
    inAllStates(*window, [&](const QWidget& shown, const QString& state) {
      for (const QString& text : cut::textsIn(shown)) {
        const QString line = text + QStringLiteral(" – ") + state;
        found << (found.filter(text).isEmpty() ? QStringList(line) : QStringList());
      }
    });
    QVERIFY2(found.isEmpty(), qPrintable(found.join(QLatin1Char('\n'))));
    quiet::leave(window);
  }

  void headings_ofTheMetrics_areNotCut_data() { addLanguages(); }
  void headings_ofTheMetrics_areNotCut() {
    QFETCH(const QString, code);
    const Translation translation(code);
    std::unique_ptr<app::MainWindow> window = quiet::shownWindow();
    QVERIFY(window->open(quiet::demoPath()));
    window->docks().show({QStringLiteral("metrics")});
    QCoreApplication::processEvents();
    const auto* table = window->findChild<editor::MetricsTable*>();
    QVERIFY(table != nullptr);
    const QHeaderView& header = *table->tree().header();
    for (int column = 0; column < header.count(); ++column) {
      const QString title = header.model()->headerData(column, Qt::Horizontal).toString();
      const int width = header.fontMetrics().horizontalAdvance(title);
      QVERIFY2(header.sectionSize(column) > width, qPrintable(title));
    }
    quiet::leave(window);
  }

  /// With a translator that marks all texts, each text that is shown has the mark: none is a
  /// literal.
  void texts_ofTheWindow_areTranslated() {
    QStringList titles;
    {
      std::unique_ptr<app::MainWindow> window = quiet::shownWindow();
      for (const QString& name : window->docks().names()) {
        titles << window->docks().dock(name)->windowTitle();
      }
    }
    const auto translator = std::make_unique<MarkingTranslator>(titles);
    QCoreApplication::installTranslator(translator.get());
    std::unique_ptr<app::MainWindow> window = quiet::shownWindow();
    QStringList literals;
    inAllStates(*window, [&](const QWidget& shown, const QString& state) {
      for (const QString& text : textsOf(shown)) {
        if (isWording(text, *window) && !titles.contains(text) &&
            !literals.join(QLatin1Char('\n')).contains(text)) {
          literals << text + QStringLiteral(" – ") + state;
        }
      }
    });
    quiet::leave(window);
    QVERIFY2(literals.isEmpty(), qPrintable(literals.join(QLatin1Char('\n'))));
  }
};

QTEST_MAIN(LanguagesTest)
#include "tst_Languages.moc"
