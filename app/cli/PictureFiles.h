#pragma once

#include <functional>
#include <string>

#include <QSizeF>
#include <QString>

class QPainter;

/// A picture that is painted, as the bytes of a file: the same ones each time. Its pixels are those
/// of CSS, 96 to an inch. One thread; needs a QGuiApplication.
namespace app {

using Paint = std::function<void(QPainter&)>;

/// Throws std::bad_alloc where it is too large for the memory.
std::string pngOf(const QSizeF& size, const Paint& paint);
std::string svgOf(const QSizeF& size, const QString& title, const Paint& paint);
/// One page of that size, fonts embedded.
std::string pdfOf(const QSizeF& size, const Paint& paint);

}  // namespace app
