#pragma once

#include <clocale>
#include <cstdlib>

#include <QDir>
#include <QProcess>
#include <QStandardPaths>
#include <QString>

/// Switches the process to a locale that writes 1,5 for as long as it lives. Where the system has
/// none, one is made in the build folder; active() is false when that fails too.
class CommaLocale {
 public:
  CommaLocale() {
    if (std::setlocale(LC_ALL, kName) == nullptr && generate()) {
      std::setlocale(LC_ALL, kName);
    }
    active_ = *std::localeconv()->decimal_point == ',';
  }
  CommaLocale(const CommaLocale&) = delete;
  CommaLocale& operator=(const CommaLocale&) = delete;
  CommaLocale(CommaLocale&&) = delete;
  CommaLocale& operator=(CommaLocale&&) = delete;
  ~CommaLocale() { std::setlocale(LC_ALL, "C"); }

  bool active() const { return active_; }

 private:
  static constexpr const char* kName = "de_DE.UTF-8";

  /// Also leaves LOCPATH set, so that child processes started with LC_ALL find it.
  static bool generate() {
    const QString folder = QStringLiteral(TEST_OUTPUT_DIR "/locale");
    const QString locale = folder + QLatin1Char('/') + QLatin1String(kName);
    if (!QDir(locale).exists()) {
      const QString program = QStandardPaths::findExecutable(QStringLiteral("localedef"));
      if (program.isEmpty() || !QDir().mkpath(folder)) {
        return false;
      }
      QProcess::execute(
          program, {QStringLiteral("--no-archive"), QStringLiteral("-i"), QStringLiteral("de_DE"),
                    QStringLiteral("-f"), QStringLiteral("UTF-8"), locale});
    }
    return QDir(locale).exists() && setenv("LOCPATH", folder.toLocal8Bit().constData(), 1) == 0;
  }

  bool active_ = false;
};
