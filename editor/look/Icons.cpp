#include "editor/look/Icons.h"

#include <algorithm>

#include <QSvgRenderer>

static void initResources() {
  Q_INIT_RESOURCE(hunavsim);
}  // Q_INIT_RESOURCE must be used outside of namespaces.

namespace editor {

namespace {

constexpr const char* kStrokeToken = "#1B1F23";
constexpr const char* kAccentToken = "#2F6FDE";

struct IconColors {
  QColor stroke, accent, disabled, on;
};

class SvgIconEngine : public QIconEngine {
 public:
  SvgIconEngine(QString name, QByteArray svg, const IconColors& colors)
      : name_(std::move(name)), svg_(std::move(svg)), colors_(colors) {}

  QIconEngine* clone() const override { return new SvgIconEngine(name_, svg_, colors_); }

  void paint(QPainter* painter, const QRect& rect, QIcon::Mode mode, QIcon::State state) override {
    QSvgRenderer renderer(recoloured(mode, state));
    const int side = std::min(rect.width(), rect.height());
    QRect square(0, 0, side, side);
    square.moveCenter(rect.center());
    renderer.render(painter, square);
  }

  QPixmap pixmap(const QSize& size, QIcon::Mode mode, QIcon::State state) override {
    const QString key = QStringLiteral("hunav/%1/%2/%3/%4x%5")
                            .arg(name_, strokeOf(mode, state).name(), accentOf(mode, state).name())
                            .arg(size.width())
                            .arg(size.height());
    QPixmap result;
    if (!QPixmapCache::find(key, &result)) {
      result = QPixmap(size);
      result.fill(Qt::transparent);
      QPainter painter(&result);
      painter.setRenderHint(QPainter::Antialiasing);
      paint(&painter, QRect(QPoint(), size), mode, state);
      painter.end();
      QPixmapCache::insert(key, result);
    }
    return result;
  }

 private:
  QColor strokeOf(QIcon::Mode mode, QIcon::State state) const {
    return mode == QIcon::Disabled ? colors_.disabled
           : state == QIcon::On    ? colors_.on
                                   : colors_.stroke;
  }
  QColor accentOf(QIcon::Mode mode, QIcon::State state) const {
    return mode == QIcon::Disabled || state == QIcon::On ? strokeOf(mode, state) : colors_.accent;
  }
  QByteArray recoloured(QIcon::Mode mode, QIcon::State state) const {
    QByteArray svg = svg_;
    svg.replace(kStrokeToken, "@stroke@");
    svg.replace(kAccentToken, accentOf(mode, state).name().toLatin1());
    svg.replace("@stroke@", strokeOf(mode, state).name().toLatin1());
    return svg;
  }

  QString name_;
  QByteArray svg_;
  IconColors colors_;
};

QIcon makeIcon(const QString& name, const IconColors& colors) {
  initResources();
  QFile file(QStringLiteral(":/icons/%1.svg").arg(name));
  return file.open(QIODevice::ReadOnly) ? QIcon(new SvgIconEngine(name, file.readAll(), colors))
                                        : QIcon();
}

}  // namespace

QIcon themedIcon(const QString& name, const Theme& theme) {
  return makeIcon(name, {theme.color(Role::Text), theme.color(Role::Accent),
                         theme.palette().color(QPalette::Disabled, QPalette::Text),
                         theme.color(Role::AccentText)});
}

QIcon tintedIcon(const QString& name, const QColor& color) {
  return makeIcon(name, {color, color, color, color});
}

}  // namespace editor
