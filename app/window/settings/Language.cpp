#include "app/window/settings/Language.h"

#include <algorithm>
#include <mutex>
#include <utility>

#include "sim2d/base/Find.h"

/// Outside of namespaces, also of unnamed ones, because Q_INIT_RESOURCE declares a function.
static void initializeTranslations() {
#ifdef HUNAV_TRANSLATIONS
  Q_INIT_RESOURCE(translations);
#endif
}

namespace app {

namespace {

const QLatin1String kTranslationFolder(":/translations/");
const QLatin1String kTranslationStem("hunavsim_");

/// Names of keys as in the texts of the window; Qt's own translations write some of them in full.
[[maybe_unused]] constexpr const char* kKeyNames[] = {QT_TRANSLATE_NOOP("QShortcut", "Ctrl"),
                                                      QT_TRANSLATE_NOOP("QShortcut", "Shift"),
                                                      QT_TRANSLATE_NOOP("QShortcut", "Alt")};

/// Contexts of panels and commands: preferred for a translation that several sources share.
constexpr const char* kNameContexts[] = {"app::WindowActions", "QObject", "editor::PlaybackActions",
                                         "editor::ScrubActions"};

/// Translates and remembers the sources of the translated texts, for `sourceText()`.
class ProgramTranslator : public QTranslator {
 public:
  QString translate(const char* context, const char* source, const char* disambiguation,
                    int n) const override {
    QString text = QTranslator::translate(context, source, disambiguation, n);
    if (!text.isEmpty()) {
      const std::lock_guard<std::mutex> lock(mutex_);  // texts of tasks
      sources_[text].insert(context, QString::fromUtf8(source));
    }
    return text;
  }
  QString sourceOf(const QString& text) const {
    const std::lock_guard<std::mutex> lock(mutex_);
    const QMap<QByteArray, QString> sources = sources_.value(text);
    for (const char* context : kNameContexts) {
      if (sources.contains(context)) {
        return sources.value(context);
      }
    }
    return sources.isEmpty() ? text : sources.begin().value();
  }

 private:
  mutable std::mutex mutex_;
  mutable QHash<QString, QMap<QByteArray, QString>> sources_;  // by translation and context
};

/// That of the existing `Translation`; null: the window is in English.
const ProgramTranslator* installedTranslator() {
  const QObjectList parts = QCoreApplication::instance()->children();
  for (const QObject* part : parts) {
    if (const auto* program = dynamic_cast<const ProgramTranslator*>(part)) {
      return program;
    }
  }
  return nullptr;
}

}  // namespace

std::vector<Language> languages() {
  initializeTranslations();
  std::vector<Language> all;
  const QString pattern = kTranslationStem + QStringLiteral("*.qm");
  for (const QString& file : QDir(kTranslationFolder).entryList({pattern})) {
    const QString code = QFileInfo(file).completeBaseName().mid(kTranslationStem.size());
    QString name = QLocale(code).nativeLanguageName();
    if (code.startsWith(QLatin1String("es"))) {
      name = QStringLiteral("Español");  // not that of a country
    }
    all.push_back({code, name.left(1).toUpper() + name.mid(1)});
  }
  std::sort(all.begin(), all.end(),
            [](const Language& a, const Language& b) { return a.name < b.name; });
  all.insert(all.begin(), {QStringLiteral("en"), QStringLiteral("English")});
  return all;
}

QString bestLanguage(const QStringList& locales) {
  const std::vector<Language> all = languages();
  for (const QString& wanted : locales) {
    const QLocale locale(wanted);
    const auto* found = base::findIf(all, [&locale](const Language& each) {
      const QLocale own(each.code);
      return own.language() == locale.language() && own.script() == locale.script();
    });
    if (found != nullptr) {
      return found->code;
    }
  }
  return all.front().code;
}

QString languageFor(const QString& stored) {
  const std::vector<Language> all = languages();
  for (const QString& code : {qEnvironmentVariable(kLanguageVariable), stored}) {
    if (base::findBy(all, &Language::code, code) != nullptr) {
      return code;
    }
  }
  return bestLanguage(QLocale::system().uiLanguages());
}

Translation::Translation(const QString& code) {
  initializeTranslations();
  const auto install = [this](std::unique_ptr<QTranslator> part, const QString& file,
                              const QString& folder) {
    if (part->load(file, folder)) {
      part->setParent(QCoreApplication::instance());
      QCoreApplication::installTranslator(part.get());
      parts_.push_back(std::move(part));
    }
  };
  if (code == QLatin1String("en")) {
    return;
  }
  install(std::make_unique<QTranslator>(), QStringLiteral("qtbase_") + code,
          QLibraryInfo::location(QLibraryInfo::TranslationsPath));
  install(std::make_unique<ProgramTranslator>(), kTranslationStem + code, kTranslationFolder);
}

Translation::~Translation() = default;

QLocale shownLanguage() {
  const ProgramTranslator* program = installedTranslator();
  return program == nullptr ? QLocale(QLocale::English) : QLocale(program->language());
}

QString sourceText(const QString& shown) {
  const ProgramTranslator* program = installedTranslator();
  return program == nullptr ? shown : program->sourceOf(shown);
}

}  // namespace app
