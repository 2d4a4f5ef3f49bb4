#include "app/report/PageParts.h"

#include <algorithm>

#include "app/report/PlayerPage.h"

namespace report {

void PageParts::section(const std::string& id, const std::string& title) {
  sections_.emplace_back(id, title);
  body += "<h2 id=\"" + id + "\">" + escaped(title) + "</h2>\n";
}

void PageParts::add(const std::optional<Figure>& figure) {
  if (!figure) {
    return;
  }
  report.figures.push_back(*figure);
  body += "<figure>\n" + figure->markup() + "<figcaption>" +
          element("b", "", "Figure " + std::to_string(report.figures.size()) + ".") + " " +
          escaped(figure->caption) + "</figcaption>\n</figure>\n";
}

void PageParts::add(const std::optional<Table>& table, const std::string& htmlClass) {
  if (table) {
    add(*table, *table, htmlClass);
  }
}

void PageParts::add(const Table& shown, Table all, const std::string& htmlClass) {
  report.tables.push_back(std::move(all));
  body += tableHtml(shown, htmlClass, report.tables.size());
}

std::size_t PageParts::tableNumber(const std::string& name) const {
  const auto found = std::find_if(report.tables.begin(), report.tables.end(),
                                  [&name](const Table& table) { return table.name == name; });
  return found != report.tables.end() ? static_cast<std::size_t>(found - report.tables.begin()) + 1
                                      : 0;
}

std::string PageParts::page(const std::string& title, const std::string& lead,
                            const std::string& notes, bool withPlayer) const {
  std::string links;
  for (const auto& [id, name] : sections_) {
    links += "<a href=\"#" + id + "\">" + escaped(name) + "</a> ";
  }
  const std::string head = filled(
      kStudyText,
      {{"title", escaped(title)}, {"lead", escaped(lead)}, {"notes", notes}, {"links", links}});
  return htmlPage(title, head + body, withPlayer);
}

std::string verdictNotes(const std::string& headline, const std::vector<std::string>& warnings) {
  std::string notes =
      element("p", " class=\"verdict\"", element("b", "", escaped(headline))) + "\n";
  for (const std::string& warning : warnings) {
    notes += paragraph(warning, " class=\"warning\"");
  }
  return notes;
}

std::vector<std::string> withoutSeedEffectRemarks(const std::vector<std::string>& scenarios) {
  std::vector<std::string> remarks;
  remarks.reserve(scenarios.size());
  for (const std::string& scenario : scenarios) {
    remarks.push_back("In " + scenario +
                      " all seeds gave the same results, so its pairs are not independent: make "
                      "the runs depend on the seed (variation).");
  }
  return remarks;
}

}  // namespace report
