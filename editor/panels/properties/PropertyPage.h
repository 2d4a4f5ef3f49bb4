#pragma once

#include <algorithm>
#include <set>

#include <QtWidgets>

#include "editor/document/EditCommands.h"
#include "editor/look/CoreText.h"
#include "editor/look/Fields.h"
#include "editor/look/Form.h"
#include "editor/look/Theme.h"
#include "editor/panels/properties/EntityFields.h"

namespace editor {

/// Display options of a key in a form that its description does not contain.
struct FieldOptions {
  QStringList labels{};              // Of a choice, in table order; beside a switch.
  std::vector<std::string> names{};  // A text with these allowed values.
  QString none{};                    // First text of a choice: not set.
  QString placeholder{};             // Of a text field.
  TextField::Check check{};          // Of a text or list field.
  QString unit{}, singularUnit{};
  std::function<base::ParameterValue(const Entity&)> fallback{};  // Overrides that of the table.
  std::function<bool(const Entity&)> counts{};  // False: the value of the file is not used.
  std::function<bool(const std::vector<Entity>&)> enabled{}, visible{};
  QStringList hints{};  // Tooltips of a choice, one per text.
};
inline FieldOptions withLabels(const QStringList& labels, const QString& none = {}) {
  return {labels, {}, none};
}
inline FieldOptions withNames(std::vector<std::string> names, const QString& none) {
  return {{}, std::move(names), none};
}
inline FieldOptions withPlaceholder(const QString& placeholder, TextField::Check check = {}) {
  return {{}, {}, {}, placeholder, std::move(check)};
}

/// The common result of `get` for all entities; none if they differ.
template <class Get>
auto commonValue(const std::vector<Entity>& shown, const Get& get)
    -> std::optional<std::decay_t<decltype(get(shown.front()))>> {
  auto first = get(shown.front());
  const bool same = std::all_of(shown.begin(), shown.end(),
                                [&](const Entity& value) { return get(value) == first; });
  return same ? std::optional(std::move(first)) : std::nullopt;
}

/// The properties of one kind of entity: rows from the tables of scenario keys and from
/// page-specific properties, for one or several entities. Each edit is one command on all of them;
/// edits of the same row merge. Keys of a group (`Field::group`) go into a collapsible section with
/// that title.
class PropertyPage : public QWidget {
  Q_OBJECT
 public:
  explicit PropertyPage(ScenarioDocument& document,
                        const sim2d::FieldTables& tables = sim2d::fieldTables());

  void setTargets(const std::vector<EntityId>& targets);
  const std::vector<EntityId>& targets() const { return targets_; }
  void refresh();
  virtual void setTheme(const Theme&) {}

 Q_SIGNALS:
  void panelRequested(const QString& name);  // As `PanelContext::panelRequested`.

 protected:
  ScenarioDocument& document() const { return document_; }
  virtual long long seed() const;  // Seed of the shown sampled values.
  std::vector<Entity> values() const { return valuesOf(document_, targets_); }
  void apply(const QString& text, const std::function<void(Entity&)>& edit);

  FormSection* addSection(const QString& title);
  /// A section that is initially collapsed. Its heading shows how many of its keys the file sets,
  /// and resets all of them.
  FormSection* addFold(const QString& title);
  /// Adds a widget over the full width above all existing sections.
  void addOnTop(QWidget* widget) { layout_->insertWidget(0, widget); }
  /// Adds a row for a key of the table of T.
  template <class T>
  void addField(FormSection* section, const std::string& name, const FieldOptions& look = {}) {
    const sim2d::Field<T>* key = sim2d::fieldOf<T>(name, tables_);
    EntityField field = entityField(*key, document_, [this] { return seed(); });
    if (look.fallback) {
      field.fallback = look.fallback;
    }
    QWidget* const row = addRow(section, field, look);
    row->setObjectName(QString::fromStdString(rowName<T>(name)));
    places_[&key->spec] = {section, row};
  }
  /// Adds the other keys of the table, each in the section of its group or after its neighbour,
  /// except those that the page shows otherwise. Call it after all rows.
  template <class T>
  void addRemainingFields(const std::set<std::string>& shown = {}) {
    Place place = {sections_.front(), nullptr};
    for (const sim2d::Field<T>& field : sim2d::fieldsOf<T>(tables_)) {
      const auto known = places_.find(&field.spec);
      if (known != places_.end()) {
        place = known->second;
      } else if (!field.isStructure() && shown.count(field.spec.key) == 0) {
        if (!field.group.empty()) {
          addField<T>(foldOf(coreText(field.group)), field.spec.key);
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
  /// Adds a row from its description; returns the editing widget.
  QWidget* addRow(FormSection* section, const EntityField& field, const FieldOptions& look = {});
  void addNumberPair(FormSection* section, const QString& label, const EntityField& first,
                     const EntityField& second);
  /// Adds a row per parameter of the common implementation, and one for parameters without a row.
  void addParameterRows(FormSection* section, const ParameterOwner& owner,
                        const QString& helpOfOthers);
  void addListedRow(FormSection* section);
  void addPosition(FormSection* section);
  /// A whole number that is specific to each entity, for single entities only. `take` returns true
  /// if it accepts the typed number.
  void addUniqueNumber(FormSection* section, const QString& help, int least,
                       std::function<int(const Entity&)> get, std::function<bool(int)> take);
  /// Adds the entity name, for single entities only; it must be unique.
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
  void addPendingMark(FormSection* section, const QWidget* row,
                      const std::vector<EntityField>& fields);
  FormSection* foldOf(const QString& group);
  void showFold(const Fold& fold, QToolButton& reset, const std::vector<Entity>& shown);
  void resetFold(const FormSection* section);
  NumberField* makeNumber(const EntityField& field, const FieldOptions& look = {});
  QWidget* makeChoice(const EntityField& field, const FieldOptions& look);
  QWidget* makeSwitch(const EntityField& field, const FieldOptions& look);
  QWidget* makeText(const EntityField& field, const FieldOptions& look);
  void change(const EntityField& field, const base::ParameterValue& value);

  ScenarioDocument& document_;
  const sim2d::FieldTables& tables_;
  std::vector<EntityId> targets_;
  std::vector<std::optional<Entity>> inRun_;  // Of the shown run, parallel to the shown values.
  std::vector<std::function<void(const std::vector<Entity>&)>> refreshers_;
  std::vector<FormSection*> sections_;
  std::vector<Fold> folds_;
  std::map<const base::ParameterSpec*, Place> places_;  // By key of the tables.
  QVBoxLayout* layout_;
};

/// Label of a key, and its description without markup.
QString labelOf(const base::ParameterSpec& spec);
QString helpOf(const base::ParameterSpec& spec);

}  // namespace editor
