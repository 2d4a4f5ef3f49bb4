#pragma once

#include <functional>

#include <QStringList>
#include <QXmlStreamReader>

/// By a reader of the tests' own: the values of an attribute in a tree file, in order, of the
/// elements that are meant (all, but for the model of the nodes). An error is its only value.
inline QStringList attributesIn(
    const QByteArray& tree, const char* attribute,
    const std::function<bool(const QXmlStreamReader&)>& isMeant = nullptr) {
  QXmlStreamReader xml(tree);
  QStringList values;
  bool isModel = false;
  while (!xml.atEnd()) {
    xml.readNext();
    if (xml.name() == QLatin1String("TreeNodesModel")) {
      isModel = xml.isStartElement();
    }
    const QXmlStreamAttributes attributes = xml.attributes();
    if (xml.isStartElement() && !isModel && attributes.hasAttribute(QLatin1String(attribute)) &&
        (isMeant == nullptr || isMeant(xml))) {
      values << attributes.value(QLatin1String(attribute)).toString();
    }
  }
  return xml.hasError() ? QStringList{xml.errorString()} : values;
}
