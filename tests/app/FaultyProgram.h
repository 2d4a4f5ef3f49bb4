#pragma once

#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <fcntl.h>
#include <map>
#include <memory>
#include <new>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include <QCoreApplication>
#include <QDirIterator>
#include <QJsonArray>
#include <QRegularExpression>
#include <QTemporaryDir>

#include "tests/app/RunFiles.h"
#include "tests/support/FaultState.h"

/// Programs whose calls to the system fail at a place of choice (tests/support/FaultShim.cpp).
namespace faults {

using outside::text;

/// The same names as in the environment variable HUNAV_FAULTS.
inline QString nameOf(Kind kind) {
  constexpr const char* kNames[] = {"count",    "kill",        "kill-all",  "plug",
                                    "no-space", "write-error", "read-error"};
  return text(kNames[static_cast<int>(kind)]);
}

/// What the shim shares with us, in a file that is gone with this.
class SharedState {
 public:
  SharedState(const QString& path, Kind kind, int at, const QString& folder) {
    const int file = ::open(QFile::encodeName(path).constData(), O_RDWR | O_CREAT | O_TRUNC, 0600);
    void* const place =
        ::ftruncate(file, sizeof(State)) == 0
            ? ::mmap(nullptr, sizeof(State), PROT_READ | PROT_WRITE, MAP_SHARED, file, 0)
            : MAP_FAILED;
    ::close(file);
    if (place == MAP_FAILED) {
      qFatal("no shared memory for a test");
    }
    state_ = new (place) State;  // NOLINT: lies in the file
    state_->kind = kind;
    state_->at = at;
    const QByteArray watched = QFile::encodeName(folder);
    std::memcpy(
        state_->folder, watched.constData(),
        std::min<std::size_t>(static_cast<std::size_t>(watched.size()), sizeof state_->folder - 1));
  }
  ~SharedState() { ::munmap(state_, sizeof(State)); }
  Q_DISABLE_COPY_MOVE(SharedState)
  State* operator->() const { return state_; }

