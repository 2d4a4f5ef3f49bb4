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

std::string PageParts::head(const std::string& title, const std::string& lead,
                            const std::string& notes) const {
  std::string links;
  for (const auto& [id, name] : sections_) {
    links += "<a href=\"#" + id + "\">" + escaped(name) + "</a> ";
  }
  return filled(
      kStudyText,
      {{"title", escaped(title)}, {"lead", escaped(lead)}, {"notes", notes}, {"links", links}});
}

}  // namespace report
