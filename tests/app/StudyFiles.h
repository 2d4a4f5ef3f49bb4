#pragma once

#include <csignal>
#include <unistd.h>

#include <QDir>
#include <QTemporaryDir>

#include "tests/app/RunFiles.h"

/// A small study, and `batch` while it runs.
namespace outside {

/// Two people and a robot on the open plane.
constexpr char kYardText[] =
    "hunav_loader:\n  ros__parameters:\n    yaml_base_name: yard\n    agents: [anna, ben]\n"
    "    anna:\n      id: 1\n      skin: 0\n      group_id: -1\n      max_vel: 1.2\n"
    "      radius: 0.3\n      init_pose: {x: 0.0, y: 0.0, z: 1.0, h: 0.0}\n"
    "      behavior: {type: Regular, configuration: 2}\n"
    "      goal_radius: 0.3\n      cyclic_goals: true\n      goals: [1, 2]\n"
    "    ben:\n      id: 2\n      skin: 0\n      group_id: -1\n      max_vel: 1.0\n"
    "      radius: 0.3\n      init_pose: {x: 6.0, y: 0.5, z: 1.0, h: 3.0}\n"
    "      behavior: {type: Regular, configuration: 2}\n"
    "      goal_radius: 0.3\n      cyclic_goals: true\n      goals: [2, 1]\n"
    "    global_goals:\n      1: {x: 8.0, y: 0.0, h: 0.0}\n      2: {x: -2.0, y: 0.3, h: 0.0}\n"
    "hunavsim_desktop:\n  ros__parameters:\n    format: 1\n    map_file: none\n"
    "    robots: [robot1]\n    robot1:\n      start: {x: 3.0, y: -3.0, h: 1.5}\n"
    "      goal: {x: 3.0, y: 4.0}\n";

/// A program that goes on while the test does something else.
class Running {
 public:
  explicit Running(const QStringList& words) {
    process_.start(text(HUNAVSIM_PROGRAM), words);
    process_.waitForStarted();
  }
  ~Running() {
    process_.kill();
    process_.waitForFinished();
  }
  Q_DISABLE_COPY_MOVE(Running)

  pid_t pid() const { return static_cast<pid_t>(process_.processId()); }
  bool isRunning() {
    return !process_.waitForFinished(0) && process_.state() != QProcess::NotRunning;
  }
  std::vector<qint64> workers() const { return childrenOf(pid()); }
  Finished wait() { return finishedOf(process_); }

 private:
  QProcess process_;
};

/// Studies of the yard in a folder that is gone with this.
class StudyFolder {
 public:
  StudyFolder() { writeText(path(text("yard.yaml")), kYardText); }
  QString path(const QString& name) const { return folder_.filePath(name); }

  QString writeStudy(const char* name, const QByteArray& more) const {
    QString file = path(text(name));
    writeText(file, "hunavsim_experiment: 1\nscenarios: [yard.yaml]\n" + more);
    return file;
  }
  /// 24 runs of some milliseconds each, with everything that a row may hold; run folders are kept.
  QString study() const {
    return writeStudy("study.yaml",
                      "seeds: 4\nduration: 15.0\nrecord: all\nvalues:\n"
                      "  robot1.planner: [pursuit, dwa]\n"
                      "  \"*.max_vel\": {normal: [1.2, 0.2, 0.6, 1.8]}\n"
                      "  anna.init_pose.y: {range: [0, 1, 0.5]}\n"
                      "  ben.behavior.configuration: {choice: [0, 2]}\n");
  }
  /// One that does not end by itself.
  QString endless(int seeds = 2) const {
    return writeStudy("endless.yaml",
                      "seeds: " + QByteArray::number(seeds) + "\nduration: 900000.0\n");
  }
  static QStringList words(const QString& experiment, const QString& out,
                           const QStringList& more = {}) {
    return QStringList{text("batch"), experiment, text("-o"), out} + more;
  }
  static QByteArray results(const QString& out) { return bytesOf(out + text("/results.csv")); }
  static QStringList runFolders(const QString& out) {
    return QDir(out + text("/runs")).entryList(QDir::AllEntries | QDir::NoDotAndDotDot);
  }

 private:
  QTemporaryDir folder_;
};

}  // namespace outside
