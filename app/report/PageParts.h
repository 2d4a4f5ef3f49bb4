#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "app/report/Page.h"

namespace report {

/// Sections, figures and tables of a page, in order; figures are numbered.
class PageParts {
 public:
  void section(const std::string& id, const std::string& title);
  void add(const std::optional<Figure>& figure);
  void add(const std::optional<Table>& table, const std::string& htmlClass = {});
  /// Title, a sentence below it, notes (markup) and links to the sections so far.
  std::string head(const std::string& title, const std::string& lead,
                   const std::string& notes) const;

  std::string body;  // markup
  Report report;     // its figures and tables are those added

 private:
  std::vector<std::pair<std::string, std::string>> sections_;  // id, title
};

}  // namespace report
