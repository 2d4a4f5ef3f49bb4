#include "app/cli/RunPicture.h"

#include <algorithm>
#include <cmath>

#include "app/cli/FigureLegend.h"
#include "app/cli/FigureMap.h"

namespace app {

namespace {

constexpr double kTallest = 1.4;  // height of the map over the width of the picture

}  // namespace

class RunPicture::Painting {
 public:
  Painting(const sim2d::Trace& trace, const PictureLayout& layout)
      : seed_(trace.header.seed),
        measures_(layout.width),
        text_(layout.textAsOutlines),
        map_(trace, measures_, text_, layout.options),
        legend_(trace, map_, measures_, text_),
        key_(map_, measures_, text_, layout.options) {
    const double margin = measures_.margin();
    const double width = layout.width - 2.0 * margin - measures_.legend();
    map_.place(QRectF(0.0, 0.0, width, kTallest * layout.width));  // arrows of the key have lengths
    const double below = measures_.isNarrow ? legend_.heightBelow(width) : 0.0;
    const double rest = 2.0 * margin + measures_.foot() + key_.height(width) + below;
    const double most = layout.height ? *layout.height - rest : kTallest * layout.width;
    const double scale = std::min(width / map_.world().width(), most / map_.world().height());
    const double beside = measures_.isNarrow ? 0.0 : legend_.heightBeside() - 2.0 * margin;
    const double high = layout.height ? most : std::max(scale * map_.world().height(), beside);
    map_.place(QRectF(margin, margin, width, high));
    size_ = QSizeF(layout.width, layout.height ? *layout.height : std::ceil(high + rest));
  }

  QSizeF size() const { return size_; }

  void paint(QPainter& painter, std::optional<double> time) {
    painter.setRenderHint(QPainter::Antialiasing);
    painter.fillRect(QRectF(QPointF(), size_), Qt::white);
    map_.paint(painter, time);
    const double left = map_.wallsLeft();
    const double width = size_.width() - measures_.margin() - measures_.legend() - left;
    double y = map_.mapRect().bottom();
    map_.paintScale(painter, {left, y + 0.6 * measures_.foot()});
    y += measures_.foot();
    key_.paint(painter, {left, y}, width);
    y += key_.height(width);
    const double now = std::min(time.value_or(map_.lastTime()), map_.lastTime());
    const QString when = QStringLiteral("%1 s · seed %2").arg(now, 0, 'f', 1).arg(seed_);
    if (measures_.isNarrow) {
      legend_.paintBelow(painter, {left, y}, width, when);
      return;
    }
    const QString stands =
        time ? QStringLiteral("○ start   the figure stands at %1 s").arg(now, 0, 'f', 1)
             : QStringLiteral("○ start   the figure stands at the end");
    legend_.paintBeside(painter, {size_.width() - measures_.legend(), measures_.margin()},
                        size_.height() - measures_.margin() - 0.4 * measures_.foot(), when, stands);
  }

 private:
  const long long seed_;
  const FigureMeasures measures_;
  const FigureText text_;
  FigureMap map_;
  const FigureLegend legend_;
  const FigureKey key_;
  QSizeF size_;
};

RunPicture::RunPicture(const sim2d::Trace& trace, const PictureLayout& layout)
    : painting_(std::make_unique<Painting>(trace, layout)) {}

RunPicture::~RunPicture() = default;

QSizeF RunPicture::size() const {
  return painting_->size();
}

void RunPicture::paint(QPainter& painter, std::optional<double> time) {
  painting_->paint(painter, time);
}

}  // namespace app
