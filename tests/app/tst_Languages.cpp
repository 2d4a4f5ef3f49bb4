#include "app/window/help/Commands.h"
#include "app/window/settings/Language.h"
#include "editor/look/AppStyle.h"
#include "tests/app/QuietWindow.h"

using app::Translation;

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
};

QTEST_MAIN(LanguagesTest)
#include "tst_Languages.moc"
