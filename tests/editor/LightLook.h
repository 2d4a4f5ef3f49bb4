#pragma once

#include <memory>

#include <QApplication>

#include "editor/look/HouseStyle.h"

/// The program's look in a test that has no window of its own.
namespace look {

inline void wearLight() {
  auto style = std::make_unique<editor::HouseStyle>(editor::Theme::light());
  QApplication::setStyle(style.release());  // NOLINT(clang-analyzer-cplusplus.NewDeleteLeaks)
  QApplication::setPalette(editor::Theme::light().palette());
}

}  // namespace look