 private:
  State* state_;
};

/// A process with a session of its own, so that none that it leaves behind is overlooked.
class SessionProcess : public QProcess {
 protected:
  void setupChildProcess() override { ::setsid(); }
};

/// Processes of a session that live.
inline QStringList membersOf(qint64 session) {
  QStringList found;
  for (const QString& name : QDir(text("/proc")).entryList(QDir::Dirs | QDir::NoDotAndDotDot)) {
    const QByteArray stat = outside::bytesOf(text("/proc/") + name + text("/stat"));
    const QList<QByteArray> words = stat.mid(stat.lastIndexOf(')') + 2).split(' ');
    if (words.size() > 3 && words[0] != "Z" && words[3].toLongLong() == session) {
      found << name;
    }
  }
  return found;
}

struct Outcome {
  bool isKilled = false;
  int exitCode = -1;
  QString err;
  int changes = 0, reads = 0;  // calls that were seen
  QString struck;              // the call that failed
  QStringList left;            // processes that still live
};

/// What was appended to files and is not on the disk when the power goes is not there afterwards.
inline void loseUnsynced(const State& state, const QString& folder) {
  const int count = std::min(state.unsyncedCount.load(), 8192);
  QDirIterator files(folder, QDir::Files | QDir::Hidden | QDir::System,
                     QDirIterator::Subdirectories);
  while (files.hasNext()) {
    const QByteArray path = QFile::encodeName(files.next());
    struct stat about = {};
    const bool isThere = ::lstat(path.constData(), &about) == 0;
    const Inode* const written =
        std::find_if(state.unsynced, state.unsynced + count, [&about](const Inode& inode) {
          return inode.number == about.st_ino && inode.device == about.st_dev;
        });
    if (isThere && written != state.unsynced + count && written->syncedSize < about.st_size &&
        ::truncate(path.constData(), written->syncedSize) != 0) {
      qFatal("cannot cut %s", path.constData());
    }
  }
}

/// `program` with the words, watched in `folder`; `scratch` takes what the shim shares.
inline Outcome runFaulty(const QString& program, const QStringList& words, const QString& folder,
                         const QString& scratch, Kind kind, int at) {
  const QString statePath = scratch + text("/state");
  const SharedState state(statePath, kind, at, folder);
  SessionProcess process;
  QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
  environment.insert(text("LD_PRELOAD"), text(TEST_OUTPUT_DIR "/faults/shim.so"));
  environment.insert(text(kStateVariable), statePath);
  if (kind == Kind::Count) {
    environment.insert(text(kLogVariable), scratch + text("/log"));
  }
  process.setProcessEnvironment(environment);
  process.start(program, words);
  process.waitForStarted();
  const qint64 session = process.processId();
  Outcome outcome;
  if (!process.waitForFinished(50000)) {
    outcome.left << text("it hangs");
    process.kill();
    process.waitForFinished();
  }
  for (int tries = 0; tries < 200 && !membersOf(session).empty(); ++tries) {
    ::usleep(10000);  // the kernel ends workers whose parent is gone
  }
  outcome.left << membersOf(session);
  outcome.isKilled = process.exitStatus() == QProcess::CrashExit;
  outcome.exitCode = outcome.isKilled ? -1 : process.exitCode();
  outcome.err = QString::fromUtf8(process.readAllStandardError());
  outcome.changes = state->changes;
  outcome.reads = state->reads;
  outcome.struck = QString::fromUtf8(state->struck);
  if (kind == Kind::Plug && outcome.isKilled) {
    loseUnsynced(*state.operator->(), folder);
  }
  return outcome;
}

/// Numbers of the calls that the log of an undisturbed run has of this kind, as "read PATH".
/// What fails alone is counted among the calls of its file, unless that is called after the
/// process: several processes make the others in another order each time.
struct PlacedCall {
  QString file;
  int number = 0;
};
inline QList<PlacedCall> callsLike(const QString& scratch, Kind kind,
                                   const QRegularExpression& call, const QString& folder) {
  const QByteArray what = kind == Kind::ReadError ? "r" : "w";
  QStringList paths;
  QList<PlacedCall> found;
  for (const QByteArray& line : outside::bytesOf(scratch + text("/log")).split('\n')) {
    const QList<QByteArray> words = line.split(' ');
    if (words.size() < 5 || words[0] != what) {
      continue;
    }
    const QString path = QString::fromUtf8(words.mid(4).join(' '));
    paths << path;
    if (call.match(QString::fromUtf8(words[3]) + QLatin1Char(' ') + path).hasMatch()) {
      const auto isOfIt = [&path](const QString& each) {
        return each == path || each.startsWith(path + QLatin1Char('/'));
      };
      const auto ofIt = std::count_if(paths.begin(), paths.end(), isOfIt);
      const bool isAlone = kind == Kind::ReadError || kind == Kind::WriteError;
      found << (isAlone && !path.contains(QString::fromUtf8(words[2]))
                    ? PlacedCall{path, static_cast<int>(ofIt)}
                    : PlacedCall{folder, words[1].toInt()});
    }
  }
  return found;
}

using Files = std::map<QString, QByteArray>;  // by their names in a folder

/// Without what the clock and the command line put into it.
inline QByteArray withoutTimes(const QByteArray& manifest) {
  QJsonObject json = QJsonDocument::fromJson(manifest).object();
  for (const char* key : {"wall_seconds", "real_time_factor", "planning_time_mean",
                          "planning_time_std", "command_line"}) {
    json.remove(text(key));
  }
  return json.isEmpty() ? manifest : QJsonDocument(json).toJson();
}

/// All below a folder; of databases only that they are there.
inline Files filesIn(const QString& folder) {
  Files found;
  QDirIterator files(folder, QDir::AllEntries | QDir::Hidden | QDir::System | QDir::NoDotAndDotDot,
                     QDirIterator::Subdirectories);
  while (files.hasNext()) {
    const QString path = files.next();
    const QString name = path.mid(folder.size() + 1);
    if (files.fileInfo().isDir()) {
      found[name + QLatin1Char('/')] = "";
    } else if (name.endsWith(text("manifest.json"))) {
      found[name] = withoutTimes(outside::bytesOf(path));
    } else {
      found[name] = name.endsWith(text(".sqlite")) ? "database" : outside::bytesOf(path);
    }
  }
  return found;
}

/// Names that are in one only, or with other bytes; empty: they are equal.
inline QString differences(const Files& found, const Files& wanted) {
  QStringList names;
  for (const auto& [name, bytes] : found) {
    const auto other = wanted.find(name);
    if (other == wanted.end()) {
      names << text("+") + name;
    } else if (other->second != bytes) {
      names << text("!") + name;
    }
  }
  for (const auto& [name, bytes] : wanted) {
    if (found.count(name) == 0) {
      names << text("-") + name;
    }
  }
  return names.join(QLatin1Char(' '));
}

}  // namespace faults
