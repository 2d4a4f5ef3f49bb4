#pragma once

#include <string>

#include <QFileInfo>
#include <QString>

/// Folder of files of other programs: HUNAV_INTEROP_DIR, else ../shared/interop beside the clone.
inline QString interopFolder() {
  const QByteArray given = qgetenv("HUNAV_INTEROP_DIR");
  return given.isEmpty() ? QStringLiteral(SOURCE_DIR "/../shared/interop")
                         : QString::fromLocal8Bit(given);
}

/// A file of that folder ("hunavsim2/isaac/maps/…"), or of those that come with the tests: the
/// folders "own" of tests/data/interop, in the same layout. Empty: not there.
inline QString interopFile(const QString& name) {
  const bool isOurs = name.contains(QStringLiteral("/own/"));
  const QString path = (isOurs ? QStringLiteral(TEST_DATA_DIR "/interop") : interopFolder()) +
                       QLatin1Char('/') + name;
  return QFileInfo::exists(path) ? path : QString();
}
