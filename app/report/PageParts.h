#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "app/report/Page.h"

namespace report {

/// Sections, figures and tables of a page, in order, each with its number.
class PageParts {
 public:
  void section(const std::string& id, const std::string& title);
  void add(const std::optional<Figure>& figure);
  void add(const std::optional<Table>& table, const std::string& htmlClass = {});
  /// Shows a part of the table that `report` keeps.
  void add(const Table& shown, Table all, const std::string& htmlClass = {});
  /// The number of the table with this name; 0: it was not added.
  std::size_t tableNumber(const std::string& name) const;
  /// The complete HTML page: title, a sentence below it, notes (markup), links to the sections,
  /// body. `withPlayer`: with the player script.
  std::string page(const std::string& title, const std::string& lead, const std::string& notes,
                   bool withPlayer = false) const;

  std::string body;  // markup
  Report report;     // its figures and tables are those added

 private:
  std::vector<std::pair<std::string, std::string>> sections_;  // id, title
};

/// Notes of a page: its verdict, then a warning each.
std::string verdictNotes(const std::string& headline, const std::vector<std::string>& warnings);
/// A remark on each of these scenarios: their runs have the same results with all seeds.
std::vector<std::string> withoutSeedEffectRemarks(const std::vector<std::string>& scenarios);

}  // namespace report
