#pragma once

#include <string>

#include <QByteArray>
#include <QFile>
#include <QTemporaryDir>

#include "sim2d/base/Result.h"

/// Files that a test writes, in a folder of its own, and what it looks for in messages.
namespace written {

inline std::string textOf(const base::Diagnostics& diagnostics) {
  std::string text;
  for (const base::Diagnostic& diagnostic : diagnostics) {
    text += diagnostic.text() + "\n";
  }
  return text;
}

inline bool contains(const base::Diagnostics& diagnostics, const std::string& part) {
  return textOf(diagnostics).find(part) != std::string::npos;
}

class Files {
 public:
  std::string write(const char* name, const QByteArray& content) const {
    QFile file(path(name));
    if (!file.open(QIODevice::WriteOnly) || file.write(content) != content.size()) {
      qFatal("cannot write");
    }
    return file.fileName().toStdString();
  }
  QString path(const char* name) const { return folder_.filePath(QString::fromUtf8(name)); }

  QString folder() const { return folder_.path(); }

 private:
  QTemporaryDir folder_;
};

}  // namespace written
