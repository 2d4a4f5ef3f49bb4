#include "app/run/ExportReport.h"

#include <algorithm>
#include <map>
#include <string_view>
#include <tuple>

#include "sim2d/base/Problems.h"

namespace app {

std::vector<ReportLine> groupedByPeople(const base::Diagnostics& report) {
  std::vector<ReportLine> lines;
  using Said = std::tuple<base::Severity, std::string_view, decltype(base::Diagnostic::values)>;
  std::map<Said, std::size_t> known;  // of people, without the name
  for (const base::Diagnostic& said : report) {
    const std::string name = said.value("where");
    if (said.entity.kind != base::EntityKind::Human || name.empty()) {
      lines.push_back({said, {}});
      continue;
    }
    const auto [place, isNew] = known.try_emplace(
        {said.severity, said.code, base::elsewhere({}, said).values}, lines.size());
    if (isNew) {
      lines.push_back({said, {}});
    }
    std::vector<std::string>& people = lines[place->second].people;
    if (std::find(people.begin(), people.end(), name) == people.end()) {
      people.push_back(name);
    }
  }
  for (ReportLine& line : lines) {
    if (line.people.size() < 2) {
      line.people.clear();
      continue;
    }
    line.said = base::elsewhere(std::to_string(line.people.size()) + " people", line.said);
    line.said.entity = {};
  }
  return lines;
}

}  // namespace app
