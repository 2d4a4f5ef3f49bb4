#include "editor/panels/LayersPanel.h"

#include <cmath>

#include "editor/look/Form.h"
#include "editor/look/Icons.h"
#include "editor/panels/PanelRegistry.h"

namespace editor {

namespace {

constexpr int kEyeSize = 24;  // [px]
constexpr int kLayerHeight = 26;
constexpr int kSliderWidth = 84;
constexpr int kPercentWidth = 46;
constexpr int kLeastPercent = 10;  // Hidden layers are switched off by the eye.
constexpr int kPercentStep = 10;

/// A slider that leaves the mouse wheel to the panel, which scrolls.
class OpacitySlider : public QSlider {
 public:
  explicit OpacitySlider(QWidget* parent) : QSlider(Qt::Horizontal, parent) {
    setRange(kLeastPercent, 100);
    setSingleStep(kPercentStep);
    setPageStep(2 * kPercentStep);
    setValue(100);
    setFixedWidth(kSliderWidth);
  }

 protected:
  void wheelEvent(QWheelEvent* event) override { event->ignore(); }
};

QString bareText(const QAction& action) {
  return action.text().remove(QLatin1Char('&'));
}

QToolButton* makeEye(QWidget* parent) {
  auto* eye = new QToolButton(parent);
  eye->setAutoRaise(true);
  eye->setFixedSize(kEyeSize, kEyeSize);
  eye->setIconSize(QSize(16, 16));
  eye->setFocusPolicy(Qt::TabFocus);
  return eye;
}

}  // namespace

LayersPanel::LayersPanel(MapScene& scene, const Theme& theme)
    : scene_(scene), theme_(theme), grid_(new QGridLayout) {
  auto* body = new QWidget(this);
  column_ = configuredLayout(new QVBoxLayout(body), {8, 8, 12, 12}, 0);
  column_->addLayout(grid_);
  column_->addStretch(1);
  grid_->setHorizontalSpacing(4);
  grid_->setVerticalSpacing(0);
  grid_->setColumnStretch(1, 1);
  configuredLayout(new QVBoxLayout(this), {}, 0)->addWidget(scrollArea(body, this));
  connect(&scene_, &MapScene::optionsChanged, this, &LayersPanel::refresh);
}

void LayersPanel::addGroup(const QString& title, const std::vector<MapLayer>& layers) {
  Group& group = *groups_.emplace_back(std::make_unique<Group>());
  group.title = title;
  group.eye = makeEye(this);
  const int line = grid_->rowCount();
  grid_->setRowMinimumHeight(line, kLayerHeight + (groups_.size() > 1 ? 12 : 0));
  grid_->addWidget(group.eye, line, 0, Qt::AlignBottom);
  QLabel* heading = headingLabel(title, theme_.font(9.5, QFont::DemiBold), this);
  heading->setMinimumHeight(kEyeSize);
  grid_->addWidget(heading, line, 1, 1, 3, Qt::AlignBottom);
  connect(group.eye, &QToolButton::clicked, this, [this, &group] { switchGroup(group); });
  for (const MapLayer& layer : layers) {
    addRow(group, layer, grid_->rowCount());
  }
  refresh();
}

void LayersPanel::addRow(Group& group, const MapLayer& layer, int line) {
  const QString name = bareText(*layer.action);
  Row row{layer, makeEye(this), new OpacitySlider(this), secondaryLabel({}, this)};
  row.slider->setAccessibleName(tr("Opacity of %1").arg(name));
  row.slider->setToolTip(row.slider->accessibleName());
  row.percent->setFixedWidth(kPercentWidth);
  row.percent->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
  row.percent->setFont(theme_.figureFont(9.0));
  auto* label = new QLabel(name, this);
  label->setToolTip(layer.action->toolTip());
  grid_->setRowMinimumHeight(line, kLayerHeight);
  grid_->addWidget(row.eye, line, 0);
  grid_->addWidget(label, line, 1);
  grid_->addWidget(row.slider, line, 2);
  grid_->addWidget(row.percent, line, 3);
  QAction* action = layer.action;
  connect(row.eye, &QToolButton::clicked, action, &QAction::trigger);
  group.rows.push_back(row);
  connect(row.slider, &QSlider::valueChanged, this,
          [this, row](int percent) { setOpacity(row, percent); });
}

void LayersPanel::switchGroup(Group& group) {
  std::vector<QAction*> visible;
  for (const Row& row : group.rows) {
    if (row.layer.action->isChecked()) {
      visible.push_back(row.layer.action);
    }
  }
  std::vector<QAction*> restored = std::exchange(group.hidden, visible);
  if (visible.empty() && restored.empty()) {
    for (const Row& row : group.rows) {
      restored.push_back(row.layer.action);
    }
  }
  for (QAction* action : visible.empty() ? restored : visible) {
    action->setChecked(visible.empty());
  }
}

void LayersPanel::setOpacity(const Row& row, int percent) {
  CanvasOptions options = scene_.options();
  options.setOpacity(row.layer.option, 0.01 * percent);
  scene_.setOptions(options);
  Q_EMIT opacityChanged();
}

void LayersPanel::showEye(QToolButton& eye, const QString& name, bool isVisible) {
  const QColor color = theme_.color(isVisible ? Role::Text : Role::TextSecondary);
  eye.setIcon(tintedIcon(isVisible ? QStringLiteral("eye") : QStringLiteral("eye-off"), color));
  eye.setToolTip(isVisible ? tr("Hide %1").arg(name) : tr("Show %1").arg(name));
  eye.setAccessibleName(eye.toolTip());
}

void LayersPanel::refresh() {
  for (const std::unique_ptr<Group>& group : groups_) {
    bool isAny = false;
    for (const Row& row : group->rows) {
      const bool isVisible = scene_.options().*row.layer.option;
      isAny = isAny || isVisible;
      showEye(*row.eye, bareText(*row.layer.action), isVisible);
      const QSignalBlocker quiet(row.slider);
      row.slider->setValue(
          static_cast<int>(std::lround(100.0 * scene_.options().opacityOf(row.layer.option))));
      row.slider->setEnabled(isVisible);
      row.percent->setText(tr("%1 %").arg(row.slider->value()));
      row.percent->setEnabled(isVisible);
    }
    showEye(*group->eye, tr("all of %1").arg(group->title), isAny);
  }
}

void LayersPanel::setTheme(const Theme& theme) {
  theme_ = theme;
  refresh();
}

void addLayersPanel(PanelRegistry& to) {
  PanelInfo info{95, QObject::tr("Layers")};
  info.isOpen = false;
  to.add(info, [](PanelContext& context) {
    auto* panel = new LayersPanel(context.view.mapScene(), context.theme());
    QObject::connect(&context, &PanelContext::themeChanged, panel, &LayersPanel::setTheme);
    return panel;
  });
}

}  // namespace editor
