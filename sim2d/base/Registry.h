#pragma once

#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "sim2d/base/Find.h"
#include "sim2d/base/ParameterSpec.h"

namespace base {

/// Named factories in the order of registration: planners, models, robot types.
template <class Maker>
class Registry {
 public:
  struct Entry {
    std::string name;
    std::vector<ParameterSpec> parameters;  // its settable parameters
    Maker make;
    std::string help;  // one or two sentences for the user; may be empty
  };

  void add(std::string name, std::vector<ParameterSpec> parameters, Maker make,
           std::string help = {}) {
    entries_.push_back({std::move(name), std::move(parameters), std::move(make), std::move(help)});
  }
  const std::vector<Entry>& entries() const { return entries_; }
  std::vector<std::string> names() const {
    std::vector<std::string> names;
    for (const Entry& entry : entries_) {
      names.push_back(entry.name);
    }
    return names;
  }
  /// Null: unknown name.
  const Entry* find(const std::string& name) const { return findBy(entries_, &Entry::name, name); }

 private:
  std::vector<Entry> entries_;
};

/// Parameters of a planner or model that are members of a struct `Values`. Each is described once;
/// its default is the member's initial value.
template <class Values>
class ParameterTable {
 public:
  ParameterTable& add(double Values::*member, std::string key, std::string unit, Range range,
                      std::string help, std::string source = {}) {
    ParameterSpec spec;
    spec.key = std::move(key);
    spec.unit = std::move(unit);
    spec.range = range;
    spec.help = std::move(help);
    spec.source = std::move(source);
    rows_.push_back(
        {[member](Values& values) -> double& { return values.*member; }, std::move(spec)});
    return *this;
  }
  /// A count: forms show it without decimals.
  ParameterTable& addCount(double Values::*member, std::string key, Range range, std::string help,
                           std::string source = {}) {
    add(member, std::move(key), {}, range, std::move(help), std::move(source));
    rows_.back().spec.form.decimals = 0;
    rows_.back().spec.form.step = 1.0;
    return *this;
  }
  /// Adds the parameters of a nested struct.
  template <class Inner>
  ParameterTable& include(Inner Values::*member, const ParameterTable<Inner>& inner) {
    for (const auto& row : inner.rows()) {
      rows_.push_back(
          {[member, at = row.at](Values& values) -> double& { return at(values.*member); },
           row.spec});
    }
    return *this;
  }

  struct Row {
    std::function<double&(Values&)> at;
    ParameterSpec spec;
  };
  const std::vector<Row>& rows() const { return rows_; }

  std::vector<ParameterSpec> specs(Values defaults = {}) const {
    std::vector<ParameterSpec> specs;
    for (const Row& row : rows_) {
      specs.push_back(row.spec);
      specs.back().fallback = row.at(defaults);
    }
    return specs;
  }
  /// Sets the given parameters; unknown names are ignored.
  void set(Values& values, const std::vector<std::pair<std::string, double>>& given) const {
    for (const auto& [name, value] : given) {
      for (const Row& row : rows_) {
        if (row.spec.key == name) {
          row.at(values) = value;
        }
      }
    }
  }

 private:
  std::vector<Row> rows_;
};

}  // namespace base
