#pragma once

#include <new>

#include <QImage>

namespace editor {

/// An image to paint on. Throws std::bad_alloc if the allocation fails, where Qt returns a null
/// image that crashes a painter. Thread: any.
inline QImage blankImage(const QSize& size, QImage::Format format) {
  QImage image(size, format);
  if (image.isNull() && !size.isEmpty()) {
    throw std::bad_alloc();
  }
  return image;
}

}  // namespace editor
