#pragma once

#include <cmath>
#include <map>
#include <optional>
#include <vector>

#include <QByteArray>
#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QJsonDocument>
#include <QJsonObject>
#include <QProcess>
#include <QString>
#include <QStringList>
#include <QTemporaryDir>

/// The program from outside, and its files read by code of the tests' own (none of the program's),
/// so that numbers can be recomputed independently.
namespace outside {

struct Finished {
  int exitCode = -1;
  QString out, err;
};

/// Waits for its end, which may have been already.
inline Finished finishedOf(QProcess& process, int milliseconds = 55000) {
  process.waitForFinished(milliseconds);
  Finished finished;
  if (process.state() == QProcess::NotRunning && process.exitStatus() == QProcess::NormalExit) {
    finished.exitCode = process.exitCode();
  }
  finished.out = QString::fromUtf8(process.readAllStandardOutput());
  finished.err = QString::fromUtf8(process.readAllStandardError());
  return finished;
}

inline Finished runProgram(const QStringList& words, const QString& folder = {}) {
  QProcess process;
  if (!folder.isEmpty()) {
    process.setWorkingDirectory(folder);
  }
  process.start(QStringLiteral(HUNAVSIM_PROGRAM), words);
  return finishedOf(process);
}

/// The words of a command line; each word % is replaced by the next value.
inline QStringList list(const char* line, const std::vector<QString>& values = {}) {
  QStringList words = QString::fromUtf8(line).split(QLatin1Char(' '));
  std::size_t next = 0;
  for (QString& word : words) {
    word = word == QLatin1String("%") ? values.at(next++) : word;
  }
  return words;
}

inline Finished runProgram(const char* line, const std::vector<QString>& values = {}) {
  return runProgram(list(line, values));
}

/// Empty if the program ended with this code and message, else what it did.
inline QString unexpected(const Finished& finished, int exitCode, const QString& message) {
  return finished.exitCode == exitCode && finished.err.contains(message)
             ? QString()
             : QString::number(finished.exitCode) + QLatin1String(": ") + finished.err;
}

inline QString unexpected(const Finished& finished, int exitCode, const char* message) {
  return unexpected(finished, exitCode, QString::fromUtf8(message));
}

/// Empty if the program succeeds with these words, else its exit code and messages.
inline QString failureOf(const QStringList& words) {
  const Finished finished = runProgram(words);
  return finished.exitCode == 0
             ? QString()
             : QString::number(finished.exitCode) + QLatin1String(": ") + finished.err;
}
inline QString failureOf(const char* line, const std::vector<QString>& values = {}) {
  return failureOf(list(line, values));
}

inline QByteArray bytesOf(const QString& path) {
  QFile file(path);
  return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

/// Folders on the way are made.
inline void writeText(const QString& path, const QByteArray& text) {
  QDir().mkpath(QFileInfo(path).absolutePath());
  QFile file(path);
  if (!file.open(QIODevice::WriteOnly) || file.write(text) != text.size()) {
    qFatal("cannot write %s", qPrintable(path));
  }
}

inline QString text(const char* words) {
  return QString::fromUtf8(words);
}

/// Tests that write into one folder.
class InFolder {
 protected:
  QString path(const QString& name) const { return folder_.filePath(name); }
  QString path(const char* name) const { return path(text(name)); }

  QTemporaryDir folder_;
};

/// Files and folders, hidden ones too.
inline void copyFolder(const QString& from, const QString& to) {
  QDir().mkpath(to);
  for (const QFileInfo& each : QDir(from).entryInfoList(QDir::AllEntries | QDir::NoDotAndDotDot |
                                                        QDir::Hidden | QDir::System)) {
    const QString place = to + QLatin1Char('/') + each.fileName();
    if (each.isDir()) {
      copyFolder(each.filePath(), place);
    } else {
      QFile::copy(each.filePath(), place);
    }
  }
}

/// A file of the original, or a recording; it need not be there.
inline QString interop(const QString& file) {
  const QString given = qEnvironmentVariable("HUNAV_INTEROP_DIR");
  const QString folder = given.isEmpty() ? text(SOURCE_DIR "/../shared/interop") : given;
  return QDir(folder).absoluteFilePath(file);
}

/// The object that a JSON file holds; empty when there is none.
inline QJsonObject readJson(const QString& path) {
  return QJsonDocument::fromJson(bytesOf(path)).object();
}

/// "metrics" of metrics.json in the folder of a run.
inline QJsonObject metricsOf(const QString& folder) {
  return readJson(folder + text("/metrics.json")).value(text("metrics")).toObject();
}

/// -1e300 when there is none.
inline double valueOf(const QJsonObject& metrics, const QString& key) {
  return metrics.value(key).toObject().value(text("value")).toDouble(-1e300);
}

/// Fields of a line; commas between quotation marks do not separate.
inline QStringList csvFields(const QString& line) {
  QStringList fields{QString()};
  bool isQuoted = false;
  for (const QChar c : line) {
    if (c == QLatin1Char('"')) {
      isQuoted = !isQuoted;
    } else if (c == QLatin1Char(',') && !isQuoted) {
      fields.append(QString());
    } else {
      fields.last().append(c);
    }
  }
  return fields;
}

/// Rows of a CSV file without quoted line breaks, as column -> text.
inline std::vector<std::map<QString, QString>> readCsv(const QString& path) {
  std::vector<std::map<QString, QString>> rows;
  const QStringList lines = QString::fromUtf8(bytesOf(path)).split(QLatin1Char('\n'));
  const QStringList header = lines.value(0).split(QLatin1Char(','));
  for (int k = 1; k < lines.size(); ++k) {
    if (lines[k].isEmpty()) {
      continue;
    }
    const QStringList fields = csvFields(lines[k]);
    std::map<QString, QString> row;
    for (int column = 0; column < header.size(); ++column) {
      row[header[column]] = fields.value(column);
    }
    rows.push_back(row);
  }
  return rows;
}

/// Processes that this one has started.
inline std::vector<qint64> childrenOf(qint64 process) {
  std::vector<qint64> found;
  const QByteArray list = bytesOf(text("/proc/%1/task/%1/children").arg(process));
  for (const QByteArray& word : list.simplified().split(' ')) {
    if (!word.isEmpty()) {
      found.push_back(word.toLongLong());
    }
  }
  return found;
}

inline bool isAlive(qint64 process) {  // one that waits for its parent to look is not
  const QByteArray state = bytesOf(text("/proc/%1/stat").arg(process));
  return !state.isEmpty() && !state.contains(") Z ");
}
inline bool isGone(const QByteArray& id) {
  return !isAlive(id.trimmed().toLongLong());
}

struct Body {
  int id = 0;
  double x = 0, y = 0, heading = 0, vx = 0, vy = 0, omega = 0;
  int group = -1;
};
struct Sample {
  double time = 0;
  std::vector<Body> people;
  std::optional<Body> robot;
};

inline std::vector<Sample> readTrajectory(const QString& path) {
  std::vector<Sample> samples;
  QString last;
  for (const auto& row : readCsv(path)) {
    const auto number = [&row](const char* column) {
      return row.at(QString::fromLatin1(column)).toDouble();
    };
    if (row.at(QStringLiteral("step")) != last) {
      last = row.at(QStringLiteral("step"));
      samples.emplace_back();
      samples.back().time = number("time");
    }
    const Body body{static_cast<int>(number("id")),
                    number("x"),
                    number("y"),
                    number("heading"),
                    number("vx"),
                    number("vy"),
                    number("omega"),
                    static_cast<int>(number("group"))};
    if (row.at(QStringLiteral("kind")) == QLatin1String("robot")) {
      if (!samples.back().robot) {
        samples.back().robot = body;
      }
    } else {
      samples.back().people.push_back(body);
    }
  }
  return samples;
}

inline double turn(double angle) {
  return std::remainder(angle, 2.0 * std::acos(-1.0));
}

}  // namespace outside
