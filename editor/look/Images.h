#pragma once

#include <new>

#include <QImage>

namespace editor {

/// A picture to be painted on. Throws std::bad_alloc where Qt would hand out a null one, which
/// crashes who paints on it. Thread: any.
inline QImage blankImage(const QSize& size, QImage::Format format) {
  QImage image(size, format);
  if (image.isNull() && !size.isEmpty()) {
    throw std::bad_alloc();
  }
  return image;
}

}  // namespace editor
