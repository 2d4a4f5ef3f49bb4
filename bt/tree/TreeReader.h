#pragma once

#include <string>
#include <string_view>
#include <utility>

#include "bt/tree/TreeSpec.h"

namespace tinyxml2 {
class XMLElement;
}

namespace bt {

/// Turns the elements of one document into a TreeFile and gathers every problem on the way.
class TreeReader {
 public:
  explicit TreeReader(const std::string& fileName) { file_.path = fileName; }

  void readRoot(const tinyxml2::XMLElement& root);
  TreeFile takeFile() { return std::move(file_); }
  base::Diagnostics& problems() { return problems_; }

 private:
  void error(const tinyxml2::XMLElement& at, std::string_view code,
             base::ProblemValues values = {});
  void warn(const tinyxml2::XMLElement& at, std::string_view code, base::ProblemValues values = {});
  void readFormat(const tinyxml2::XMLElement& root);
  void readPart(const tinyxml2::XMLElement& element, bool needsId);
  void readInclude(const tinyxml2::XMLElement& element);
  void readTree(const tinyxml2::XMLElement& element, bool needsId);
  void readTreeAttributes(const tinyxml2::XMLElement& element, TreeSpec& tree);
  NodeSpec readNode(const tinyxml2::XMLElement& element, int depth);
  void readIdentity(const tinyxml2::XMLElement& element, NodeSpec& node);
  void readAttribute(const tinyxml2::XMLElement& element, const Attribute& attribute,
                     NodeSpec& node);
  void checkAttributes(const tinyxml2::XMLElement& element);
  void checkName(const tinyxml2::XMLElement& element, const std::string& name, const char* what);
  void lookForTemplate(const tinyxml2::XMLElement& element);

  TreeFile file_;
  base::Diagnostics problems_;
};

}  // namespace bt
