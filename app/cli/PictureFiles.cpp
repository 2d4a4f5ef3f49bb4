#include "app/cli/PictureFiles.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <unistd.h>
#include <utility>
#include <vector>

#include <gif_lib.h>

#include <QBuffer>
#include <QFile>
#include <QImage>
#include <QPageSize>
#include <QPainter>
#include <QPdfWriter>
#include <QProcess>
#include <QStandardPaths>
#include <QSvgGenerator>
#include <QSvgRenderer>

#include "editor/look/FigurePainter.h"
#include "sim2d/base/Files.h"
#include "sim2d/base/Text.h"

namespace app {

namespace {

constexpr int kDotsPerInch = 96;
constexpr double kPointsPerPixel = 72.0 / kDotsPerInch;

/// Replaces the date that Qt writes, so that the bytes are reproducible.
void removeCreationDate(QByteArray& pdf) {
  const int at = pdf.indexOf("/CreationDate (D:");
  for (int k = at < 0 ? pdf.size() : at + 17; k < pdf.size() && pdf[k] != ')'; ++k) {
    if (pdf[k] >= '0' && pdf[k] <= '9') {
      pdf[k] = k == at + 22 || k == at + 24 ? '1' : '0';  // a valid month and day
    }
  }
}

}  // namespace

std::string pngOf(const QSizeF& size, const Paint& paint, const QColor& ground) {
  QImage image = editor::blankImage(size.toSize(), QImage::Format_ARGB32_Premultiplied);
  image.fill(ground);
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
  removeCreationDate(bytes);
  return bytes.toStdString();
}

std::pair<QSizeF, Paint> paintingOf(const report::Figure& figure) {
  const auto renderer =
      std::make_shared<QSvgRenderer>(QByteArray::fromStdString(figure.standalone()));
  const QSizeF size = renderer->defaultSize();
  return {size, [renderer, size](QPainter& painter) {
            renderer->render(&painter, {QPointF(), size});
          }};
}

std::string figureFile(const report::Figure& figure, const std::string& ending, double scale) {
  if (ending == ".svg") {
    return figure.standalone();
  }
  const std::pair<QSizeF, Paint> painting = paintingOf(figure);
  if (ending == ".pdf") {
    return pdfOf(painting.first, painting.second);
  }
  return pngOf(scale * painting.first, [scale, &paint = painting.second](QPainter& painter) {
    painter.scale(scale, scale);
    paint(painter);
  });
}

std::string endingOf(const std::string& path) {
  return base::toLower(std::filesystem::path(path).extension().string());
}

namespace {

namespace fs = std::filesystem;

constexpr int kWaitMs = 120'000;  // for the encoder, which may lag by some frames

/// 6 x 6 x 6 colours and 32 greys, the same for all frames to avoid flicker.
QVector<QRgb> gifColors() {
  QVector<QRgb> colors;
  colors.reserve(256);
  for (int red = 0; red < 6; ++red) {
    for (int green = 0; green < 6; ++green) {
      for (int blue = 0; blue < 6; ++blue) {
        colors << qRgb(51 * red, 51 * green, 51 * blue);
      }
    }
  }
  while (colors.size() < 256) {
    const int grey = (colors.size() - 215) * 255 / 41;
    colors << qRgb(grey, grey, grey);
  }
  return colors;
}

/// Stays in memory until finish().
class GifMovie : public Movie {
 public:
  GifMovie(std::string path, double framesPerSecond)
      : path_(std::move(path)), framesPerSecond_(framesPerSecond) {}
  ~GifMovie() override { close(); }
  Q_DISABLE_COPY_MOVE(GifMovie)

