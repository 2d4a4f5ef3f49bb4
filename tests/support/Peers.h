#pragma once

#include <QFileInfo>
#include <QProcess>
#include <QString>
#include <QStringList>

/// Folder whose node_modules hold programs of others that read what we write:
///   npm i --ignore-scripts @foxglove/rosmsg2-serialization@3.1.0 @foxglove/rosmsg@5.0.5
///     @foxglove/rosmsg-msgs-common@3.2.3 @mcap/core@2.2.2 @mcap/nodejs@1.0.2
///     fzstd@0.1.1 @foxglove/ws-protocol@0.8.0 ws
/// HUNAV_PEERS, else ../peers beside the clone.
inline QString peersFolder() {
  const QByteArray given = qgetenv("HUNAV_PEERS");
  return given.isEmpty() ? QStringLiteral(SOURCE_DIR "/../peers") : QString::fromLocal8Bit(given);
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

/// Runs a script of tests/bridge with node; its first argument is the folder of the peers.
inline PeerAnswer askPeer(const QString& script, const QStringList& arguments) {
  QProcess node;
  node.setProcessChannelMode(QProcess::MergedChannels);
  node.start(
      QStringLiteral("node"),
      QStringList{QStringLiteral(SOURCE_DIR "/tests/bridge/") + script, peersFolder()} + arguments);
  const bool ended = node.waitForFinished(60000);
  return {ended && node.exitStatus() == QProcess::NormalExit && node.exitCode() == 0,
          node.readAll()};
}
