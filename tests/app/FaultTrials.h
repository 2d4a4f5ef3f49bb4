#pragma once

#include <set>

#include <QCryptographicHash>

#include "tests/app/FaultyProgram.h"

/// Commands that are disturbed (FaultyProgram.h), and what must hold afterwards.
namespace faults {

using outside::bytesOf;
using outside::copyFolder;

enum class Reader { None, Run, Batch };

/// A command with all that it reads and writes.
struct Operation {
  const char* name;
  const char* inputs;  // folders of the corpus that it finds
  const char* words;   // @ is the folder with them
  const char* output;  // where it writes
  Reader reader;
};

constexpr Operation kOperations[] = {
    {"run-new", "s", "run @/s/yard.yaml -q --duration 0.3 -o @/o", "o", Reader::Run},
    {"run-over", "s r", "run @/s/yard.yaml -q --duration 0.3 --seed 2 -o @/r", "r", Reader::Run},
    {"run-same", "s r", "run @/s/yard.yaml -q --duration 0.3 --seed 1 --counterfactual -o @/r", "r",
     Reader::Run},
    {"batch", "s", "batch @/s/plain.yaml -q --jobs 1 -o @/n", "n", Reader::Batch},
    {"batch-two-jobs", "s", "batch @/s/kept.yaml -q --jobs 2 -o @/n", "n", Reader::Batch},
    {"batch-over", "s b", "batch @/s/kept.yaml -q --jobs 1 -o @/b", "b", Reader::Batch},
    {"batch-resumed", "s h", "batch @/s/kept.yaml -q --jobs 2 -o @/h", "h", Reader::Batch},
    {"merge", "s p q", "merge -q -o @/m @/p @/q", "m", Reader::Batch},
    {"convert", "s c", "convert @/s/two_workers_agents.yaml --target isaac -q -o @/c", "c",
     Reader::None},
    {"evaluate", "s r e", "evaluate @/r -q -o @/e", "e", Reader::None},
    {"trees", "s t", "trees @/s/two_workers_agents.yaml -q -o @/t", "t", Reader::None},
    {"report", "s b", "report @/b --no-pdf -q", "b", Reader::None},
    {"render", "s r", "render @/r -q -o @/r/way.html", "r", Reader::None},
    {"run-from", "s r", "run --from @/r@0.15 -q --seed 7 -o @/o", "o", Reader::Run},
    {"run-nav2", "n", "run @/n/yard.yaml -q --duration 0.3 -o @/n/o", "n/o", Reader::Run},
    {"futures", "s r", "futures @/r@0.15 -q --seeds 2 --horizon 0.2 --json", "r", Reader::None},
    {"render-strip", "s r", "render @/r -q --strip 2 -o @/r/strip.svg", "r", Reader::None},
    {"render-plot", "s r", "render @/r -q --plot avg_robot_linear_speed -o @/r/plot.svg", "r",
     Reader::None},
    {"save", "d", "--save @/d/two_workers_agents.yaml", "d", Reader::None},
};

inline bool isBatch(const Operation& operation) {
  return operation.reader == Reader::Batch;
}

inline QTemporaryDir& place() {
  static QTemporaryDir folder;
  return folder;
}
inline QString corpus() {
  return place().filePath(text("corpus"));
}
inline QString work() {
  return place().filePath(text("w"));
}
inline QString scratch() {
  return place().filePath(text("x"));
}

inline QStringList wordsIn(const char* words) {
  return text(words).replace(text("@/"), work() + QLatin1Char('/')).split(QLatin1Char(' '));
}

inline QString programOf(const QStringList& words) {
  return words[0] == text("--save") ? QCoreApplication::applicationFilePath()
                                    : text(HUNAVSIM_PROGRAM);
}

/// The work folder with what the operation finds.
inline void layOut(const Operation& operation) {
  QDir(work()).removeRecursively();
  QDir(scratch()).removeRecursively();
  QDir().mkpath(scratch());
  QDir().mkpath(work());
  for (const QString& each : text(operation.inputs).split(QLatin1Char(' '))) {
    copyFolder(corpus() + QLatin1Char('/') + each, work() + QLatin1Char('/') + each);
  }
}

inline Outcome faulty(const QStringList& words, Kind kind, int at,
                      const QString& watched = work()) {
  return runFaulty(programOf(words), words, watched, scratch(), kind, at);
}

/// As `evaluate` reads a folder; empty: it refuses.
inline QByteArray measuresOf(const QString& run) {
  const QString out = scratch() + text("/measured");
  QDir(out).removeRecursively();
  const outside::Finished found =
      outside::runProgram({text("evaluate"), run, text("-q"), text("-o"), out});
  return found.exitCode == 0 ? bytesOf(out + text("/metrics.json")) : QByteArray();
}

/// What an operation finds and what it makes, undisturbed.
struct Known {
  int changes = 0, reads = 0;
  Files before, after;
  std::set<QByteArray> measures;  // of the run before and after
};

inline Known learn(const Operation& operation) {
  layOut(operation);
  Known known;
  const QString output = work() + QLatin1Char('/') + text(operation.output);
  known.before = filesIn(work());
  if (operation.reader == Reader::Run && QDir(output).exists()) {
    known.measures.insert(measuresOf(output));
  }
  QStringList words = wordsIn(operation.words);
  if (qstrcmp(operation.name, "batch-resumed") == 0) {
    words << text("--resume");
  }
  const Outcome outcome = faulty(words, Kind::Count, 0);
  if (outcome.exitCode != 0 || !outcome.left.empty()) {
    qFatal("%s fails undisturbed: %s", operation.name, qPrintable(outcome.err));
  }
  known.changes = outcome.changes;
  known.reads = outcome.reads;
  known.after = filesIn(work());
  if (operation.reader == Reader::Run) {
    known.measures.insert(measuresOf(output));
  }
  return known;
}

inline bool isRest(const QString& name) {
  static const QRegularExpression kRest(
      text("(^|/)\\.hunavsim-(new|commit|lock)|\\.new-\\d+-\\d+(-old)?$|\\.sqlite-(wal|journal)$"
           "|\\.html\\.\\w+$|/$"));
  return kRest.match(name).hasMatch();
}

inline Files withoutRests(const Files& files) {
  Files found;
  for (const auto& [name, bytes] : files) {
    if (!isRest(name)) {
      found[name] = bytes;
    }
  }
  return found;
}

/// Of a batch that ended before its time: rows that the whole table has, under the same head.
/// Without rows nobody knows the columns of the metrics.
inline bool isPartOf(const QByteArray& part, const QByteArray& whole) {
  const QList<QByteArray> all = whole.split('\n'), lines = part.split('\n');
  return (lines.size() == 2 && lines[1].isEmpty() && all[0].startsWith(lines[0])) ||
         std::all_of(lines.begin(), lines.end(),
                     [&all](const QByteArray& line) { return all.contains(line); });
}

/// A manifest that lacks no more than the checksum of an input, which has been told.
inline bool isWarned(const QByteArray& manifest, const QByteArray& wanted, const QString& said) {
  QJsonObject found = QJsonDocument::fromJson(manifest).object();
  QJsonObject whole = QJsonDocument::fromJson(wanted).object();
  found.remove(text("inputs"));
  whole.remove(text("inputs"));
  return !found.isEmpty() && found == whole && said.contains(text("has no checksum of it"));
}

/// Files as they were or as they are to be, and nothing that was to stay is gone.
inline QString damagedFile(const Operation& operation, const Known& known, Files& found,
                           const QString& said) {
  for (auto& [name, bytes] : found) {
    if (isRest(name)) {
      continue;
    }
    const auto old = known.before.find(name), fresh = known.after.find(name);
    const bool isOld = old != known.before.end() && old->second == bytes;
    const bool isFresh = fresh != known.after.end() && fresh->second == bytes;
    const bool isBegun = isBatch(operation) && fresh != known.after.end() &&
                         (name.endsWith(text("/manifest.json")) ||
                          (name.endsWith(text("/results.csv")) && isPartOf(bytes, fresh->second)));
    const bool isLess = qstrcmp(operation.name, "report") == 0 && fresh != known.after.end() &&
                        said.contains(text(": warning: "));  // it says what it lacks
    if (!isFresh && fresh != known.after.end() && isWarned(bytes, fresh->second, said)) {
      bytes = fresh->second;
    } else if (!isOld && !isFresh && !isBegun && !isLess) {
      return text("damaged: ") + name;
    }
  }
  for (const auto& [name, bytes] : withoutRests(known.before)) {
    const bool isMine = name.endsWith(text("mine.txt")) || !isBatch(operation);
    if (isMine && known.after.count(name) > 0 && found.count(name) == 0) {
      return text("lost: ") + name;
    }
  }
  return {};
}

/// A manifest whose files are not those that it lists, where nothing is left to be done.
inline QString wrongManifest(const Files& found) {
  for (const auto& [name, bytes] : found) {
    const QString folder = name.left(name.lastIndexOf(QLatin1Char('/')) + 1);
    const bool isWaiting =
        folder.contains(text(".hunavsim-")) || found.count(folder + text(".hunavsim-commit/")) > 0;
    const bool isRunOnItsWayOut =
        name.contains(text("/runs/")) && found.count(folder + text("trace.json")) == 0;
    if (!name.endsWith(text("manifest.json")) || isWaiting || isRunOnItsWayOut) {
      continue;
    }
    for (const auto& output :
         QJsonDocument::fromJson(bytes).object().value(text("outputs")).toArray()) {
      const auto file = found.find(folder + output.toObject().value(text("path")).toString());
      const QString hash = output.toObject().value(text("sha256")).toString();
      const bool isIt =
          file != found.end() &&
          hash.toLatin1() ==
              QCryptographicHash::hash(file->second, QCryptographicHash::Sha256).toHex();
      if (!isIt) {
        return name + text(" lists ") + output.toObject().value(text("path")).toString();
      }
    }
  }
  return {};
}

/// A half-made output that a reader takes. It reads a copy: who goes on finds what was left.
inline QString wronglyRead(const Operation& operation, const Known& known) {
  const QString copy = scratch() + text("/copy");
  const QString output = work() + QLatin1Char('/') + text(operation.output);
  if (operation.reader == Reader::None || !QDir(output).exists()) {
    return {};
  }
  QDir(copy).removeRecursively();
  copyFolder(output, copy);
  if (operation.reader == Reader::Run) {
    const QByteArray measures = measuresOf(copy);
    return measures.isEmpty() || known.measures.count(measures) > 0
               ? QString()
               : text("evaluate takes a run that nobody made");
  }
  const outside::Finished report =
      outside::runProgram({text("report"), copy, text("--no-pdf"), text("-q")});
  if (report.exitCode != 0) {
    return report.err.contains(text("error")) ? QString() : text("report refuses without a word");
  }
  const QJsonObject manifest = outside::readJson(copy + text("/manifest.json"));
  const QByteArray results = bytesOf(copy + text("/results.csv"));
  const QString listed =
      manifest.value(text("outputs")).toArray().at(0).toObject().value(text("sha256")).toString();
  if (listed.toLatin1() != QCryptographicHash::hash(results, QCryptographicHash::Sha256).toHex()) {
    return text("report takes a table that is not of the manifest");
  }
  return manifest.value(text("finished")).toInt(-1) == results.count('\n') - 1
             ? QString()
             : text("report takes a part for the whole");
}

/// Once more, without faults; empty: as if nothing had been.
inline QString wrongAfterwards(const Operation& operation, const Known& known) {
  const QStringList plain = wordsIn(operation.words);
  const bool isBegunAnew = isBatch(operation) && plain[0] == text("merge");
  QList<QStringList> ways = {plain};  // merge has no --resume; an earlier batch cannot go on
  if (plain[0] == text("batch")) {
    ways.prepend(plain + QStringList(text("--resume")));
  } else if (isBegunAnew) {
    ways << plain + QStringList(text("--force"));
  }
  const bool mayRefuse = isBegunAnew || qstrcmp(operation.name, "batch-over") == 0;
  outside::Finished found;
  for (const QStringList& each : ways) {
    QProcess process;
    process.start(programOf(each), each);
    found = outside::finishedOf(process);
    if (found.exitCode == 0 || !mayRefuse) {
      break;
    }
  }
  if (found.exitCode != 0) {
    return text("cannot be done again: ") + found.err;
  }
  const QString others = differences(filesIn(work()), known.after);
  return others.isEmpty() ? QString() : text("done again, it differs: ") + others;
}

/// Empty: all is as it has to be.
inline QString faultOf(const Operation& operation, const Known& known, Kind kind, int at,
                       Outcome& outcome, const QString& watched = work()) {
  layOut(operation);
  QStringList words = wordsIn(operation.words);
  if (qstrcmp(operation.name, "batch-resumed") == 0) {
    words << text("--resume");
  }
  outcome = faulty(words, kind, at, watched);
  if (!outcome.left.empty()) {
    return text("left alive: ") + outcome.left.join(QLatin1Char(' '));
  }
  Files found = filesIn(work());
  QStringList wrong = {damagedFile(operation, known, found, outcome.err), wrongManifest(found)};
  if (!outcome.isKilled && outcome.exitCode == 0) {
    const QString others = differences(withoutRests(found), withoutRests(known.after));
    wrong << (others.isEmpty() ? QString() : text("told to be fine: ") + others);
  } else if (!outcome.isKilled && !outcome.err.contains(work())) {
    wrong << text("exit code %1 without the name of a file").arg(outcome.exitCode);
  }
  wrong << wronglyRead(operation, known) << wrongAfterwards(operation, known);
  wrong.removeAll(QString());
  return wrong.join(text("; "));
}

}  // namespace faults
