#include "app/cli/PictureFiles.h"

#include <QBuffer>
#include <QImage>
#include <QPageSize>
#include <QPainter>
#include <QPdfWriter>
#include <QSvgGenerator>

#include "editor/look/Images.h"

namespace app {

namespace {

constexpr int kDotsPerInch = 96;
constexpr double kPointsPerPixel = 72.0 / kDotsPerInch;

/// The date that Qt writes would make every file another one.
void forgetDate(QByteArray& pdf) {
  const int at = pdf.indexOf("/CreationDate (D:");
  for (int k = at < 0 ? pdf.size() : at + 17; k < pdf.size() && pdf[k] != ')'; ++k) {
    if (pdf[k] >= '0' && pdf[k] <= '9') {
      pdf[k] = k == at + 22 || k == at + 24 ? '1' : '0';  // a month and a day that there are
    }
  }
}

}  // namespace

std::string pngOf(const QSizeF& size, const Paint& paint) {
  QImage image = editor::blankImage(size.toSize(), QImage::Format_ARGB32_Premultiplied);
  image.fill(Qt::white);
  {
    QPainter painter(&image);
    paint(painter);
  }
  QByteArray bytes;
  QBuffer buffer(&bytes);
  buffer.open(QIODevice::WriteOnly);
  image.save(&buffer, "png");
  return bytes.toStdString();
}

std::string svgOf(const QSizeF& size, const QString& title, const Paint& paint) {
  QByteArray bytes;
  QBuffer buffer(&bytes);
  buffer.open(QIODevice::WriteOnly);
  {
    QSvgGenerator generator;
    generator.setOutputDevice(&buffer);
    generator.setResolution(kDotsPerInch);
    generator.setSize(size.toSize());
    generator.setViewBox(QRectF(QPointF(), size));
    generator.setTitle(title);
    QPainter painter(&generator);
    paint(painter);
  }
  return bytes.toStdString();
}

std::string pdfOf(const QSizeF& size, const Paint& paint) {
  QByteArray bytes;
  QBuffer buffer(&bytes);
  buffer.open(QIODevice::WriteOnly);
  {
    QPdfWriter writer(&buffer);
    writer.setResolution(kDotsPerInch);
    writer.setPageSize(
        QPageSize(size * kPointsPerPixel, QPageSize::Point, {}, QPageSize::ExactMatch));
    writer.setPageMargins(QMarginsF(0, 0, 0, 0));
    QPainter painter(&writer);
    paint(painter);
  }
  forgetDate(bytes);
  return bytes.toStdString();
}

}  // namespace app