  base::Diagnostics add(const QImage& frame) override {
    if (file_ == nullptr && !begin(frame)) {
      return failure();
    }
    // In 1/100 s, rounded so that errors do not accumulate.
    const double end = std::round(100.0 * (frames_ + 1) / framesPerSecond_);
    const double begin = std::round(100.0 * frames_ / framesPerSecond_);
    ++frames_;
    const auto delay = static_cast<unsigned>(std::max(2.0, end - begin));
    GraphicsControlBlock control = {DISPOSE_DO_NOT, false, static_cast<int>(delay),
                                    NO_TRANSPARENT_COLOR};
    GifByteType bytes[4];
    EGifGCBToExtension(&control, bytes);
    const QImage indexed = frame.convertToFormat(QImage::Format_Indexed8, colors_,
                                                 Qt::ThresholdDither | Qt::AvoidDither);
    if (EGifPutExtension(file_, GRAPHICS_EXT_FUNC_CODE, sizeof(bytes), bytes) == GIF_ERROR ||
        EGifPutImageDesc(file_, 0, 0, indexed.width(), indexed.height(), false, nullptr) ==
            GIF_ERROR) {
      return failure();
    }
    std::vector<GifPixelType> line(static_cast<std::size_t>(indexed.width()));
    for (int row = 0; row < indexed.height(); ++row) {
      std::copy_n(indexed.constScanLine(row), line.size(), line.begin());
      if (EGifPutLine(file_, line.data(), indexed.width()) == GIF_ERROR) {
        return failure();
      }
    }
    return {};
  }

  base::Diagnostics finish() override {
    return close() ? base::writeFileAtomically(path_, bytes_) : failure();
  }

 private:
  static int appendBytes(GifFileType* file, const GifByteType* bytes, int count) {
    auto* const to = static_cast<std::string*>(file->UserData);
    to->append(reinterpret_cast<const char*>(bytes), static_cast<std::size_t>(count));
    return count;
  }

  bool begin(const QImage& frame) {
    file_ = EGifOpen(&bytes_, appendBytes, nullptr);
    if (file_ == nullptr) {
      return false;
    }
    std::vector<GifColorType> table;
    table.reserve(256);
    for (const QRgb color : colors_) {
      table.push_back({static_cast<GifByteType>(qRed(color)),
                       static_cast<GifByteType>(qGreen(color)),
                       static_cast<GifByteType>(qBlue(color))});
    }
    ColorMapObject* const map = GifMakeMapObject(256, table.data());
    EGifSetGifVersion(file_, true);
    const bool isBegun =
        map != nullptr &&
        EGifPutScreenDesc(file_, frame.width(), frame.height(), 8, 0, map) != GIF_ERROR &&
        writeLoopExtension();
    GifFreeMapObject(map);
    return isBegun;
  }
  bool writeLoopExtension() {
    constexpr char kName[] = "NETSCAPE2.0";
    constexpr GifByteType kLoopForever[] = {1, 0, 0};
    return EGifPutExtensionLeader(file_, APPLICATION_EXT_FUNC_CODE) != GIF_ERROR &&
           EGifPutExtensionBlock(file_, 11, kName) != GIF_ERROR &&
           EGifPutExtensionBlock(file_, sizeof(kLoopForever), kLoopForever) != GIF_ERROR &&
           EGifPutExtensionTrailer(file_) != GIF_ERROR;
  }
  bool close() {
    int problem = 0;
    return file_ != nullptr && EGifCloseFile(std::exchange(file_, nullptr), &problem) != GIF_ERROR;
  }
  base::Diagnostics failure() const { return {base::error("movie.not-made", {"giflib"}, path_)}; }

