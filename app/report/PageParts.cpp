#include "app/report/PageParts.h"

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
  if (!table) {
    return;
  }
  report.tables.push_back(*table);
  body += tableHtml(*table, htmlClass);
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
