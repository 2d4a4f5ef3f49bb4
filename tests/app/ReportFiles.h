#pragma once

#include <QXmlStreamReader>

#include "tests/app/RunFiles.h"

/// `hunavsim report`, and what stands in its page.
namespace outside {

inline Finished report(const QString& folder, const QStringList& more = {}) {
  return runProgram(QStringList({text("report"), folder}) + more);
}

/// What stands in the elements of that name, one text each; "!" and the mistake when the page is
/// not well-formed.
inline QStringList textsOf(const QByteArray& page, const char* name) {
  QXmlStreamReader reader(page);
  QStringList texts;
  int depth = 0;
  while (!reader.atEnd()) {
    const auto token = reader.readNext();
    if (token == QXmlStreamReader::StartElement && reader.name() == text(name)) {
      ++depth;
      texts.append(QString());
    } else if (token == QXmlStreamReader::EndElement && reader.name() == text(name)) {
      --depth;
    } else if (token == QXmlStreamReader::Characters && depth > 0) {
      texts.last() += reader.text();
    }
  }
  return reader.hasError() ? QStringList(text("!") + reader.errorString()) : texts;
}

}  // namespace outside
