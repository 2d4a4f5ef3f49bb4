#pragma once

#include <QFileInfo>
#include <QProcess>
#include <QString>
#include <QStringList>

/// Folder whose node_modules hold programs of others that read what we write
/// (tests/peers/package.json, installed by scripts/test.sh): HUNAV_PEERS, else build/peers of the
/// clone.
inline QString peersFolder() {
  const QByteArray given = qgetenv("HUNAV_PEERS");
  return given.isEmpty() ? QStringLiteral(SOURCE_DIR "/build/peers")
                         : QString::fromLocal8Bit(given);
}

/// Whether `module` ("@mcap/core") and node are there.
inline bool hasPeer(const QString& module) {
  return QFileInfo::exists(peersFolder() + QStringLiteral("/node_modules/") + module) &&
         QProcess::execute(QStringLiteral("node"), {QStringLiteral("--version")}) == 0;
}

struct PeerAnswer {
  bool isFine = false;
  QByteArray output;  // both streams
};

/// Runs a script of tests/peers with node; its first argument is the folder of the peers.
inline PeerAnswer askPeer(const QString& script, const QStringList& arguments) {
  QProcess node;
  node.setProcessChannelMode(QProcess::MergedChannels);
  node.start(
      QStringLiteral("node"),
      QStringList{QStringLiteral(SOURCE_DIR "/tests/peers/") + script, peersFolder()} + arguments);
  const bool ended = node.waitForFinished(60000);
  return {ended && node.exitStatus() == QProcess::NormalExit && node.exitCode() == 0,
          node.readAll()};
}