  const std::string path_;
  const double framesPerSecond_;
  const QVector<QRgb> colors_ = gifColors();
  std::string bytes_;
  GifFileType* file_ = nullptr;
  double frames_ = 0.0;
};

QString codecOf(const std::string& ending) {
  return ending == ".webm"   ? QStringLiteral("-c:v libvpx-vp9 -b:v 0 -crf 32 -row-mt 1")
         : ending == ".webp" ? QStringLiteral("-c:v libwebp_anim -quality 80 -loop 0")
                             : QStringLiteral("-c:v libx264 -crf 20 -movflags +faststart");
}

/// Pipes frames to ffmpeg, which writes a temporary file.
class FfmpegMovie : public Movie {
 public:
  FfmpegMovie(std::string path, double framesPerSecond)
      : path_(std::move(path)),
        temporaryPath_(path_ + ".new-" + std::to_string(::getpid()) + "-0"),
        framesPerSecond_(framesPerSecond) {}
  ~FfmpegMovie() override {
    if (process_.state() != QProcess::NotRunning) {
      process_.kill();
      process_.waitForFinished();
    }
    QFile::remove(QString::fromStdString(temporaryPath_));
  }
  Q_DISABLE_COPY_MOVE(FfmpegMovie)

  base::Diagnostics add(const QImage& frame) override {
    if (process_.state() == QProcess::NotRunning && !start(frame.size())) {
      return failure();
    }
    const QImage raw = frame.convertToFormat(QImage::Format_RGB32);
    process_.write(reinterpret_cast<const char*>(raw.constBits()), raw.sizeInBytes());
    while (process_.bytesToWrite() > 0) {  // at most one frame is buffered
      if (!process_.waitForBytesWritten(kWaitMs)) {
        return failure();
      }
    }
    return {};
  }

  base::Diagnostics finish() override {
    process_.closeWriteChannel();
    const bool isDone = process_.waitForFinished(kWaitMs) &&
                        process_.exitStatus() == QProcess::NormalExit && process_.exitCode() == 0;
    if (!isDone) {
      return failure();
    }
    std::error_code problem;
    fs::rename(temporaryPath_, path_, problem);
    return problem ? base::Diagnostics{base::error("file.cannot-write", {problem.message()}, path_)}
                   : base::Diagnostics();
  }

 private:
  bool start(const QSize& size) {
    const std::string ending = endingOf(path_);
    const QString words =
        QStringLiteral(
            "-loglevel error -y -f rawvideo -pix_fmt bgra -s %1x%2 -r %3 -i - %4 -pix_fmt yuv420p "
            "-fflags +bitexact -flags:v +bitexact -f %5")
            .arg(size.width())
            .arg(size.height())
            .arg(framesPerSecond_)
            .arg(codecOf(ending), QString::fromStdString(ending.substr(1)));
    process_.setProcessChannelMode(QProcess::MergedChannels);
    process_.start(
        QStringLiteral("ffmpeg"),
        words.split(QLatin1Char(' ')) +
            QStringList{QStringLiteral("file:") + QString::fromStdString(temporaryPath_)});
    return process_.waitForStarted();
  }
  base::Diagnostics failure() {
    constexpr int kWordsMs = 3000;  // waits for the error message of ffmpeg
    process_.closeWriteChannel();
    process_.waitForFinished(kWordsMs);
    const QList<QByteArray> outputLines = process_.readAll().trimmed().split('\n');
    const std::string reason = outputLines.front().trimmed().toStdString();
    return {
        base::error("movie.not-made", {reason.empty() ? "ffmpeg" : "ffmpeg: " + reason}, path_)};
  }

  const std::string path_, temporaryPath_;
  const double framesPerSecond_;
  QProcess process_;
};

}  // namespace

bool Movie::isAvailable(const std::string& ending) {
  return ending == ".gif" || !QStandardPaths::findExecutable(QStringLiteral("ffmpeg")).isEmpty();
}

base::Result<std::unique_ptr<Movie>> Movie::begin(const std::string& path, double framesPerSecond) {
  std::error_code ignored;  // an impossible folder is reported when the file is written
  fs::create_directories(fs::path(path).parent_path(), ignored);
  if (endingOf(path) == ".gif") {
    return std::unique_ptr<Movie>(std::make_unique<GifMovie>(path, framesPerSecond));
  }
  if (!isAvailable(endingOf(path))) {
    return base::error("movie.no-encoder", {}, path);
  }
  return std::unique_ptr<Movie>(std::make_unique<FfmpegMovie>(path, framesPerSecond));
}

}  // namespace app
