#include "editor/document/MapImageReader.h"

#include <algorithm>
#include <iterator>

#include <QFile>
#include <QImage>
#include <QImageReader>

namespace editor {

namespace {

/// Returns true if the format implies grey, opaque pixels.
bool isGrey(const QImage& image) {
  return image.format() == QImage::Format_Grayscale8 ||
         image.format() == QImage::Format_Grayscale16;
}

/// Converts row by row: a wide copy of a large image would take a gigabyte.
sim2d::MapImage toMapImage(const QImage& image) {
  sim2d::MapImage result;
  result.width = image.width();
  result.height = image.height();
  result.isGrey = isGrey(image);
  result.hasAlpha = image.hasAlphaChannel();
  const bool deep = image.depth() > 32 || image.format() == QImage::Format_Grayscale16;
  result.maximum = deep ? 65535 : 255;
  if (image.format() == QImage::Format_Grayscale8) {
    result.readRow = [image](int row, std::uint16_t* values) {
      std::copy_n(image.constScanLine(row), image.width(), values);
    };
    return result;
  }
  const int shift = deep ? 0 : 8;
  const int step = result.isGrey ? 4 : 1;  // Uses only the first of four channels.
  result.readRow = [image, shift, step](int row, std::uint16_t* values) {
    const QImage wide = image.copy(0, row, image.width(), 1).convertToFormat(QImage::Format_RGBA64);
    const auto* channels = reinterpret_cast<const quint16*>(wide.constScanLine(0));
    for (int i = 0; i < 4 * wide.width(); i += step) {
      *values++ = static_cast<std::uint16_t>(channels[i] >> shift);
    }
  };
  return result;
}

struct Format {
  const char* name;
  int place;  // Byte offset [B].
  const char* bytes;
};

/// Formats detected by content that Qt does not read, or reads only with plugins.
constexpr Format kOthers[] = {
    {"TIFF", 0, "II*"},      {"TIFF", 0, "MM"},       {"WebP", 8, "WEBP"},
    {"AVIF", 4, "ftypavif"}, {"HEIF", 4, "ftyphei"},  {"JPEG 2000", 4, "jP  "},
    {"GIF", 0, "GIF8"},      {"JPEG", 0, "\xFF\xD8"}, {"XCF (GIMP)", 0, "gimp xcf"},
    {"PDF", 0, "%PDF"},      {"SVG", 0, "<svg"},      {"Photoshop", 0, "8BPS"}};

/// "TIFF"; null if the format is unknown.
const char* formatOf(const QString& path) {
  QFile file(path);
  const QByteArray begin = file.open(QIODevice::ReadOnly) ? file.read(16) : QByteArray();
  const auto* const found =
      std::find_if(std::begin(kOthers), std::end(kOthers), [&](const Format& format) {
        return begin.mid(format.place, static_cast<int>(qstrlen(format.bytes))) == format.bytes;
      });
  return found == std::end(kOthers) ? nullptr : found->name;
}

/// "PGM, PNG, JPEG, BMP": the common formats that this installation supports.
std::string knownFormats() {
  const QList<QByteArray> supported = QImageReader::supportedImageFormats();
  std::string names = "PGM";
  for (const char* const name : {"PNG", "JPEG", "BMP", "GIF", "PPM"}) {
    names += supported.contains(QByteArray(name).toLower()) ? std::string(", ") + name : "";
  }
  return names;
}

}  // namespace

base::Result<sim2d::MapImage> loadMapImage(const std::string& path) {
  QImageReader reader(QString::fromStdString(path));
  reader.setDecideFormatFromContent(true);
  const QSize size = reader.size();
  if (size.isValid() && qint64{size.width()} * size.height() > sim2d::kMaxMapCells) {
    return base::error("image.too-large", {size.width(), size.height(), sim2d::kMaxMapCells}, path);
  }
  const QImage image = reader.read();
  const char* const format = image.isNull() ? formatOf(reader.fileName()) : nullptr;
  if (format != nullptr && reader.error() == QImageReader::UnsupportedFormatError) {
    return base::error("image.format", {format, knownFormats()}, path);
  }
  if (image.isNull()) {
    return base::error("image.cannot-read", {reader.errorString().toStdString()}, path);
  }
  return toMapImage(image);
}

}  // namespace editor
