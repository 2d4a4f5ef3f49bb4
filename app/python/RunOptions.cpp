#include "app/python/RunOptions.h"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "app/python/Problems.h"
#include "sim2d/base/Text.h"
#include "sim2d/base/yaml/YamlTree.h"

namespace python {

namespace {

/// As the command line takes it: numbers in the shortest form, a pose or point as "1 2 0".
std::string wordOf(const py::handle& value) {
  if (py::isinstance<py::float_>(value)) {
    return base::formatDouble(value.cast<double>());
  }
  if (py::isinstance<py::list>(value) || py::isinstance<py::tuple>(value)) {
    std::string words;
    for (const py::handle each : value) {
      words += (words.empty() ? "" : " ") + wordOf(each);
    }
    return words;
  }
  return py::str(value).cast<std::string>();
}

const app::RunOption& optionOf(const std::string& key) {
  const auto* const found =
      std::find_if(std::begin(app::kRunOptions), std::end(app::kRunOptions),
                   [&key](const app::RunOption& option) { return option.key() == key; });
  if (found == std::end(app::kRunOptions)) {
    std::vector<std::string> names;
    for (const app::RunOption& option : app::kRunOptions) {
      names.push_back(option.key());
    }
    const auto nearest = base::nearestName(key, names);
    throw py::type_error("unknown option '" + key + "'" +
                         (nearest ? " (did you mean '" + *nearest + "'?)" : ""));
  }
  return *found;
}

void appendSet(std::vector<std::string>& words, const py::handle& value) {
  if (!py::isinstance<py::dict>(value)) {
    throw py::type_error("'set' must be a dict of paths and values");
  }
  for (const auto& [path, each] : py::reinterpret_borrow<py::dict>(value)) {
    words.insert(words.end(), {"--set", py::str(path).cast<std::string>() + "=" + yamlOf(each)});
  }
}

void appendOption(std::vector<std::string>& words, const std::string& key,
                  const py::handle& value) {
  const app::RunOption& option = optionOf(key);
  const std::string name = std::string("--") + option.name;
  const bool isList =
      std::holds_alternative<std::vector<std::string> app::RunSpec::*>(option.member);
  if (value.is_none()) {
    return;
  }
  if (key == "set") {
    appendSet(words, value);
  } else if (std::holds_alternative<bool app::RunSpec::*>(option.member)) {
    if (value.cast<bool>()) {
      words.push_back(name);
    }
  } else if (key == "metrics" && py::isinstance<py::list>(value)) {
    words.insert(words.end(), {name, py::str(",").attr("join")(value).cast<std::string>()});
  } else if (isList && py::isinstance<py::list>(value)) {
    for (const py::handle each : value) {
      words.insert(words.end(), {name, wordOf(each)});
    }
  } else {
    words.insert(words.end(), {name, wordOf(value)});
  }
}

py::object scalarOf(const base::YamlNode& node) {
  const std::string& text = node.text;
  if (!node.quoted) {
    if (text == "true" || text == "false") {
      return py::bool_(text == "true");
    }
    if (const auto integer = base::parseInt(text)) {
      return py::int_(*integer);
    }
    if (const auto number = base::parseDouble(text)) {
      return py::float_(*number);
    }
  }
  return py::str(text);
}

}  // namespace

app::RunSpec runSpecOf(const std::string& scenario, const py::kwargs& options) {
  std::vector<std::string> words = {"run", scenario};
  for (const auto& [key, value] : options) {
    appendOption(words, key.cast<std::string>(), value);
  }
  const base::Result<app::RunSpec> spec = app::runSpecOfCommandLine(words);
  if (!spec) {
    throwProblems(spec.diagnostics());
  }
  return *spec;
}

std::string yamlOf(const py::handle& value) {
  if (py::isinstance<py::bool_>(value)) {
    return value.cast<bool>() ? "true" : "false";
  }
  if (py::isinstance<py::int_>(value)) {
    return py::str(value).cast<std::string>();
  }
  if (py::isinstance<py::float_>(value)) {
    return base::formatDouble(value.cast<double>());
  }
  if (py::isinstance<py::str>(value)) {
    return base::quotedText(value.cast<std::string>());
  }
  if (py::hasattr(value, "tolist")) {  // an array or number of numpy
    return yamlOf(value.attr("tolist")());
  }
  std::string items;
  const bool isMap = py::isinstance<py::dict>(value);
  for (const py::handle each : value) {
    const std::string item = isMap ? yamlOf(each) + ": " + yamlOf(value[each]) : yamlOf(each);
    items += (items.empty() ? "" : ", ") + item;
  }
  return isMap ? "{" + items + "}" : "[" + items + "]";
}

py::object valueOfYaml(const base::YamlNode& node) {
  if (node.isMap()) {
    py::dict map;
    for (const base::YamlNode& value : node.items) {
      map[py::str(value.key)] = valueOfYaml(value);
    }
    return map;
  }
  if (node.isList()) {
    py::list list;
    for (const base::YamlNode& each : node.items) {
      list.append(valueOfYaml(each));
    }
    return list;
  }
  return node.isNull() ? py::none() : scalarOf(node);
}

}  // namespace python
