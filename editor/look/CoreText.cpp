#include "editor/look/CoreText.h"

#include <QCoreApplication>

namespace editor {

QString coreText(const std::string& text) {
  return text.empty() ? QString() : QCoreApplication::translate("Core", text.c_str());
}

}  // namespace editor
