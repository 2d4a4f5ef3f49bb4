#pragma once

#include <algorithm>
#include <functional>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include <QCheckBox>
#include <QVBoxLayout>

#include "editor/document/EditCommands.h"
#include "editor/look/Fields.h"
#include "editor/look/Form.h"
#include "editor/look/Theme.h"
#include "editor/panels/EntityFields.h"

namespace editor {

/// How a form shows a key: what its description does not say.
struct FieldLook {
  QStringList words{};               // of a choice, in the order of the table; beside a switch
  std::vector<std::string> names{};  // a text that is one of these
  QString none{};                    // first word of a choice: nothing of one's own
  QString placeholder{};             // of a text
  TextField::Check check{};          // of a text, also of a list
  QString unit{}, unitOfOne{};
  std::function<base::ParameterValue(const Entity&)> fallback{};  // instead of the table's
  std::function<bool(const Entity&)> counts{};  // false: the value of the file is not used
  std::function<bool(const std::vector<Entity>&)> enabled{}, visible{};
  QStringList hints{};  // of a choice: the tooltip of each word
};
inline FieldLook inWords(const QStringList& words, const QString& none = {}) {
  return {words, {}, none};
}
inline FieldLook oneOf(std::vector<std::string> names, const QString& none) {
  return {{}, std::move(names), none};
}
inline FieldLook emptyAs(const QString& placeholder, TextField::Check check = {}) {
  return {{}, {}, {}, placeholder, std::move(check)};
}

/// Where all that are shown give the same, that; else nothing.
template <class Get>
auto commonValue(const std::vector<Entity>& shown, const Get& get)
    -> std::optional<std::decay_t<decltype(get(shown.front()))>> {
  auto first = get(shown.front());
  const bool same = std::all_of(shown.begin(), shown.end(),
                                [&](const Entity& value) { return get(value) == first; });
  return same ? std::optional(std::move(first)) : std::nullopt;
}

/// The properties of one kind of entity: rows made from the tables of the scenario's keys and from
/// keys of its own, showing one or several entities. Each edit is one command on all of them; edits
/// of the same row merge. Keys of a group (`Field::group`) come into a fold of this title.
class PropertyPage : public QWidget {
  Q_OBJECT
 public:
  explicit PropertyPage(ScenarioDocument& document,
                        const sim2d::FieldTables& tables = sim2d::fieldTables());

  void setTargets(const std::vector<EntityId>& targets);
  const std::vector<EntityId>& targets() const { return targets_; }
  void refresh();
  virtual void setTheme(const Theme&) {}

 protected:
  ScenarioDocument& document() const { return document_; }
  virtual long long seed() const;  // whose draws are shown
  std::vector<Entity> values() const { return valuesOf(document_, targets_); }
  void apply(const QString& text, const std::function<void(Entity&)>& edit);

  FormSection* addSection(const QString& title);
  /// A section that begins folded. Its head tells how many of its keys the file changes, and takes
  /// them all back.
  FormSection* addFold(const QString& title);
  /// A widget over the whole width, above all sections that are there.
  void addOnTop(QWidget* widget) { layout_->insertWidget(0, widget); }
  /// A row made from the table of T.
  template <class T>
  void addField(FormSection* section, const std::string& name, const FieldLook& look = {}) {
    const sim2d::Field<T>* key = sim2d::fieldOf<T>(name, tables_);
    EntityField field = entityField(*key, document_, [this] { return seed(); });
    if (look.fallback) {
      field.fallback = look.fallback;
    }
    QWidget* const row = addRow(section, field, look);
    row->setObjectName(QString::fromStdString(rowName<T>(name)));
    places_[&key->spec] = {section, row};
  }
  /// The other keys of the table, each in the fold of its group or after its neighbour, without
  /// those that the page shows in its own way. After all rows.
  template <class T>
  void addNewFields(const std::set<std::string>& shown = {}) {
    Place place = {sections_.front(), nullptr};
    for (const sim2d::Field<T>& field : sim2d::fieldsOf<T>(tables_)) {
      const auto known = places_.find(&field.spec);
      if (known != places_.end()) {
        place = known->second;
      } else if (!field.isStructure() && shown.count(field.spec.key) == 0) {
        if (!field.group.empty()) {
          addField<T>(foldOf(QString::fromStdString(field.group)), field.spec.key);
          continue;
        }
        addField<T>(place.section, field.spec.key);
        QWidget* added = places_.at(&field.spec).row;
        place.section->moveLastRow(place.row);
        if (place.row != nullptr) {
          QWidget::setTabOrder(place.row, added);
        }
        place.row = added;
      }
    }
  }
  /// A row made from its description; returns what the user edits.
  QWidget* addRow(FormSection* section, const EntityField& field, const FieldLook& look = {});
  void addNumberPair(FormSection* section, const QString& label, const EntityField& first,
                     const EntityField& second);
  /// A row per parameter of the owner that all shown have, and one for what has no row.
  void addParameterRows(FormSection* section, const ParameterOwner& owner,
                        const QString& helpOfOthers);
  void addListed(FormSection* section);
  void addPosition(FormSection* section);
  /// A whole number that each entity has for itself: only for one at a time. `take` tells whether
  /// it took what was typed.
  void addOwnNumber(FormSection* section, const QString& help, int least,
                    std::function<int(const Entity&)> get, std::function<bool(int)> take);
  /// The name of the entity; only for one at a time, checked for being free.
  void addName(FormSection* section);
  void addRefresh(std::function<void(const std::vector<Entity>&)> refresh);

 private:
  struct Place {
    FormSection* section;
    QWidget* row;
  };
  using Applies = std::function<bool(const std::vector<Entity>&)>;
  struct Fold {
    FormSection* section;
    std::vector<std::pair<EntityField, Applies>> rows;
  };
  FormSection* foldOf(const QString& group);
  void showFold(const Fold& fold, QToolButton& reset, const std::vector<Entity>& shown);
  void resetFold(const FormSection* section);
  NumberField* makeNumber(const EntityField& field, const FieldLook& look = {});
  QWidget* makeChoice(const EntityField& field, const FieldLook& look);
  QWidget* makeSwitch(const EntityField& field, const FieldLook& look);
  QWidget* makeText(const EntityField& field, const FieldLook& look);
  void change(const EntityField& field, const base::ParameterValue& value);

  ScenarioDocument& document_;
  const sim2d::FieldTables& tables_;
  std::vector<EntityId> targets_;
  std::vector<std::function<void(const std::vector<Entity>&)>> refreshers_;
  std::vector<FormSection*> sections_;
  std::vector<Fold> folds_;
  std::map<const base::ParameterSpec*, Place> places_;  // of keys of the tables
  QVBoxLayout* layout_;
};

/// What people read about a key: its label, its sentence without signs of markup.
QString labelOf(const base::ParameterSpec& spec);
QString helpOf(const base::ParameterSpec& spec);

}  // namespace editor
