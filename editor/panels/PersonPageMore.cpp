#include <algorithm>

#include <QHBoxLayout>

#include "editor/document/Groups.h"
#include "editor/panels/PersonPage.h"
#include "editor/panels/Skins.h"
#include "sim2d/world/World.h"

namespace editor {

void PersonPage::addMoreSection() {
  FormSection* section = addSection(tr("More"));
  using Ours = sim2d::PersonExtension;
  addField<Ours>(section, "start_time");
  addField<Ours>(section, "mass");
  addField<Ours>(section, "model", oneOf(sim2d::modelNames(), tr("The scenario's")));
  addField<Ours>(section, "route",
                 inWords({tr("Around walls"), tr("Straight")}, tr("The scenario's")));
  addField<Ours>(section, "at_end", inWords({tr("Stops"), tr("Leaves"), tr("Starts over")}));
  addFileRows(section);
}

/// What only the file and the simulators of HuNavSim care for.
void PersonPage::addFileRows(FormSection* section) {
  auto* id = new NumberField({0.0, 2147483647.0, 0, 1.0}, {}, this);
  id->setToolTip(tr("Number of the person; names the tree file"));
  section->addRow(tr("Number"), id);
  connect(id, &NumberField::edited, this, [this](double value) {
    const int wanted = static_cast<int>(value);
    const bool free = document().scenario().humanById(wanted) == nullptr;
    if (free && targets().size() == 1) {
      apply(tr("Change number"), [wanted](Entity& entity) { personOf(entity).id = wanted; });
    } else {
      refresh();
    }
  });
  addRefresh([id](const std::vector<Entity>& shown) {
    id->setEnabled(shown.size() == 1);
    shown.size() == 1 ? id->show(personOf(shown.front()).id, false) : id->showMixed();
  });
  EntityField height = numberField(
      tr("Height z"), tr("m"), [](const Entity& entity) { return personOf(entity).initZ; },
      [](Entity& entity, std::optional<double> z) { personOf(entity).initZ = z; });
  height.spec.form.decimals = 3;
  height.spec.help = "Of the model in a 3D simulator; no meaning here";
  addRow(section, height);
  addField<sim2d::PersonExtension>(section, "tree", emptyAs(tr("looked for")));
}

void PersonPage::addGroupSection() {
  FormSection* section = addSection(tr("Group"));
  group_ = new ChoiceField(this);
  group_->setToolTip(tr("People of one group keep together while they walk"));
  section->addRow(tr("Walks with"), group_);
  constexpr int kNewGroup = -2;
  connect(group_, qOverload<int>(&QComboBox::activated), this, [this](int index) {
    const int group = group_->itemData(index).toInt();
    group == kNewGroup ? (void)pushGroup(document(), targets())
                       : pushJoin(document(), targets(), group);
  });
  auto* name = new TextField(this);
  name->setPlaceholderText(tr("name of the group"));
  section->addRow(tr("Called"), name);
  connect(name, &TextField::edited, this, [this](const QString& text) {
    pushGroupName(document(), group_->currentData().toInt(), text.trimmed().toStdString());
  });
  auto* members = secondaryLabel({}, this);
  members->setWordWrap(true);
  section->addRow(tr("Members"), members);
  QToolButton* dissolve = linkButton(tr("Dissolve"), this);
  dissolve->setToolTip(tr("Everybody of the group walks alone"));
  section->addRow(QString(), dissolve);
  connect(dissolve, &QToolButton::clicked, this,
          [this] { pushDissolve(document(), group_->currentData().toInt()); });
  addRefresh([=](const std::vector<Entity>& shown) {
    const sim2d::Scenario& scenario = document().scenario();
    const auto groups = groupsOf(scenario);
    group_->clear();
    group_->addItem(tr("Nobody"), -1);
    for (const auto& [number, people] : groups) {
      QPixmap swatch(12, 12);
      swatch.fill(groupColor(number, theme_));
      group_->addItem(QIcon(swatch), groupName(scenario, number), number);
    }
    group_->addItem(shown.size() > 1 ? tr("Each other: a new group") : tr("A new group"),
                    kNewGroup);
    const int first = personOf(shown.front()).groupId.value_or(-1);
    const bool same = std::all_of(shown.begin(), shown.end(), [first](const Entity& each) {
      return personOf(each).groupId.value_or(-1) == first;
    });
    group_->setCurrentIndex(same ? group_->findData(first) : -1);
    const bool grouped = same && first >= 0;
    QStringList names;
    for (const EntityId id : grouped ? groups.at(first) : std::vector<EntityId>()) {
      names << QString::fromStdString(document().human(id)->name);
    }
    members->setText(names.join(QStringLiteral(", ")));
    const auto& named = scenario.desktop.groups;
    const auto own = std::find_if(named.begin(), named.end(),
                                  [first](const auto& each) { return each.first == first; });
    name->show(own == named.end() ? QString() : QString::fromStdString(own->second));
    for (QWidget* widget : {static_cast<QWidget*>(name), static_cast<QWidget*>(members),
                            static_cast<QWidget*>(dissolve)}) {
      section->setRowVisible(widget, grouped);
    }
    section->setNote(!same ? tr("different groups") : QString());
  });
}

void PersonPage::addAppearanceSection() {
  FormSection* section = addSection(tr("Appearance"));
  skin_ = new ChoiceField(this);
  skin_->setIconSize(QSize(20, 20));
  skin_->setToolTip(tr("How the simulator of the scenario dresses the person"));
  section->addRow(tr("Figure"), skin_);
  auto* elsewhere = secondaryLabel({}, this);
  elsewhere->setWordWrap(true);
  section->addRow(tr("Elsewhere"), elsewhere);
  connect(skin_, qOverload<int>(&QComboBox::activated), this, [this](int index) {
    const int skin = skin_->itemData(index).toInt();
    apply(tr("Change appearance"), [skin](Entity& entity) { personOf(entity).skin = skin; });
  });
  addRefresh([=](const std::vector<Entity>& shown) {
    const std::string simulator = document().scenario().simulator.value_or(std::string());
    skin_->clear();
    for (const Skin& skin : skinsOf(simulator)) {
      skin_->addItem(skinIcon(skin, theme_), skin.name, skin.number);
    }
    const int first = personOf(shown.front()).skin.value_or(0);
    const bool same = std::all_of(shown.begin(), shown.end(), [first](const Entity& each) {
      return personOf(each).skin.value_or(0) == first;
    });
    skin_->setCurrentIndex(same ? skin_->findData(skinFor(simulator, first).number) : -1);
    section->setNote(simulator.empty() ? tr("as in Gazebo") : QString::fromStdString(simulator));
    QStringList others;
    for (const char* other : {"Gazebo Classic", "Isaac Sim", "Webots"}) {
      if (&skinsOf(other) != &skinsOf(simulator)) {
        others << QString::fromLatin1(other) + QStringLiteral(": ") + skinFor(other, first).name;
      }
    }
    elsewhere->setText(same ? others.join(QLatin1Char('\n')) : QString());
  });
}

}  // namespace editor
