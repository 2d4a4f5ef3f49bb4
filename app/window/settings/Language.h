#pragma once

#include <memory>
#include <vector>

#include <QtWidgets>

/// The language of the window. Its texts are written in English in the sources; translations made
/// with Qt Linguist (resources/translations) are embedded in the program.
namespace app {

/// The stored choice: the code of a language; empty: that of the system.
constexpr const char* kLanguageKey = "window/language";
/// An environment variable with the code of a language, which has precedence over the stored
/// choice.
constexpr const char* kLanguageVariable = "HUNAV_LANGUAGE";

struct Language {
  QString code;  // "en", "es" or "zh_CN"
  QString name;  // in the language itself
};

/// English, then the languages whose translations are in the program, by their names.
std::vector<Language> languages();

/// The code of the best language in `languages()` for a user who prefers these locales, most
/// preferred first ("es-MX", "zh-Hans-CN", "en"). Without a match: "en".
QString bestLanguage(const QStringList& locales);

/// The code of the language for a new window: that of the environment variable, else the stored
/// choice, else the best for the system.
QString languageFor(const QString& stored);

/// Translations of the program's and of Qt's own texts, installed in the application while this
/// object exists. Numbers keep their decimal point: the default locale is not changed.
class Translation {
 public:
  /// `code`: of one of `languages()`. English has no translations.
  explicit Translation(const QString& code);
  ~Translation();
  Q_DISABLE_COPY_MOVE(Translation)

 private:
  std::vector<std::unique_ptr<QTranslator>> parts_;
};

/// The locale of the shown language, for names of days and months only.
QLocale shownLanguage();

/// The English text in the sources of a text that the window shows; the text itself if it is not
/// translated. For names of panels and commands, which are stored or typed and must not depend on
/// the language.
QString sourceText(const QString& shown);

}  // namespace app
