#include "editor/tools/ToolOptionFields.h"

#include <numeric>

#include "editor/look/FigurePainter.h"
#include "editor/look/Form.h"

namespace editor {

namespace {

constexpr QSize kBar(72, 16);
constexpr int kFieldWidth = 64;
constexpr int kNarrowWidth = 76;
const QLatin1String kMarkName("mark");

Look lookOfIndex(int index) {
  return lookOf(static_cast<sim2d::BehaviorType>(index + 1));
}

void showMarks(QWidget& fields, const Theme& theme) {
  const QList<QLabel*> marks = fields.findChildren<QLabel*>(kMarkName);
  for (int i = 0; i < marks.size(); ++i) {
    marks[i]->setPixmap(FigurePainter(theme).markIcon(lookOfIndex(i)).pixmap(16, 16));
  }
}

/// A button that shows the behaviour shares as a bar and opens fields for them.
class MixButton : public QToolButton {
  Q_DECLARE_TR_FUNCTIONS(editor::MixButton)
 public:
  MixButton(CrowdRecipe& recipe, const MapScene& scene, std::function<void()> changed,
            QWidget* parent)
      : QToolButton(parent), recipe_(recipe), scene_(scene), changed_(std::move(changed)) {
    setIconSize(kBar);
    setPopupMode(QToolButton::InstantPopup);
    setToolTip(tr("Mix of behaviours and seed"));
    setAccessibleName(toolTip());
    auto* menu = new QMenu(this);
    auto* action = new QWidgetAction(menu);
    const auto follow = [this] {
      showBar();
      changed_();
    };
    QWidget* fields = makeMixFields(recipe, scene.theme(), follow, this);
    action->setDefaultWidget(fields);
    menu->addAction(action);
    setMenu(menu);
    connect(&scene, &MapScene::themeChanged, this, [this, fields] {
      showMarks(*fields, scene_.theme());
      showBar();
    });
    showBar();
  }

 private:
  void showBar() {
    constexpr int kRatio = 2;
    QPixmap bar(kBar * kRatio);
    bar.setDevicePixelRatio(kRatio);
    bar.fill(Qt::transparent);
    QPainter painter(&bar);
    const int sum = std::max(1, std::accumulate(recipe_.mix.begin(), recipe_.mix.end(), 0));
    double left = 0.0;
    for (int i = 0; i < kBehaviorCount; ++i) {
      const double width = double(kBar.width()) * recipe_.mix[static_cast<std::size_t>(i)] / sum;
      painter.fillRect(QRectF(left, 3.0, width, kBar.height() - 6.0),
                       scene_.theme().fill(lookOfIndex(i)));
      left += width;
    }
    painter.end();
    setIcon(bar);
  }

  CrowdRecipe& recipe_;
  const MapScene& scene_;
  const std::function<void()> changed_;
};

}  // namespace

QWidget* makeMixFields(CrowdRecipe& recipe, const Theme& theme,
                       const std::function<void()>& changed, QWidget* parent) {
  auto* page = new QWidget(parent);
  auto* grid = new QGridLayout(page);
  grid->setContentsMargins(12, 8, 12, 8);
  grid->setHorizontalSpacing(8);
  grid->setVerticalSpacing(4);
  const auto add = [&](int row, const QString& name, const NumberField::Range& range,
                       const QString& unit, int& value) {
    auto* field = new NumberField(range, unit, page);
    field->setFixedWidth(kNarrowWidth + 12);
    field->show(value, false);
    field->setAccessibleName(name);
    QObject::connect(field, &NumberField::edited, page, [changed, &value](double wanted) {
      value = static_cast<int>(wanted);
      changed();
    });
    grid->addWidget(new QLabel(name, page), row, 1);
    grid->addWidget(field, row, 2);
    return field;
  };
  for (int i = 0; i < kBehaviorCount; ++i) {
    auto* mark = new QLabel(page);
    mark->setObjectName(kMarkName);
    grid->addWidget(mark, i, 0);
    add(i, lookName(lookOfIndex(i)), {0.0, 100.0, 0, 5.0}, QObject::tr("parts"),
        recipe.mix[static_cast<std::size_t>(i)]);
  }
  // Placed here because the option row must fit into a small window.
  add(kBehaviorCount, QObject::tr("Seed"), {0.0, 999999.0, 0, 1.0}, {}, recipe.seed)
      ->setToolTip(QObject::tr("Another seed generates different people"));
  showMarks(*page, theme);
  return page;
}

OptionsRow::OptionsRow(QWidget* parent)
    : QWidget(parent), layout_(configuredLayout(new QHBoxLayout(this), {}, 8)) {}

void OptionsRow::add(const QString& label, QWidget* field) {
  if (!label.isEmpty()) {
    if (layout_->count() > 0) {
      layout_->addSpacing(8);
    }
    layout_->addWidget(secondaryLabel(label, this));
    field->setAccessibleName(label);
  }
  layout_->addWidget(field);
}

NumberField* addNumber(OptionsRow& row, const QString& label, const NumberField::Range& range,
                       const QString& unit, double value,
                       const std::function<void(double)>& changed) {
  auto* field = new NumberField(range, unit, &row);
  field->setFixedWidth(unit.isEmpty() ? kFieldWidth : kNarrowWidth);
  field->show(value, false);
  QObject::connect(field, &NumberField::edited, &row, changed);
  row.add(label, field);
  return field;
}

ChoiceField* addChoice(OptionsRow& row, const QString& label, const QStringList& words, int at,
                       const std::function<void(int)>& chosen) {
  auto* field = new ChoiceField(&row);
  field->addItems(words);
  field->setCurrentIndex(at);
  field->setSizeAdjustPolicy(QComboBox::AdjustToContents);  // The field has no fixed column width.
  QObject::connect(field, qOverload<int>(&QComboBox::activated), &row, chosen);
  row.add(label, field);
  return field;
}

void addRecipeFields(OptionsRow& row, CrowdRecipe& recipe, const MapScene& scene,
                     const std::function<void()>& changed) {
  row.add(QObject::tr("Mix"), new MixButton(recipe, scene, changed, &row));
  ChoiceField* bodies =
      addChoice(row, {},
                {QObject::tr("All ages"), QObject::tr("Adults"), QObject::tr("Children"),
                 QObject::tr("Elderly"), QObject::tr("Wheelchairs"), QObject::tr("Luggage")},
                recipe.kind ? 1 + static_cast<int>(*recipe.kind) : 0, [&recipe, changed](int at) {
                  recipe.kind = at == 0 ? std::nullopt
                                        : std::optional(static_cast<sim2d::PersonKind>(at - 1));
                  changed();
                });
  bodies->setToolTip(QObject::tr("Bodies"));
  bodies->setAccessibleName(bodies->toolTip());
  addChoice(row, {}, {QObject::tr("Stand"), QObject::tr("Walk to goals")}, recipe.walks ? 1 : 0,
            [&recipe, changed](int at) {
              recipe.walks = at == 1;
              changed();
            });
}

}  // namespace editor
