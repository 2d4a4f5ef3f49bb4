#include "editor/tools/CrowdOptions.h"

#include <algorithm>
#include <numeric>

#include <QGridLayout>
#include <QLabel>
#include <QMenu>
#include <QPainter>
#include <QWidgetAction>

#include "editor/look/FigurePainter.h"

namespace editor {

namespace {

constexpr QSize kBar(72, 16);
constexpr int kFieldWidth = 64;
constexpr int kNarrowWidth = 76;

Look lookAt(int index) {
  return lookOf(static_cast<sim2d::BehaviorType>(index + 1));
}

}  // namespace

MixButton::MixButton(CrowdRecipe& recipe, const MapScene& scene, QWidget* parent)
    : QToolButton(parent), recipe_(recipe), scene_(scene) {
  setIconSize(kBar);
  setPopupMode(QToolButton::InstantPopup);
  setToolTip(tr("Mix of behaviours, and the seed"));
  setAccessibleName(toolTip());
  auto* menu = new QMenu(this);
  auto* action = new QWidgetAction(menu);
  action->setDefaultWidget(makeFields());
  menu->addAction(action);
  setMenu(menu);
  connect(&scene, &MapScene::themeChanged, this, &MixButton::showBar);
  showBar();
}

QWidget* MixButton::makeFields() {
  auto* page = new QWidget(this);
  auto* grid = new QGridLayout(page);
  grid->setContentsMargins(12, 8, 12, 8);
  grid->setHorizontalSpacing(8);
  grid->setVerticalSpacing(4);
  for (int i = 0; i < kBehaviorCount; ++i) {
    auto* mark = new QLabel(page);
    const auto showMark = [this, mark, i] {
      mark->setPixmap(FigurePainter(scene_.theme()).markIcon(lookAt(i)).pixmap(16, 16));
    };
    showMark();
    connect(&scene_, &MapScene::themeChanged, mark, showMark);
    auto* field = new NumberField({0.0, 100.0, 0, 5.0}, tr("parts"), page);
    field->setFixedWidth(kNarrowWidth + 12);
    field->show(recipe_.mix[static_cast<std::size_t>(i)], false);
    field->setAccessibleName(lookName(lookAt(i)));
    connect(field, &NumberField::edited, this, [this, i](double value) {
      recipe_.mix[static_cast<std::size_t>(i)] = static_cast<int>(value);
      showBar();
      Q_EMIT mixChanged();
    });
    grid->addWidget(mark, i, 0);
    grid->addWidget(new QLabel(lookName(lookAt(i)), page), i, 1);
    grid->addWidget(field, i, 2);
  }
  addSeed(*grid);
  return page;
}

/// Here and not in the row of the tool, which has to fit into a small window.
void MixButton::addSeed(QGridLayout& grid) {
  auto* seed = new NumberField({0.0, 999999.0, 0, 1.0}, {}, grid.parentWidget());
  seed->setFixedWidth(kNarrowWidth + 12);
  seed->show(recipe_.seed, false);
  seed->setAccessibleName(tr("Seed"));
  seed->setToolTip(tr("Another seed draws other people"));
  connect(seed, &NumberField::edited, this, [this](double value) {
    recipe_.seed = static_cast<int>(value);
    Q_EMIT mixChanged();
  });
  grid.addWidget(new QLabel(tr("Seed"), grid.parentWidget()), kBehaviorCount, 1);
  grid.addWidget(seed, kBehaviorCount, 2);
}

void MixButton::showBar() {
  constexpr int kRatio = 2;
  QPixmap bar(kBar * kRatio);
  bar.setDevicePixelRatio(kRatio);
  bar.fill(Qt::transparent);
  QPainter painter(&bar);
  const int sum = std::max(1, std::accumulate(recipe_.mix.begin(), recipe_.mix.end(), 0));
  double left = 0.0;
  for (int i = 0; i < kBehaviorCount; ++i) {
    const double width = double(kBar.width()) * recipe_.mix[static_cast<std::size_t>(i)] / sum;
    painter.fillRect(QRectF(left, 3.0, width, kBar.height() - 6.0), scene_.theme().fill(lookAt(i)));
    left += width;
  }
  painter.end();
  setIcon(bar);
}

NumberField* addNumber(OptionsRow& row, const QString& label, const NumberField::Range& range,
                       const QString& unit, double value,
                       const std::function<void(double)>& changed) {
  auto* field = new NumberField(range, unit, &row);
  field->setFixedWidth(unit.isEmpty() ? kFieldWidth : kNarrowWidth);
  field->show(value, false);
  field->setAccessibleName(label);
  QObject::connect(field, &NumberField::edited, &row, changed);
  row.add(label, field);
  return field;
}

void addRecipeFields(OptionsRow& row, CrowdRecipe& recipe, const MapScene& scene,
                     const std::function<void()>& changed) {
  auto* mix = new MixButton(recipe, scene, &row);
  QObject::connect(mix, &MixButton::mixChanged, &row, changed);
  row.add(QObject::tr("Mix"), mix);

  auto* kind = new ChoiceField(&row);
  kind->addItems({QObject::tr("All ages"), QObject::tr("Adults"), QObject::tr("Children"),
                  QObject::tr("Elderly"), QObject::tr("Wheelchairs"), QObject::tr("Luggage")});
  kind->setCurrentIndex(recipe.kind ? 1 + static_cast<int>(*recipe.kind) : 0);
  QObject::connect(kind, qOverload<int>(&QComboBox::activated), &row, [&recipe, changed](int at) {
    recipe.kind = at == 0 ? std::nullopt : std::optional(static_cast<sim2d::PersonKind>(at - 1));
    changed();
  });
  kind->setToolTip(QObject::tr("Bodies"));
  kind->setAccessibleName(kind->toolTip());
  row.add(kind);

  auto* route = new ChoiceField(&row);
  route->addItems({QObject::tr("Stand"), QObject::tr("Walk to goals")});
  route->setCurrentIndex(recipe.walks ? 1 : 0);
  QObject::connect(route, qOverload<int>(&QComboBox::activated), &row, [&recipe, changed](int at) {
    recipe.walks = at == 1;
    changed();
  });
  row.add(route);
}

}  // namespace editor
