#pragma once

#include <functional>
#include <optional>
#include <vector>

#include <QCheckBox>
#include <QVBoxLayout>

#include "editor/document/EditCommands.h"
#include "editor/look/Fields.h"
#include "editor/look/Form.h"
#include "editor/look/Theme.h"

namespace editor {

/// A number of an entity: how it is shown, where it is kept and what counts when it is left out.
struct NumberKey {
  QString label, unit;
  NumberField::Range range;
  std::function<std::optional<double>(const Entity&)> get;
  std::function<void(Entity&, std::optional<double>)> set;
  std::function<double(const Entity&)> fallback;  // what counts when `get` gives nothing; absent: 0
  double sliderTo = 0.0;                          // > 0: a slider from the minimum to here
  QString hint;                                   // tooltip: what it does
  QString unitOfOne;                              // "step" when `unit` is "steps"
};

/// One of a few words.
struct ChoiceKey {
  QString label;
  QStringList words;
  std::function<int(const Entity&)> get;  // index
  std::function<void(Entity&, int)> set;
  QString hint;
};

struct SwitchKey {
  QString label, words;
  std::function<bool(const Entity&)> get;
  std::function<void(Entity&, bool)> set;
  QString hint;
};

struct TextKey {
  QString label, placeholder;
  std::function<QString(const Entity&)> get;
  std::function<void(Entity&, const QString&)> set;
  TextField::Check check;
  QString hint;
};

/// The properties of one kind of entity: rows made from keys, showing one or several entities. Each
/// edit is one command on all of them; edits of the same row merge.
class PropertyPage : public QWidget {
  Q_OBJECT
 public:
  PropertyPage(ScenarioDocument& document, QWidget* parent = nullptr);

  void setTargets(const std::vector<EntityId>& targets);
  const std::vector<EntityId>& targets() const { return targets_; }
  virtual void refresh();
  virtual void setTheme(const Theme&) {}

 protected:
  ScenarioDocument& document() const { return document_; }
  std::vector<Entity> values() const;
  void apply(const QString& text, const std::function<void(Entity&)>& edit);

  FormSection* addSection(const QString& title);
  NumberField* addNumber(FormSection* section, const NumberKey& key);
  void addNumberPair(FormSection* section, const QString& label, const NumberKey& first,
                     const NumberKey& second);
  ChoiceField* addChoice(FormSection* section, const ChoiceKey& key);
  QCheckBox* addSwitch(FormSection* section, const SwitchKey& key);
  TextField* addText(FormSection* section, const TextKey& key);
  /// The name of the entity; only for one at a time, checked for being free.
  TextField* addName(FormSection* section);
  void addRefresh(std::function<void(const std::vector<Entity>&)> refresh);
  void finish();  // after the last section

 private:
  NumberField* makeNumber(const NumberKey& key);
  QString nameProblem(const QString& name) const;

  ScenarioDocument& document_;
  std::vector<EntityId> targets_;
  std::vector<std::function<void(const std::vector<Entity>&)>> refreshers_;
  QVBoxLayout* layout_;
};

/// Accessors of a member: NumberKey{…, memberOf(&sim2d::Human::radius), intoMember(…)}.
template <class T>
auto memberOf(std::optional<double> T::*member) {
  return [member](const Entity& entity) { return std::get<T>(entity).*member; };
}
template <class T>
auto intoMember(std::optional<double> T::*member) {
  return [member](Entity& entity, std::optional<double> value) {
    std::get<T>(entity).*member = value;
  };
}

constexpr double kDegree = base::kPi / 180.0;
/// Position on the map and heading, for all kinds that have them.
NumberKey xKey();
NumberKey yKey();
NumberKey headingKey();

}  // namespace editor
