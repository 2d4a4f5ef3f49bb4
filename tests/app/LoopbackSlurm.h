#pragma once

#include <arpa/inet.h>
#include <memory>
#include <pwd.h>
#include <sys/socket.h>
#include <unistd.h>
#include <vector>

#include <QFile>
#include <QProcess>
#include <QStandardPaths>
#include <QTemporaryDir>
#include <QtTest>

#include "tests/app/RunFiles.h"

/// A cluster of one node on this machine: munged, slurmctld and slurmd of Debian, in a folder of
/// their own, as whoever runs the test. They end with this object. Needs no root, nor files in
/// /etc.
namespace outside {

class LoopbackSlurm {
 public:
  static bool isInstalled() {
    for (const char* program : {"munged", "slurmctld", "slurmd"}) {
      if (programOf(program).isEmpty()) {
        return false;
      }
    }
    return true;
  }

  /// True as soon as the node takes jobs; the children of this process find it by SLURM_CONF then.
  bool start() {
    const QDir folder(folder_.path());
    if (!folder.mkdir(text("state")) || !folder.mkdir(text("spool")) || !writeKey()) {
      return false;
    }
    writeText(path("slurm.conf"), configuration());
    qputenv("SLURM_CONF", QFile::encodeName(path("slurm.conf")));
    launch("munged", {text("--foreground"), text("--force"), text("--num-threads=2"),
                      text("--key-file=") + path("key"), text("--socket=") + path("socket"),
                      text("--pid-file=") + path("munged.pid"), text("--seed-file=") + path("seed"),
                      text("--log-file=") + path("munged.log")});
    if (!QTest::qWaitFor([this] { return QFile::exists(path("socket")); }, kLong)) {
      return false;
    }
    launch("slurmctld", {text("-D"), text("-c")});
    launch("slurmd", {text("-D"), text("-N"), text("localhost")});
    return QTest::qWaitFor([] { return nodeState().startsWith("idle"); }, kLong);
  }

  LoopbackSlurm() = default;
  ~LoopbackSlurm() {
    for (auto daemon = daemons_.rbegin(); daemon != daemons_.rend(); ++daemon) {
      (*daemon)->terminate();
      if (!(*daemon)->waitForFinished(kLong)) {
        (*daemon)->kill();
        (*daemon)->waitForFinished(kLong);
      }
    }
    qunsetenv("SLURM_CONF");
  }
  Q_DISABLE_COPY_MOVE(LoopbackSlurm)

  /// What sinfo tells of the nodes, empty if there is no Slurm.
  static QByteArray nodeState() {
    QProcess info;
    info.start(text("sinfo"), {text("-h"), text("-o"), text("%t")});
    return info.waitForFinished(kLong) && info.exitCode() == 0 ? info.readAllStandardOutput()
                                                               : QByteArray();
  }

 private:
  static constexpr int kLong = 20000;  // [ms]

  static QString programOf(const char* name) {
    return QStandardPaths::findExecutable(text(name),
                                          {text("/usr/sbin"), text("/usr/bin"), text("/sbin")});
  }
  /// A port of TCP that nobody has at this moment.
  static QByteArray freePort() {
    const int socket = ::socket(AF_INET, SOCK_STREAM, 0);
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    socklen_t size = sizeof address;
    auto* place = reinterpret_cast<sockaddr*>(&address);
    const bool isBound =
        ::bind(socket, place, size) == 0 && ::getsockname(socket, place, &size) == 0;
    ::close(socket);
    return QByteArray::number(isBound ? ntohs(address.sin_port) : 0);
  }
  QString path(const char* name) const { return folder_.filePath(text(name)); }

  bool writeKey() const {
    QFile key(path("key"));
    return key.open(QIODevice::WriteOnly) && key.write(QByteArray(64, 'k')) == 64 &&
           key.setPermissions(QFile::ReadOwner);
  }

  void launch(const char* name, const QStringList& words) {
    daemons_.push_back(std::make_unique<QProcess>());
    daemons_.back()->setStandardOutputFile(QProcess::nullDevice());
    daemons_.back()->setStandardErrorFile(QProcess::nullDevice());
    daemons_.back()->start(programOf(name), words);
  }

  QByteArray configuration() const {
    const QByteArray here = QFile::encodeName(folder_.path());
    const passwd* entry = getpwuid(geteuid());
    const QByteArray user = entry == nullptr ? "root" : entry->pw_name;
    return "ClusterName=loop\nSlurmctldHost=localhost(127.0.0.1)\nSlurmctldPort=" + freePort() +
           "\nSlurmdPort=" + freePort() + "\nSlurmUser=" + user + "\nSlurmdUser=" + user +
           "\nAuthType=auth/munge\nAuthInfo=socket=" + here +
           "/socket\nMpiDefault=none\nProctrackType=proctrack/linuxproc\nTaskPlugin=task/none\n"
           "JobAcctGatherType=jobacct_gather/none\nAccountingStorageType=accounting_storage/none\n"
           "SwitchType=switch/none\nReturnToService=2\nSelectType=select/cons_tres\n"
           "SelectTypeParameters=CR_Core\nSchedulerType=sched/backfill\n"
           "SchedulerParameters=sched_min_interval=0,batch_sched_delay=0,sched_interval=1,"
           "bf_interval=1\nStateSaveLocation=" +
           here + "/state\nSlurmdSpoolDir=" + here + "/spool\nSlurmctldPidFile=" + here +
           "/ctld.pid\nSlurmdPidFile=" + here + "/slurmd.pid\nSlurmctldLogFile=" + here +
           "/ctld.log\nSlurmdLogFile=" + here +
           "/slurmd.log\nNodeName=localhost NodeAddr=127.0.0.1 CPUs=2 Sockets=1 CoresPerSocket=2 "
           "ThreadsPerCore=1 RealMemory=500 State=UNKNOWN\n"
           "PartitionName=main Nodes=localhost Default=YES MaxTime=INFINITE State=UP\n";
  }

  QTemporaryDir folder_;
  std::vector<std::unique_ptr<QProcess>> daemons_;
};

}  // namespace outside
