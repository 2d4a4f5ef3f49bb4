#include "app/cli/FileHash.h"

#include <QCryptographicHash>
#include <QFile>

namespace app {

std::string sha256OfFile(const std::string& path) {
  QFile file(QString::fromStdString(path));
  QCryptographicHash hash(QCryptographicHash::Sha256);
  return file.open(QIODevice::ReadOnly) && hash.addData(&file) ? hash.result().toHex().toStdString()
                                                               : std::string();
}

}  // namespace app
