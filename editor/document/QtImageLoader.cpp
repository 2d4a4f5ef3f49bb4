#include "editor/document/QtImageLoader.h"

#include <QImage>
#include <QImageReader>

namespace editor {

namespace {

constexpr qint64 kMaximumPixels = 100'000'000;

sim2d::MapImage toMapImage(const QImage& image) {
  sim2d::MapImage result;
  result.width = image.width();
  result.height = image.height();
  result.hasAlpha = image.hasAlphaChannel();
  const bool deep = image.depth() > 32 || image.format() == QImage::Format_Grayscale16;
  result.maximum = deep ? 65535 : 255;
  const int shift = deep ? 0 : 8;
  const QImage wide = image.convertToFormat(QImage::Format_RGBA64);
  result.rgba.reserve(static_cast<std::size_t>(wide.width()) *
                      static_cast<std::size_t>(wide.height()) * 4);
  for (int row = 0; row < wide.height(); ++row) {
    const auto* channels = reinterpret_cast<const quint16*>(wide.constScanLine(row));
    for (int i = 0; i < 4 * wide.width(); ++i) {
      result.rgba.push_back(static_cast<std::uint16_t>(channels[i] >> shift));
    }
  }
  return result;
}

}  // namespace

base::Result<sim2d::MapImage> loadMapImage(const std::string& path) {
  QImageReader reader(QString::fromStdString(path));
  reader.setDecideFormatFromContent(true);
  const QSize size = reader.size();
  if (size.isValid() && qint64{size.width()} * size.height() > kMaximumPixels) {
    return base::error("image.too-many-pixels", {size.width(), size.height()}, path);
  }
  const QImage image = reader.read();
  if (image.isNull()) {
    return base::error("image.cannot-read", {reader.errorString().toStdString()}, path);
  }
  return toMapImage(image);
}

}  // namespace editor
