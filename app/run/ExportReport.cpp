#include "app/run/ExportReport.h"

#include <algorithm>
#include <map>
#include <utility>

namespace app {

std::vector<ReportLine> groupedByPeople(const base::Diagnostics& report) {
  std::vector<ReportLine> lines;
  std::map<std::pair<base::Severity, std::string>, std::size_t> known;  // words without the name
  for (const base::Diagnostic& said : report) {
    const std::size_t colon = said.message.find(": ");
    const bool isOfPerson =
        said.entity.kind == base::EntityKind::Human && colon != std::string::npos;
    const std::string words = isOfPerson ? said.message.substr(colon) : std::string();
    const auto [place, isNew] = known.try_emplace({said.severity, words}, lines.size());
    if (!isOfPerson || isNew) {
      lines.push_back({said, {}});
    }
    const std::string name = said.message.substr(0, isOfPerson ? colon : 0);
    std::vector<std::string>& people = lines[place->second].people;
    if (isOfPerson && std::find(people.begin(), people.end(), name) == people.end()) {
      people.push_back(name);
    }
  }
  for (ReportLine& line : lines) {
    if (line.people.size() < 2) {
      line.people.clear();
      continue;
    }
    line.said.message = std::to_string(line.people.size()) + " people" +
                        line.said.message.substr(line.said.message.find(": "));
    line.said.entity = {};
  }
  return lines;
}

}  // namespace app
